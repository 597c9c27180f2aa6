#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "io/mesh_builder.h"
#include "io/nastran_cards.h"
#include "io/node_tags.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {
namespace {

/// An element of first order. Nastran's node order is that of predicates/cells.h.
struct Kind {
  std::string_view name;
  int dimension;
  std::size_t n_nodes;
  mesh::CellType cell = mesh::CellType::Tetrahedron;
};

constexpr Kind kKinds[] = {
    {"CTRIA3", 2, 3},
    {"CTRIAR", 2, 3},
    {"CQUAD4", 2, 4},
    {"CQUADR", 2, 4},
    {"CTETRA", 3, 4, mesh::CellType::Tetrahedron},
    {"CPYRAM", 3, 5, mesh::CellType::Pyramid},
    {"CPYRA", 3, 5, mesh::CellType::Pyramid},
    {"CPENTA", 3, 6, mesh::CellType::Wedge},
    {"CHEXA", 3, 8, mesh::CellType::Hexahedron},
};

constexpr std::string_view kLines[] = {"CBAR", "CBEAM", "CBEND", "CONROD", "CROD", "CTUBE", "PLOTEL"};
constexpr std::string_view kHigherOrder[] = {"CQUAD", "CQUAD8", "CTRIA6"};

// Places in the fields behind a card's name.
constexpr std::size_t kProperty = 1, kFirstNode = 2, kFirstCoordinate = 2;

class NastranReader {
 public:
  NastranReader(std::string_view bytes, const std::string& file) : file_(file), cards_(bytes, file), builder_(file) {}

  VolumeFile read() {
    NastranCard card;
    while (cards_.next(card)) read_card(card);
    const FilePosition end = card.where;
    if (tags_.size() == 0) fail_at(end, "expected GRID cards somewhere in the file, found none");
    if (elements_.empty()) fail_at(end, "expected elements such as CTRIA3 somewhere in the file, found none");
    if (const auto twice = tags_.prepare()) fail_at(end, fmt::format("two GRID cards have the number {}", *twice));
    for (std::size_t i = 0; i < elements_.size(); ++i) add(i);
    return builder_.finish();
  }

 private:
  struct Element {
    const Kind* kind = nullptr;
    std::int64_t property = 0;
    std::size_t line = 0;
    std::array<std::int32_t, 8> nodes{};
  };

  void read_card(const NastranCard& card) {
    if (card.name == "GRID") return read_point(card);
    const auto* const kind = std::ranges::find(kKinds, card.name, &Kind::name);
    if (kind != std::end(kKinds)) return read_element(*kind, card);
    if (std::ranges::find(kLines, card.name) != std::end(kLines)) ++builder_.skipped().lines;
    if (std::ranges::find(kHigherOrder, card.name) != std::end(kHigherOrder)) fail_order(card);
    if (card.name == "GRDSET") require_basic_system(card);
    if (card.name.starts_with("INCLUDE")) {
      refuse(card, "INCLUDE of another file: put its lines in place of the statement");
    }
  }

  [[noreturn]] static void refuse(const NastranCard& card, std::string_view what) {
    throw InputError(fmt::format("{}:{}: {}", card.where.file, card.where.number, what));
  }

  [[noreturn]] static void fail_order(const NastranCard& card) {
    refuse(card, fmt::format("{} of higher order: save the mesh with elements of first order", card.name));
  }

  static std::string_view field(const NastranCard& card, std::size_t place) {
    return place < card.fields.size() ? card.fields[place] : std::string_view();
  }

  static void require_basic_system(const NastranCard& card) {
    const std::int64_t system = nastran_integer(field(card, 1), card.where, "a coordinate system");
    if (system != 0) {
      refuse(card, fmt::format("points in coordinate system {}: save the mesh in the basic system (0)", system));
    }
  }

  static std::int32_t number(const NastranCard& card, std::size_t place, std::string_view what) {
    constexpr std::int64_t kMost = 0x7fffffff;
    const std::int64_t value = nastran_integer(field(card, place), card.where, what);
    if (value < 1 || value > kMost) {
      fail_at(card.where, fmt::format("expected {}, found '{}'", what, quoted(field(card, place))));
    }
    return static_cast<std::int32_t>(value);
  }

  void read_point(const NastranCard& card) {
    tags_.add(number(card, 0, "the number of a point"));
    require_basic_system(card);
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] =
          nastran_real(field(card, kFirstCoordinate + static_cast<std::size_t>(axis)), card.where, "a coordinate");
    }
    builder_.add_point(p, card.where);
  }

  void read_element(const Kind& kind, const NastranCard& card) {
    Element element;
    element.kind = &kind;
    element.line = card.where.number;
    // An element without a property has that of its own number.
    element.property = number(card, field(card, kProperty).empty() ? 0 : kProperty, "the number of a property");
    for (std::size_t k = 0; k < kind.n_nodes; ++k) element.nodes[k] = number(card, kFirstNode + k, "a point");
    if (kind.dimension == 3) {
      for (std::size_t i = kFirstNode + kind.n_nodes; i < card.fields.size(); ++i) {
        if (!card.fields[i].empty()) fail_order(card);
      }
    }
    elements_.push_back(element);
  }

  void add(std::size_t i) {
    const Element& element = elements_[i];
    const FilePosition where{file_, false, element.line};
    std::array<std::int64_t, 8> nodes{};
    for (std::size_t k = 0; k < element.kind->n_nodes; ++k) {
      nodes[k] = tags_.find(element.nodes[k]);
      if (nodes[k] < 0) fail_at(where, fmt::format("expected a point with a GRID card, found {}", element.nodes[k]));
    }
    const std::span<const std::int64_t> used(nodes.data(), element.kind->n_nodes);
    const std::string name = cards_.name_of_property(element.property);
    if (element.kind->dimension == 2) {
      builder_.add_face(builder_.patch(name), used, where);
    } else {
      builder_.add_cell(element.kind->cell, used, i, name == kLayersGroup ? 1 : 0, where);
    }
  }

  std::string file_;
  NastranCards cards_;
  MeshBuilder builder_;
  NodeTags tags_;
  std::vector<Element> elements_;
};

}  // namespace

VolumeFile parse_nastran(std::string_view bytes, const std::string& file) { return NastranReader(bytes, file).read(); }

}  // namespace nearwall::io

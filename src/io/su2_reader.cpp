#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh_builder.h"
#include "io/surface_builder.h"
#include "io/volume_formats.h"
#include "io/vtk_cells.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

/// A line `KEY= value`, with or without blanks round the sign.
struct Keyword {
  std::string_view key;
  std::string_view value;  ///< the rest of the line without a comment
};

std::string_view first_word(std::string_view text) { return text.substr(0, text.find_first_of(" \t")); }

class Su2Reader {
 public:
  Su2Reader(std::string_view bytes, const std::string& file) : cursor_(bytes, file, '%'), builder_(file) {}

  VolumeFile read() {
    while (std::optional<Keyword> keyword = next_keyword()) read_section(*keyword);
    if (!has_points_) cursor_.fail("expected NPOIN= somewhere in the file, found none");
    if (!has_elements_) cursor_.fail("expected NELEM= somewhere in the file, found none");
    require_no_tag();
    if (n_markers_ < n_markers_claimed_) {
      cursor_.fail(fmt::format("NMARK= claims {} markers, the file holds {}", n_markers_claimed_, n_markers_));
    }
    use_surface_elements();
    return builder_.finish();
  }

 private:
  /// A triangle or quad among the elements.
  struct SurfaceElement {
    std::array<std::int64_t, 4> nodes{};
    std::size_t size = 0;
    std::size_t line = 0;
  };

  /// Nothing at the end of the file. Other lines are passed over where the keyword before is not one of ours: the
  /// numbers of boxes for deformation, of periodic boundaries, ….
  std::optional<Keyword> next_keyword() {
    for (;;) {
      const std::string_view word = cursor_.word();
      if (word.empty()) return {};
      const std::size_t begin = cursor_.offset() - word.size();
      cursor_.rest_of_line();
      const std::string_view line = cursor_.all().substr(begin, cursor_.offset() - begin);
      const std::string_view text = trimmed(line.substr(0, line.find('%')));
      const std::size_t sign = text.find('=');
      if (sign != std::string_view::npos) return Keyword{trimmed(text.substr(0, sign)), trimmed(text.substr(sign + 1))};
      if (!passes_lines_) cursor_.fail_expected("a keyword such as NELEM=, NPOIN= or MARKER_TAG=", word);
    }
  }

  void read_section(const Keyword& keyword) {
    passes_lines_ = false;
    if (keyword.key == "NDIME") {
      require_space(count_of(keyword, 0));
    } else if (keyword.key == "NZONE") {
      require_one_zone(count_of(keyword, 0));
    } else if (keyword.key == "NPOIN") {
      require_once(keyword, has_points_);
      read_points(count_of(keyword, kBytesOfPoint));
    } else if (keyword.key == "NELEM") {
      require_once(keyword, has_elements_);
      read_elements(count_of(keyword, kBytesOfElement));
    } else if (keyword.key == "NMARK") {
      n_markers_claimed_ = count_of(keyword, 0);
    } else if (keyword.key == "MARKER_TAG") {
      require_no_tag();
      if (keyword.value.empty()) cursor_.fail_expected("the name of a marker", {});
      tag_ = keyword.value;
    } else if (keyword.key == "MARKER_ELEMS") {
      read_marker(keyword);
    } else {
      passes_lines_ = true;
    }
  }

  /// \param bytes_each  that each of the things counted takes at least; 0: it counts no lines
  std::size_t count_of(const Keyword& keyword, std::size_t bytes_each) const {
    const std::string what = fmt::format("{}=", keyword.key);
    const std::int64_t claimed = cursor_.to_integer(first_word(keyword.value), what);
    if (bytes_each > 0) return cursor_.checked_count(claimed, what, bytes_each);
    if (claimed < 0) cursor_.fail_expected(fmt::format("{} (0 or more)", what), keyword.value);
    return static_cast<std::size_t>(claimed);
  }

  [[noreturn]] void refuse(std::string_view what) const {
    const FilePosition where = cursor_.position();
    throw InputError(fmt::format("{}:{}: {}", where.file, where.number, what));
  }

  void require_space(std::size_t dimension) {
    if (dimension == 2) refuse("a mesh in the plane (NDIME= 2), expected one in space (NDIME= 3)");
    if (dimension != 3) cursor_.fail(fmt::format("expected NDIME= 3, found {}", dimension));
    has_dimension_ = true;
  }

  void require_one_zone(std::size_t n_zones) const {
    if (n_zones > 1)
      refuse(fmt::format("the file has {} zones, expected one; write each to a file of its own", n_zones));
  }

  void require_once(const Keyword& keyword, bool& has) const {
    if (!has_dimension_) cursor_.fail(fmt::format("expected NDIME= before {}=", keyword.key));
    if (has) cursor_.fail(fmt::format("{}= stands twice", keyword.key));
    has = true;
  }

  void require_no_tag() const {
    if (!tag_.empty()) cursor_.fail(fmt::format("expected MARKER_ELEMS= of the marker '{}'", quoted(tag_)));
  }

  void go_to_line(std::string_view what, std::size_t i, std::size_t n) {
    if (!cursor_.next_line())
      cursor_.fail(fmt::format("expected {} {} of {}, found the end of the file", what, i + 1, n));
  }

  /// Numbers of points and elements may stand behind them.
  void pass_numbers(std::size_t most) {
    for (std::size_t n = 0; n <= most; ++n) {
      const std::string_view word = cursor_.word_of_line();
      if (word.empty()) return;
      if (n == most) cursor_.fail_expected("the end of the line", word);
      cursor_.to_integer(word, "a number of a point or element, or the end of the line");
    }
  }

  void read_points(std::size_t n) {
    builder_.expect_points(n);
    for (std::size_t i = 0; i < n; ++i) {
      go_to_line("point", i, n);
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = cursor_.to_number(cursor_.word_of_line(), "a coordinate");
      pass_numbers(2);
      builder_.add_point(p, cursor_.position());
    }
  }

  /// The nodes of the element at the cursor, behind its type, in the order of predicates/cells.h.
  std::array<std::int64_t, 8> nodes_of(const VtkCellMeaning& meaning) {
    std::array<std::int64_t, 8> nodes{};
    for (std::size_t k = 0; k < meaning.size; ++k) {
      const std::int64_t node = cursor_.to_integer(cursor_.word_of_line(), "the number of a point");
      nodes[meaning.use == VtkCellMeaning::Use::Cell ? meaning.node[k] : k] = node;
    }
    pass_numbers(1);
    return nodes;
  }

  /// What the code of an element or face at the cursor means. \throws InputError  if it is none of SU2's
  const VtkCellMeaning& read_type() {
    const std::int64_t code = cursor_.to_integer(cursor_.word_of_line(), "the type of an element");
    for (const std::int64_t known : {1, 3, 5, 9, 10, 12, 13, 14}) {
      if (code == known) return kVtkMeanings[static_cast<std::size_t>(code)];
    }
    refuse(
        fmt::format("an element of type {}; read are tetrahedra (10), hexahedra (12), wedges (13), pyramids (14), "
                    "triangles (5) and quads (9); write the mesh with linear elements",
                    code));
  }

  void read_elements(std::size_t n) {
    builder_.expect_cells(n, 4 * n);
    for (std::size_t i = 0; i < n; ++i) {
      go_to_line("element", i, n);
      const VtkCellMeaning& meaning = read_type();
      const std::array<std::int64_t, 8> nodes = nodes_of(meaning);
      if (meaning.use == VtkCellMeaning::Use::Cell) {
        builder_.add_cell(meaning.type, nodes, i, 0, cursor_.position());
        has_cells_ = true;
      } else if (meaning.use == VtkCellMeaning::Use::SkippedFace) {
        surface_.push_back({{nodes[0], nodes[1], nodes[2], nodes[3]}, meaning.size, cursor_.position().number});
      } else {
        pass_over(meaning);
      }
    }
  }

  void pass_over(const VtkCellMeaning& meaning) {
    ++(meaning.use == VtkCellMeaning::Use::SkippedLine ? builder_.skipped().lines : builder_.skipped().points);
  }

  void read_marker(const Keyword& keyword) {
    if (tag_.empty()) cursor_.fail("expected MARKER_TAG= before MARKER_ELEMS=");
    const std::size_t n = count_of(keyword, kBytesOfElement);
    const std::string_view tag = std::exchange(tag_, {});
    ++n_markers_;
    if (tag == "SEND_RECEIVE") {  // what older files of parts of meshes tell each other
      passes_lines_ = true;
      return;
    }
    const PatchId patch = builder_.patch(tag);
    for (std::size_t i = 0; i < n; ++i) {
      go_to_line("face", i, n);
      const VtkCellMeaning& meaning = read_type();
      if (meaning.use == VtkCellMeaning::Use::Cell) cursor_.fail("expected a triangle (5) or a quad (9), found a cell");
      const std::array<std::int64_t, 8> nodes = nodes_of(meaning);
      if (meaning.use == VtkCellMeaning::Use::SkippedFace) {
        builder_.add_face(patch, std::span(nodes).first(meaning.size), cursor_.position());
        has_faces_ = true;
      } else {
        pass_over(meaning);
      }
    }
  }

  /// Triangles and quads among the elements: the surface of a file that has no other.
  void use_surface_elements() {
    if (has_cells_ || has_faces_) {
      builder_.skipped().faces += surface_.size();
      return;
    }
    for (const SurfaceElement& element : surface_) {
      builder_.add_face(builder_.patch(kNamelessPatch), std::span(element.nodes).first(element.size),
                        {cursor_.file(), false, element.line});
    }
  }

  static constexpr std::size_t kBytesOfPoint = 6;    // "0 0 0\n"
  static constexpr std::size_t kBytesOfElement = 4;  // "1 0\n"

  Cursor cursor_;
  MeshBuilder builder_;
  bool has_dimension_ = false;
  bool has_points_ = false;
  bool has_elements_ = false;
  bool has_cells_ = false;
  bool has_faces_ = false;
  bool passes_lines_ = false;
  std::size_t n_markers_claimed_ = 0;
  std::size_t n_markers_ = 0;
  std::string_view tag_;  // of a marker whose faces come next; else empty
  std::vector<SurfaceElement> surface_;
};

}  // namespace

VolumeFile parse_su2(std::string_view bytes, const std::string& file) { return Su2Reader(bytes, file).read(); }

}  // namespace nearwall::io

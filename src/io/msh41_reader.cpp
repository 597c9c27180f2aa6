#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "io/msh_input.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kTag = sizeof(std::int32_t), kNumber = sizeof(std::uint64_t);
constexpr std::size_t kShortestWord = 2;  // a digit and a blank

std::size_t count_of_words(MshInput& in, std::string_view what, std::size_t bytes_in_binary) {
  return in.count(what, kShortestWord, bytes_in_binary);
}

/// The first of the tags that follow their number, 0 if there is none. A minus turns the orientation.
std::int64_t first_of_tags(MshInput& in, std::string_view what) {
  const std::size_t n = count_of_words(in, what, kTag);
  std::int64_t first = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t tag = std::abs(in.tag("a tag"));
    if (i == 0) first = tag;
  }
  return first;
}

void read_entities(MshInput& in, bool are_parts, MshEntities& entities) {
  std::array<std::size_t, 4> n;
  for (std::size_t& count : n)
    count = in.count("the number of entities", 5 * kShortestWord, kTag + 3 * sizeof(double) + kNumber);
  for (int dimension = 0; dimension <= 3; ++dimension) {
    for (std::size_t i = 0; i < n[static_cast<std::size_t>(dimension)]; ++i) {
      const std::int64_t tag = in.tag("the tag of an entity");
      MshEntity entity{0, tag};
      if (are_parts) {
        const bool is_part_of_alike = in.tag("the dimension of the parent") == dimension;
        const std::int64_t parent = in.tag("the tag of the parent");
        if (is_part_of_alike) entity.tag = parent;
        first_of_tags(in, "the number of parts");
      }
      in.point();
      if (dimension > 0) in.point();  // a box has two
      entity.physical = first_of_tags(in, "the number of physical groups");
      entities[{dimension, tag}] = entity;
      if (dimension > 0) first_of_tags(in, "the number of entities that bound it");
    }
  }
}

/// The numbers at the head of $Nodes and $Elements.
struct Totals {
  std::size_t n_blocks = 0;
  std::size_t n = 0;
};

Totals read_totals(MshInput& in, std::size_t bytes_in_text, std::size_t bytes_in_binary) {
  Totals totals;
  totals.n_blocks = in.count("the number of blocks", 4 * kShortestWord, 3 * kTag + kNumber);
  totals.n = in.count("the number of nodes or elements", bytes_in_text, bytes_in_binary);
  in.number("the smallest number");
  in.number("the largest number");
  return totals;
}

/// A block whose entity has that many nodes or elements, of those that are left.
std::size_t length_of_block(MshInput& in, std::size_t n_left) {
  const std::int64_t n = in.number("the length of a block");
  if (static_cast<std::uint64_t>(n) > n_left) {
    in.cursor().fail(fmt::format("a block holds {}, but by the head of the section only {} are left", n, n_left));
  }
  return static_cast<std::size_t>(n);
}

void require_none_left(MshInput& in, std::size_t n_left) {
  if (n_left > 0) in.cursor().fail(fmt::format("the blocks hold {} fewer than the head of the section says", n_left));
}

}  // namespace

void read_msh41_entities(MshInput& in, MshEntities& entities) {
  read_entities(in, false, entities);
  in.end_section("Entities");
}

void read_msh41_partitioned_entities(MshInput& in, MshEntities& entities) {
  in.number("the number of parts");
  const std::size_t n_ghosts = in.count("the number of ghost entities", 2 * kShortestWord, 2 * kTag);
  for (std::size_t i = 0; i < 2 * n_ghosts; ++i) in.tag("a ghost entity");
  read_entities(in, true, entities);
  in.end_section("PartitionedEntities");
}

void read_msh41_nodes(MshInput& in, MshContent& content) {
  const Totals totals = read_totals(in, 4 * kShortestWord, kNumber + 3 * sizeof(double));
  content.builder().expect_points(totals.n);
  std::size_t n_left = totals.n;
  for (std::size_t block = 0; block < totals.n_blocks; ++block) {
    const std::int64_t dimension = in.tag("the dimension of an entity");
    if (dimension < 0 || dimension > 3) in.cursor().fail(fmt::format("{} is no dimension of an entity", dimension));
    in.tag("the tag of an entity");
    const std::int64_t n_parameters = in.tag("0 or 1 for parameters") != 0 ? dimension : 0;
    const std::size_t n = length_of_block(in, n_left);
    for (std::size_t i = 0; i < n; ++i) content.add_tag(in.number("the number of a node"));
    for (std::size_t i = 0; i < n; ++i) {
      content.builder().add_point(in.point(), in.cursor().position());
      for (std::int64_t k = 0; k < n_parameters; ++k) in.real("a parameter");
    }
    n_left -= n;
  }
  require_none_left(in, n_left);
  content.end_nodes(in.cursor().position());
  in.end_section("Nodes");
}

void read_msh41_elements(MshInput& in, const MshEntities& entities, MshContent& content) {
  const Totals totals = read_totals(in, 2 * kShortestWord, 2 * kNumber);
  content.builder().expect_cells(totals.n, 0);
  std::size_t n_left = totals.n;
  for (std::size_t block = 0; block < totals.n_blocks; ++block) {
    const std::int64_t dimension = in.tag("the dimension of an entity");
    const std::int64_t tag = in.tag("the tag of an entity");
    const MshElement element = content.element(in.tag("the type of elements"));
    if (element.dimension != dimension) {
      in.cursor().fail(
          fmt::format("elements of dimension {} in an entity of dimension {}", element.dimension, dimension));
    }
    const std::size_t n = length_of_block(in, n_left);
    const auto found = entities.find({element.dimension, tag});
    const MshEntity entity = found == entities.end() ? MshEntity{0, tag} : found->second;
    const MshGroup group = content.group(element.dimension, entity.physical, entity.tag);
    std::array<std::int64_t, 8> nodes;
    for (std::size_t i = 0; i < n; ++i) {
      in.number("the number of an element");
      for (std::size_t k = 0; k < element.n_nodes; ++k) nodes[k] = in.number("a node");
      content.add_element(element, group, {nodes.data(), element.n_nodes}, in.cursor().position());
    }
    n_left -= n;
  }
  require_none_left(in, n_left);
  in.end_section("Elements");
}

}  // namespace nearwall::io

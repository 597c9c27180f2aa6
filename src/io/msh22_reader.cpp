#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "io/msh_input.h"

namespace nearwall::io {
namespace {

/// Elements of one type with one set of tags, as they follow each other. Groups are looked up only where they change.
class Msh22Elements {
 public:
  Msh22Elements(MshInput& in, MshContent& content) : in_(in), content_(content) {}

  void read(std::size_t n) {
    while (n > 0) {
      if (!in_.is_binary()) in_.tag("the number of an element");
      const MshElement element = content_.element(in_.tag("the type of an element"));
      const std::size_t n_alike = in_.is_binary() ? length_of_run(n) : 1;
      const std::size_t n_tags = in_.cursor().checked_count(in_.tag("the number of tags"), "the number of tags",
                                                            in_.is_binary() ? sizeof(std::int32_t) : 2);
      for (std::size_t i = 0; i < n_alike; ++i) read_element(element, n_tags);
      n -= n_alike;
    }
  }

 private:
  std::size_t length_of_run(std::size_t n_left) {
    const std::int64_t n = in_.tag("the number of elements that follow");
    if (n < 1 || static_cast<std::uint64_t>(n) > n_left) {
      in_.cursor().fail(fmt::format("expected 1 to {} elements of this type, found {}", n_left, n));
    }
    return static_cast<std::size_t>(n);
  }

  void read_element(const MshElement& element, std::size_t n_tags) {
    if (in_.is_binary()) in_.tag("the number of an element");
    std::array<std::int64_t, 2> tags{};  // physical group, entity
    for (std::size_t i = 0; i < n_tags; ++i) {
      const std::int64_t tag = in_.tag("a tag");
      if (i < tags.size()) tags[i] = std::abs(tag);  // a minus turns the orientation
    }
    if (tags != tags_ || element.dimension != dimension_) {
      tags_ = tags;
      dimension_ = element.dimension;
      group_ = content_.group(dimension_, tags[0], tags[1]);
    }
    std::array<std::int64_t, 8> nodes;
    for (std::size_t k = 0; k < element.n_nodes; ++k) nodes[k] = in_.tag("a node");
    content_.add_element(element, group_, {nodes.data(), element.n_nodes}, in_.cursor().position());
  }

  MshInput& in_;
  MshContent& content_;
  int dimension_ = -1;
  std::array<std::int64_t, 2> tags_{};
  MshGroup group_;
};

/// Counts are text in version 2, also in binary files.
std::size_t text_count(MshInput& in, std::string_view what, std::size_t bytes_in_text, std::size_t bytes_in_binary) {
  const std::size_t n = in.cursor().count(what, in.is_binary() ? bytes_in_binary : bytes_in_text);
  if (in.is_binary()) in.cursor().pass_line_end();
  return n;
}

}  // namespace

void read_msh22_nodes(MshInput& in, MshContent& content) {
  constexpr std::size_t kText = sizeof("1 0 0 0") - 1, kBinary = sizeof(std::int32_t) + 3 * sizeof(double);
  const std::size_t n = text_count(in, "the number of nodes", kText, kBinary);
  content.builder().expect_points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t tag = in.tag("the number of a node");
    if (tag < 0) in.cursor().fail(fmt::format("expected the number of a node, found {}", tag));
    content.add_tag(tag);
    content.builder().add_point(in.point(), in.cursor().position());
  }
  content.end_nodes(in.cursor().position());
  in.end_section("Nodes");
}

void read_msh22_elements(MshInput& in, MshContent& content) {
  constexpr std::size_t kText = sizeof("1 15 0 1") - 1, kBinary = 2 * sizeof(std::int32_t);
  const std::size_t n = text_count(in, "the number of elements", kText, kBinary);
  content.builder().expect_cells(n, 0);
  Msh22Elements(in, content).read(n);
  in.end_section("Elements");
}

}  // namespace nearwall::io

#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace nearwall::io {

/// Which point of a file has a number, for formats whose numbers are any: they may have gaps and any order.
class NodeTags {
 public:
  /// The number of the next point, at least 0.
  void add(std::int64_t tag) { tags_.push_back(tag); }
  std::size_t size() const { return tags_.size(); }

  /// Call when all are added, before `find`. \returns  a number that two points have, if there is one
  /// Memory: 8 bytes a point; for numbers that do not follow each other 4 to 16 more
  std::optional<std::int64_t> prepare();

  /// The point with that number, from 0; −1: none.
  std::int64_t find(std::int64_t tag) const;

 private:
  bool are_consecutive() const;
  std::optional<std::int64_t> make_table();
  std::optional<std::int64_t> sort();

  std::vector<std::int64_t> tags_;
  bool is_consecutive_ = false;
  std::int64_t first_ = 0;
  std::vector<std::uint32_t> table_;                            // point + 1 by tag − first_; 0: none
  std::vector<std::pair<std::int64_t, std::uint32_t>> sorted_;  // tag and point, where a table would have large gaps
};

}  // namespace nearwall::io

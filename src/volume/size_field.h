#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"

namespace nearwall::volume {

/// A wanted length at a point.
struct SizeSource {
  Vec3 point;
  double size = 0;
};

/// Mean length of the edges at each point of a triangulation in which each edge has two triangles.
std::vector<SizeSource> sizes_of_edges(std::span<const Vec3> points,
                                       std::span<const std::array<std::uint32_t, 3>> triangles);

/// Wanted edge lengths that grow with the distance from sources: the least of size + slope · distance over all sources,
/// at most `largest`. Source: docs/theory/fill.md, Eq. (1).
class SizeField {
 public:
  SizeField(std::vector<SizeSource> sources, double slope, double largest);

  /// To a hundredth: never less than the true value, at most 1 % more. The same bits for the same point.
  /// Cost: O(log n_sources).
  double at(const Vec3& x) const;

  /// Whether the value is less than a limit: exactly, and quicker than `at`.
  bool is_under(const Vec3& x, double limit) const;

 private:
  /// Sources [begin, end): a box round them and the least of their sizes.
  struct Node {
    Vec3 low, high;
    double least = 0;
    std::uint32_t begin = 0, end = 0;
    std::uint32_t second = 0;  ///< the other half; the first one is the next node; 0: a leaf
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  /// Calls `take(size)` for sources of the parts of the tree whose least size `is_worth` it, till it returns false.
  template <class Worth, class Take>
  void search(const Vec3& x, Worth&& is_worth, Take&& take) const;
  double lower_bound(const Node& node, const Vec3& x) const;

  std::vector<SizeSource> sources_;
  std::vector<Node> nodes_;
  double slope_, largest_;
};

}  // namespace nearwall::volume

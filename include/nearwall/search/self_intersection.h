#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "nearwall/core/vec3.h"

namespace nearwall::search {

/// A triangle soup that knows which corners are one node: triangles that share a node number share the point.
struct IndexedTriangles {
  std::span<const Vec3> points;                             ///< (n_points)
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< (n_triangles), indices into points
};

/// All pairs (i < j) of triangles that meet elsewhere than in the corners and edges they share by index. Exact. Pairs
/// sorted. Corners that are equal in coordinates only are not shared: such triangles meet, as do those of the same
/// three corners. Boxes on a tree first, then predicates/intersection.h. \param moved  if not empty (n_triangles): only
/// pairs in which at least one triangle is marked are looked at \throws InputError if a coordinate is not finite. Cost:
/// O(n log n + pairs of boxes), on all threads.
std::vector<std::pair<std::uint32_t, std::uint32_t>> self_intersections(const IndexedTriangles& soup,
                                                                        std::span<const char> moved = {});

}  // namespace nearwall::search

#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "nearwall/planar/point2.h"

namespace nearwall::planar {

/// All pairs (i < j) of edges that meet elsewhere than in end points they share by number: that cross, touch, or
/// overlap, also where they begin in the same point; the same edge twice in the same direction. Points that are equal
/// in coordinates only are not shared: edges that end in them meet. An edge given once in each direction is a slit, no
/// pair. An edge i without length is reported as the pair (i, i), beside those it is part of. Exact. Pairs sorted.
/// \param points  (n_points); those that no edge uses do not matter
/// \param edges   (n_edges), 0-based numbers of points
/// \throws InputError  if a coordinate is not finite or an edge names a point that does not exist.
/// Cost: O(n log n + pairs of boxes that overlap).
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_edges(std::span<const Point2> points,
                                                                    std::span<const Edge> edges);

}  // namespace nearwall::planar

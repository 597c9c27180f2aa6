#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nearwall::studies {

struct Point2 {
  double x = 0;
  double y = 0;
};

/// Corners of a triangle of the plane, counterclockwise, 0-based.
using Triangle2 = std::array<std::uint32_t, 3>;

/// Delaunay triangulation of distinct points; its triangles cover their convex hull. Cost: O(n log n).
std::vector<Triangle2> delaunay(std::span<const Point2> points);

/// The same for points that repeat with the given periods in x and y: the triangles of one period, n points having 2 n
/// of them. Corners may belong to different copies of their points.
/// \param points  in [0, period), more than a few and spread all over
std::vector<Triangle2> periodic_delaunay(std::span<const Point2> points, const Point2& period);

}  // namespace nearwall::studies

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace nearwall::shapes {

struct Point2 {
  double u = 0;
  double v = 0;
};

/// A triangulation of a region of the plane. Nodes are numbered: the points of the loops, loop after loop, then
/// `interior`.
struct PlanarFill {
  std::vector<Point2> interior;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise
};

/// Triangulates the region bounded by closed polygons (one outer, any number of holes, in either sense), whose edges
/// are kept as they are: Delaunay refinement that adds points inside only, then smoothing. Triangles are
/// near-equilateral of `size`, smaller where the boundary's edges are shorter, and grow from there at a bounded rate.
/// Loops must not touch or cross. Cost: O(n log n), times the number of short edges of the boundary.
PlanarFill fill_region(const std::vector<std::vector<Point2>>& loops, double size);

}  // namespace nearwall::shapes

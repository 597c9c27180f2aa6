#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nearwall/planar/point2.h"

namespace nearwall::shapes {

using planar::Point2;

/// A triangulation of a region of the plane. Nodes are numbered: the points of the loops, loop after loop, then
/// `interior`.
struct PlanarFill {
  std::vector<Point2> interior;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise
};

/// Triangulates the region bounded by closed polygons (one outer, any number of holes, in either sense), whose edges
/// are kept as they are (planar/region.h). Triangles are near-equilateral of `size`, smaller where the boundary's edges
/// are shorter, and grow from there at a bounded rate. \throws InputError  if loops touch or cross. Cost: O(n log n).
PlanarFill fill_region(const std::vector<std::vector<Point2>>& loops, double size);

}  // namespace nearwall::shapes

#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "nearwall/planar/point2.h"

namespace nearwall::planar {

// A region of the plane is given by directed edges: it lies to the left of each. It may have several components, loops
// within loops, and slits (edges given in both directions, both sides of which belong to it). Points that no edge uses
// are ignored.

struct RegionTriangulation {
  std::vector<Triangle> triangles;  ///< counterclockwise; none if there are contradictions
  /// Numbers of edges whose sides contradict others, ascending: the outside of everything lies to their left, or the
  /// part of the plane to their right lies to the left of another edge, as with two nested loops in the same direction
  /// and with chains of edges that do not close.
  std::vector<std::uint32_t> contradicting_edges;
};

/// Constrained Delaunay triangulation of a region: no points are added, and each edge is one of a triangle to its left.
/// \param points  (n_points)     \param edges  (n_edges), 0-based numbers of points; fastest in the order of the loops
/// \throws InputError  if edges meet elsewhere than in common end points (crossing_edges.h), a coordinate is not
/// finite,
///                     or an edge names a point that does not exist. Cost: O(n log n) for common input.
RegionTriangulation triangulate_region(std::span<const Point2> points, std::span<const Edge> edges);

struct RefinedRegion {
  std::vector<Point2> points;       ///< the given ones, bit for bit, then those added
  std::vector<Triangle> triangles;  ///< counterclockwise by exact sign
};

/// The edge length wanted at a place; see GradedSize (size_field.h).
using SizeFunction = std::function<double(const Point2&)>;

/// Triangulates a region with triangles as large as a size function asks. The edges given are never split: points are
/// added inside only, at circumcentres of triangles that are too large (worst first), where they have room beside the
/// edges and the other points, relative to the size wanted there; which is why this ends. Then they are smoothed. With
/// sizes graded from the edges, angles are well above 25 degrees but where edges force others.
/// \param size  > 0 and finite at each place of the region; as many triangles are made as it asks for
/// \throws InputError  as triangulate_region, if edges contradict each other, or if a size is not positive.
/// Cost: O(n log n) and about four calls of `size` for each triangle. Source: for the order of the points L. P. Chew,
/// Guaranteed-quality mesh generation for curved surfaces, 1993, with sizes in place of his constants.
RefinedRegion refine_region(std::span<const Point2> points, std::span<const Edge> edges, const SizeFunction& size);

}  // namespace nearwall::planar

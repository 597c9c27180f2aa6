#pragma once

#include <array>
#include <span>
#include <vector>

#include "studies/delaunay.h"
#include "studies/jet.h"

namespace nearwall::studies {

/// What is known of a function on a triangle of the plane.
struct HermiteTriangle {
  std::array<Point2, 3> corner;
  std::array<double, 3> value;
  std::array<Point2, 3> gradient;
};

/// The Clough-Tocher interpolant at a point of the triangle: three cubics that meet at the centroid, with a derivative
/// across each side that is linear along it. C1 over a triangulation. Quadratics are reproduced.
/// Source: Clough & Tocher 1965; docs/theory/normal-studies.md
Jet clough_tocher(const HermiteTriangle& triangle, const Point2& p);

/// Where the sides of a triangle are cut in two and where the six parts meet.
struct PowellSabinSplit {
  Point2 centre;                 ///< the incentre
  std::array<double, 3> weight;  ///< side k is cut at weight corner k + (1 - weight) corner k + 1
};

/// Cuts for all triangles: sides between two triangles where the line joining their incentres crosses, those on the
/// boundary in the middle. Cost: O(n log n).
std::vector<PowellSabinSplit> powell_sabin_splits(std::span<const Point2> points, std::span<const Triangle2> triangles);

/// The Powell-Sabin interpolant at a point of the triangle: six quadratics. C1 over a triangulation that is split by
/// `powell_sabin_splits`. Quadratics are reproduced. Source: Powell & Sabin 1977
Jet powell_sabin(const HermiteTriangle& triangle, const PowellSabinSplit& split, const Point2& p);

}  // namespace nearwall::studies

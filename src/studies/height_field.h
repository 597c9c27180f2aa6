#pragma once

#include <cstdint>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"
#include "studies/delaunay.h"
#include "studies/jet.h"

namespace nearwall::studies {

/// A test function at random points of the unit square.
struct HeightField {
  std::vector<Point2> points;
  std::vector<Triangle2> triangles;  ///< Delaunay; they cover the convex hull
  std::vector<Jet> truth;            ///< (n_points) value and derivatives of the function
};

/// \param function  number of the test function    \param seed  other points for each seed, function and number
HeightField height_field(int function, std::size_t n_points, std::uint64_t seed);

/// The triangles without those along the boundary that have a corner wider than `widest` [rad] in the plane, and those
/// that come to lie on the boundary then. No vertex loses its last triangle, no boundary touches itself.
std::vector<Triangle2> without_thin_boundary(const std::vector<Point2>& points, const std::vector<Triangle2>& triangles,
                                             double widest);

/// The graph of a height field over some of its triangles, ready for normals.
struct Graph {
  Graph(const HeightField& field, const std::vector<Triangle2>& triangles);

  mesh::SurfaceMesh mesh;
  mesh::Topology topology;
  surface::Features features;
};

/// A place of the hull, with the triangle it lies in.
struct Place {
  std::size_t triangle;
  Point2 point;
};

/// Places that are uniform in the hull.
std::vector<Place> random_places(const HeightField& field, std::size_t n, std::uint64_t seed);

}  // namespace nearwall::studies

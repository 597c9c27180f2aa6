#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/planar/point2.h"

namespace nearwall::planar {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct VertexInfo {
  std::uint32_t number = 0;  ///< of the point
  double size = 0;           ///< edge length wanted there, once it is known
};

struct FaceInfo {
  std::uint32_t part = 0;   ///< the part of the plane it belongs to, 0: none yet; parts end at the edges given
  bool is_inside = false;   ///< belongs to the region
  bool is_settled = false;  ///< refinement has looked at it
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using ConstrainedDelaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// A region given by directed edges (region.h), triangulated.
struct ConstrainedRegion {
  ConstrainedDelaunay triangulation;               ///< its faces know whether they are inside the region
  std::vector<std::uint32_t> contradicting_edges;  ///< then no face is inside

  /// \throws InputError  as triangulate_region.
  ConstrainedRegion(std::span<const Point2> points, std::span<const Edge> edges);

  /// Corners of the faces inside, counterclockwise.
  std::vector<Triangle> triangles() const;
};

}  // namespace nearwall::planar

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <utility>

#include "studies/delaunay.h"

namespace nearwall::studies {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

}  // namespace

std::vector<Triangle2> delaunay(std::span<const Point2> points) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> numbered;
  for (std::uint32_t i = 0; i < points.size(); ++i) numbered.emplace_back(Kernel::Point_2(points[i].x, points[i].y), i);
  const Triangulation triangulation(numbered.begin(), numbered.end());

  std::vector<Triangle2> triangles;
  for (const auto face : triangulation.finite_face_handles()) {
    Triangle2 t = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  // The order in which CGAL keeps its faces is its own affair.
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace nearwall::studies

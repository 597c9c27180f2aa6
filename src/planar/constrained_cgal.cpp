#include "planar/constrained_cgal.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/planar/crossing_edges.h"
#include "nearwall/planar/region.h"

namespace nearwall::planar {
namespace {

using Face = ConstrainedDelaunay::Face_handle;
using Vertex = ConstrainedDelaunay::Vertex_handle;

void check_crossings(std::span<const Point2> points, std::span<const Edge> edges) {
  const auto crossings = crossing_edges(points, edges);
  if (crossings.empty()) return;
  const auto [i, j] = crossings.front();
  const Point2& place = points[edges[i][0]];
  throw InputError(
      fmt::format("triangulation of a region: expected edges that meet in common end points only, found {} pairs that "
                  "do not, first "
                  "edges {} and {} at ({}, {})",
                  crossings.size(), i, j, place.u, place.v));
}

void insert_edges(ConstrainedDelaunay& t, std::span<const Point2> points, std::span<const Edge> edges) {
  std::vector<Vertex> vertices(points.size());
  Face hint;
  for (const Edge& edge : edges) {
    for (const std::uint32_t i : edge) {
      if (vertices[i] != Vertex()) continue;
      vertices[i] = t.insert(ConstrainedDelaunay::Point(points[i].u, points[i].v), hint);
      vertices[i]->info().number = i;
      hint = vertices[i]->face();
    }
  }
  for (const auto& [a, b] : edges) t.insert_constraint(vertices[a], vertices[b]);
}

/// Numbers the parts of the plane, from 1; that of the infinite faces is 1. \returns how many there are
std::uint32_t number_parts(ConstrainedDelaunay& t) {
  std::uint32_t n_parts = 0;
  std::vector<Face> stack;
  const auto flood = [&](Face seed) {
    ++n_parts;
    seed->info().part = n_parts;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face g = f->neighbor(i);
        if (f->is_constrained(i) || g->info().part != 0) continue;
        g->info().part = n_parts;
        stack.push_back(g);
      }
    }
  };
  flood(t.infinite_face());
  for (const Face f : t.finite_face_handles()) {
    if (f->info().part == 0) flood(f);
  }
  return n_parts;
}

/// The parts to the left and right of each edge.
std::vector<std::pair<std::uint32_t, std::uint32_t>> sides(const ConstrainedDelaunay& t, std::span<const Edge> edges) {
  std::map<Edge, std::uint32_t> part_left_of;
  for (const auto& [f, i] : t.finite_edges()) {
    if (!f->is_constrained(i)) continue;
    const std::uint32_t a = f->vertex(t.ccw(i))->info().number, b = f->vertex(t.cw(i))->info().number;
    part_left_of[{a, b}] = f->info().part;
    part_left_of[{b, a}] = f->neighbor(i)->info().part;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const auto& [a, b] : edges) result.push_back({part_left_of.at({a, b}), part_left_of.at({b, a})});
  return result;
}

}  // namespace

ConstrainedRegion::ConstrainedRegion(std::span<const Point2> points, std::span<const Edge> edges) {
  check_crossings(points, edges);
  ConstrainedDelaunay& t = triangulation;
  insert_edges(t, points, edges);
  if (t.dimension() < 2) {
    // All on a line: no part of the plane is bounded.
    for (std::uint32_t i = 0; i < edges.size(); ++i) contradicting_edges.push_back(i);
    return;
  }

  constexpr std::uint32_t kOutside = 1;
  const std::uint32_t n_parts = number_parts(t);
  const auto sides_of = sides(t, edges);
  std::vector<char> is_left(n_parts + 1, 0);
  for (const auto& [left, right] : sides_of) is_left[left] = 1;
  std::vector<Edge> sorted(edges.begin(), edges.end());
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const auto [left, right] = sides_of[i];
    const bool is_slit = std::binary_search(sorted.begin(), sorted.end(), Edge{edges[i][1], edges[i][0]});
    const bool right_is_inside = right != kOutside && is_left[right] && !is_slit;
    if (left == kOutside || right_is_inside) contradicting_edges.push_back(i);
  }
  if (!contradicting_edges.empty()) return;
  for (const Face f : t.finite_face_handles()) f->info().is_inside = is_left[f->info().part];
}

std::vector<Triangle> ConstrainedRegion::triangles() const {
  std::vector<Triangle> result;
  for (const Face f : triangulation.finite_face_handles()) {
    if (!f->info().is_inside) continue;
    result.push_back({f->vertex(0)->info().number, f->vertex(1)->info().number, f->vertex(2)->info().number});
  }
  return result;
}

RegionTriangulation triangulate_region(std::span<const Point2> points, std::span<const Edge> edges) {
  const ConstrainedRegion region(points, edges);
  return {region.triangles(), region.contradicting_edges};
}

}  // namespace nearwall::planar

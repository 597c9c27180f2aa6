#include "surface/checks.h"

#include <algorithm>
#include <array>
#include <optional>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/orientation.h"
#include "nearwall/search/self_intersection.h"
#include "surface/face_groups.h"

namespace nearwall::surface {
namespace {

Vec3 centroid(const mesh::SurfaceMesh& surface, FaceId f) {
  const auto [a, b, c] = surface.triangle(f);
  return (a + b + c) / 3;
}

/// Coordinates up to here, and surfaces down to the inverse, leave room in a double for the cubes of lengths (volumes)
/// and squares of areas that layers, certificate and report are computed with.
constexpr double kLargestCoordinate = 0x1p+210;

/// What keeps a point from being computed with. \param largest  coordinate of the whole surface
std::optional<FaultKind> coordinate_fault(const Vec3& p, double largest) {
  if (!is_finite(p)) return FaultKind::NotFinite;
  const bool is_speck = largest > 0 && largest < 1.0 / kLargestCoordinate;
  if (is_speck || max_norm(p) > kLargestCoordinate) return FaultKind::OutOfRange;
  return std::nullopt;
}

double largest_coordinate(const mesh::SurfaceMesh& surface) {
  double largest = 0;
  for (const Vec3& p : surface.points) {
    if (is_finite(p)) largest = std::max(largest, max_norm(p));
  }
  return largest;
}

void check_coordinates(const mesh::SurfaceMesh& surface, LeftOut& left_out, FaultCollector& faults) {
  const double largest = largest_coordinate(surface);
  std::vector<VertexId> points;
  std::vector<std::vector<FaceId>> faces_of_point;
  IdVector<VertexId, std::size_t> number(surface.points.size(), 0);  // 1 + position in faces_of_point
  for (const FaceId f : surface.faces.ids()) {
    for (const VertexId v : surface.faces[f]) {
      if (!coordinate_fault(surface.points[v], largest)) continue;
      if (number[v] == 0) {
        points.push_back(v);
        faces_of_point.emplace_back();
        number[v] = faces_of_point.size();
      }
      faces_of_point[number[v] - 1].push_back(f);
      left_out.of_geometry[f.index()] = 1;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& faces = faces_of_point[i];
    std::optional<Vec3> near;
    if (is_finite(surface.points[points[i]])) near = surface.points[points[i]];
    // A point without a place: a finite corner of one of its triangles stands for it.
    for (const FaceId f : faces) {
      for (const Vec3& p : surface.triangle(f)) {
        if (!near && is_finite(p)) near = p;
      }
    }
    faults.add(*coordinate_fault(surface.points[points[i]], largest), near, faces);
  }
}

void check_areas(const mesh::SurfaceMesh& surface, LeftOut& left_out, FaultCollector& faults) {
  std::vector<char> is_flat(surface.faces.size(), 0);
  parallel_for(is_flat.size(), [&](std::size_t i) {
    const auto [a, b, c] = surface.triangle(FaceId(i));
    if (!left_out.of_geometry[i] && predicates::is_degenerate(a, b, c)) is_flat[i] = 1;
  });
  for (const FaceId f : surface.faces.ids()) {
    const std::size_t i = f.index();
    if (has_repeated_corner(surface.faces[f])) is_flat[i] = left_out.of_topology[i] = 1;
    if (!is_flat[i]) continue;
    left_out.of_geometry[i] = 1;
    faults.add(FaultKind::DegenerateTriangle, centroid(surface, f), std::array{f});
  }
}

void check_copies(const mesh::SurfaceMesh& surface, LeftOut& left_out, FaultCollector& faults) {
  const Copies copies = find_copies(surface);
  for (const FaceId f : surface.faces.ids()) {
    if (copies.kind[f] == Copy::None) continue;
    if (copies.kind[f] == Copy::Same) left_out.of_topology[f.index()] = left_out.of_geometry[f.index()] = 1;
    faults.add(FaultKind::DuplicateTriangle, centroid(surface, f), std::array{f, copies.original[f]});
  }
}

/// A place that both triangles are near: the middle of what their boxes have in common.
Vec3 middle_of_overlap(const mesh::SurfaceMesh& surface, FaceId f, FaceId g) {
  geometry::Box a = geometry::bounding_box(surface.triangle(f));
  const geometry::Box b = geometry::bounding_box(surface.triangle(g));
  for (int axis = 0; axis < 3; ++axis) {
    a.low[axis] = std::max(a.low[axis], b.low[axis]);
    a.high[axis] = std::min(a.high[axis], b.high[axis]);
  }
  return a.centre();
}

}  // namespace

LeftOut check_triangles(const mesh::SurfaceMesh& surface, FaultCollector& faults) {
  LeftOut left_out;
  left_out.of_topology.assign(surface.faces.size(), 0);
  left_out.of_geometry.assign(surface.faces.size(), 0);
  check_coordinates(surface, left_out, faults);
  check_areas(surface, left_out, faults);
  check_copies(surface, left_out, faults);
  return left_out;
}

EdgeCounts check_edges(const mesh::SurfaceMesh& surface, const EdgeGroups& edges, FaultCollector& faults) {
  EdgeCounts counts;
  std::vector<FaceId> faces;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto edge = edges[e];
    if (edge.size() == 2 && !disagree(surface, edge)) continue;
    const FaultKind kind = edge.size() == 1   ? FaultKind::OpenEdge
                           : edge.size() == 2 ? FaultKind::InconsistentOrientation
                                              : FaultKind::NonManifoldEdge;
    if (kind == FaultKind::OpenEdge) counts.open.push_back(edge.front());
    if (kind == FaultKind::NonManifoldEdge) ++counts.n_crowded;
    faces.clear();
    for (const HalfedgeId h : edge) faces.push_back(face_of(h));
    const Vec3 ends =
        surface.points[origin_of(surface, edge.front())] + surface.points[target_of(surface, edge.front())];
    faults.add(kind, ends * 0.5, faces);
  }
  return counts;
}

void check_vertices(const mesh::SurfaceMesh& surface, const EdgeGroups& edges, const LeftOut& left_out,
                    FaultCollector& faults) {
  for (const PinchedVertex& pinched : find_pinched_vertices(surface, edges, left_out.of_topology)) {
    faults.add(FaultKind::NonManifoldVertex, surface.points[pinched.vertex], pinched.faces);
  }
}

void check_intersections(const mesh::SurfaceMesh& surface, const LeftOut& left_out, FaultCollector& faults) {
  std::vector<FaceId> looked_at;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const FaceId f : surface.faces.ids()) {
    if (left_out.of_geometry[f.index()]) continue;
    const auto& [a, b, c] = surface.faces[f];
    looked_at.push_back(f);
    triangles.push_back({a.index(), b.index(), c.index()});
  }
  const Copies copies = find_copies(surface);
  for (const auto& [i, j] : search::self_intersections({surface.points.raw(), triangles})) {
    const FaceId f = looked_at[i], g = looked_at[j];
    const bool is_copy = copies.original[f] == copies.original[g];
    if (!is_copy) faults.add(FaultKind::SelfIntersection, middle_of_overlap(surface, f, g), std::array{f, g});
  }
}

}  // namespace nearwall::surface

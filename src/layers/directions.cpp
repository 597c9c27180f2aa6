#include <algorithm>
#include <cmath>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

/// A line is at most this much longer than the thickness it stands for: 2 is a lean of 60 degrees. Where a sharp edge
/// asks for more, the layers thin out towards it rather than stick out.
constexpr double kMaxStretch = 2.0;

/// Sweeps per thickness in edge lengths, and their range. A sweep carries a direction about one edge far, less as they
/// go on; near concave ridges directions must lean away over a distance comparable to the thickness.
constexpr double kSweepsPerEdge = 4.0;
constexpr int kMinSweeps = 2;
constexpr int kMaxSweeps = 40;

int automatic_sweeps(const Wall& wall, const VertexField& field) {
  geometry::CompensatedSum edges, thickness;
  std::size_t n_edges = 0, n_lines = 0;
  for (const FaceId f : wall.surface.faces.ids()) {
    const auto t = wall.surface.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) edges.add(distance(t[k], t[(k + 1) % 3]));
    n_edges += 3;
  }
  for (const double t : field.asked) {
    if (!(t > 0)) continue;
    thickness.add(t);
    ++n_lines;
  }
  if (n_lines == 0 || !(edges.value() > 0)) return 0;
  const double ratio = (thickness.value() / double(n_lines)) / (edges.value() / double(n_edges));
  return static_cast<int>(std::clamp(std::ceil(kSweepsPerEdge * ratio), double(kMinSweeps), double(kMaxSweeps)));
}

/// 1 / (mean cosine between the line and its faces, weighted by their angles at the vertex), bounded.
double stretch_of(const Wall& wall, VertexId v, const Vec3& direction) {
  double cosines = 0, angles = 0;
  for (const HalfedgeId h : wall.topology.fan(v)) {
    const FaceId f = Topology::face(h);
    const Vec3& apex = wall.surface.points[v];
    const double angle = geometry::corner_angle(apex, wall.surface.points[wall.topology.target(h)],
                                                wall.surface.points[wall.topology.origin(Topology::previous(h))]);
    cosines += angle * dot(direction, wall.features.face_normal[f]);
    angles += angle;
  }
  return cosines * kMaxStretch > angles ? angles / cosines : kMaxStretch;
}

}  // namespace

int set_directions(const Wall& wall, const GrowOptions& options, VertexField& field,
                   IdVector<VertexId, surface::PointNormal>& normals) {
  normals = surface::point_normals(wall.surface, wall.topology, wall.features, {.method = options.normals});
  surface::replace_blind_normals(wall.surface, wall.topology, wall.features, normals);
  auto smoothed = normals;
  surface::SmoothingOptions smoothing;
  smoothing.filter = options.filter;
  if (options.filter != surface::SmoothingFilter::None) {
    smoothing.iterations = options.smoothing_iterations.value_or(automatic_sweeps(wall, field));
    surface::smooth_normals(wall.surface, wall.topology, wall.features, smoothing, smoothed);
  }
  parallel_for(field.direction.size(), [&](std::size_t i) {
    const VertexId v(i);
    field.direction[v] = smoothed[v].direction;
    if (!(field.asked[v] > 0)) return;
    if (!normals[v].is_visible) {
      field.lower(v, 0, mesh::LimitReason::Visibility);
    } else {
      field.stretch[v] = stretch_of(wall, v, field.direction[v]);
    }
  });
  return smoothing.iterations;
}

}  // namespace nearwall::layers

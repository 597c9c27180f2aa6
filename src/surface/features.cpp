#include "nearwall/surface/features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/surface/normals.h"

namespace nearwall::surface {
namespace {

using mesh::Topology;

void check_angle(const char* name, double angle) {
  if (!(angle > 0 && angle < geometry::kPi)) {
    throw InputError(
        fmt::format("{}: expected an angle between 0 and 180 degrees, found {}", name, geometry::to_degrees(angle)));
  }
}

void check(const FeatureOptions& options) {
  check_angle("ridge_angle", options.ridge_angle);
  check_angle("corner_angle", options.corner_angle);
  check_angle("tip_angle", options.tip_angle);
}

/// Turn of each edge, written to both of its halfedges by the one with the smaller number.
void find_ridges(const mesh::SurfaceMesh& surface, const Topology& topology, double ridge_angle, Features& features) {
  const std::size_t n = 3 * surface.faces.size();
  features.turn.assign(n, 0.0);
  features.is_ridge.assign(n, 0);
  parallel_for(n, [&](std::size_t i) {
    const HalfedgeId h(i);
    const HalfedgeId twin = topology.twin(h);
    if (!twin.is_valid() || twin < h) return;
    const Vec3 along = surface.points[topology.target(h)] - surface.points[topology.origin(h)];
    const double turn =
        geometry::edge_turn(features.face_normal[Topology::face(h)], features.face_normal[Topology::face(twin)], along);
    const char is_ridge = std::abs(turn) >= ridge_angle ? 1 : 0;
    features.turn[h] = features.turn[twin] = turn;
    features.is_ridge[h] = features.is_ridge[twin] = is_ridge;
  });
}

void count_ridges(const Topology& topology, Features& features) {
  for (const HalfedgeId h : features.turn.ids()) {
    if (!features.is_ridge[h] || topology.twin(h) < h) continue;
    ++(features.turn[h] > 0 ? features.n_convex : features.n_concave);
  }
}

double worst_angle(const Vec3& direction, std::span<const Vec3> normals) {
  double worst = 0;
  for (const Vec3& n : normals) worst = std::max(worst, geometry::angle_between(direction, n));
  return worst;
}

/// Whether even the best direction sees the worst face round v under more than `tip_angle`.
bool is_tip(const Topology& topology, const Features& features, VertexId v, double tip_angle) {
  std::vector<Vec3> normals;
  Vec3 sum;
  for (const HalfedgeId h : topology.fan(v)) {
    normals.push_back(features.face_normal[Topology::face(h)]);
    sum += normals.back();
  }
  // Nearly all vertices are decided by the mean normal: the best one is at least as good.
  if (worst_angle(sum, normals) <= tip_angle) return false;
  const std::optional<VisibleNormal> best = most_visible_normal(normals);
  return !best || best->max_angle > tip_angle;
}

/// A ridge passes through v unless it bends sharply there or changes from convex to concave.
bool passes_through(const mesh::SurfaceMesh& surface, const Topology& topology, const Features& features, HalfedgeId a,
                    HalfedgeId b, double corner_angle) {
  if ((features.turn[a] > 0) != (features.turn[b] > 0)) return false;
  const Vec3 into = surface.points[topology.origin(a)] - surface.points[topology.target(a)];
  const Vec3 out = surface.points[topology.target(b)] - surface.points[topology.origin(b)];
  return geometry::angle_between(into, out) <= corner_angle;
}

PointKind kind_of(const mesh::SurfaceMesh& surface, const Topology& topology, const Features& features, VertexId v,
                  const FeatureOptions& options) {
  std::size_t n_ridges = 0;
  HalfedgeId first, last;
  for (const HalfedgeId h : topology.fan(v)) {
    if (!features.is_ridge[h]) continue;
    if (n_ridges++ == 0) first = h;
    last = h;
  }
  switch (n_ridges) {
    case 0:
      return is_tip(topology, features, v, options.tip_angle) ? PointKind::Tip : PointKind::Smooth;
    case 1:
      return PointKind::RidgeEnd;
    case 2:
      return passes_through(surface, topology, features, first, last, options.corner_angle) ? PointKind::Ridge
                                                                                            : PointKind::Corner;
    default:
      return PointKind::Corner;
  }
}

}  // namespace

Features find_features(const mesh::SurfaceMesh& surface, const Topology& topology, const FeatureOptions& options) {
  check(options);
  Features features;
  features.face_normal.resize(surface.faces.size());
  parallel_for(surface.faces.size(), [&](std::size_t i) {
    const auto [a, b, c] = surface.triangle(FaceId(i));
    features.face_normal[FaceId(i)] = geometry::triangle_normal(a, b, c);
  });
  find_ridges(surface, topology, options.ridge_angle, features);
  count_ridges(topology, features);
  features.kind.resize(surface.points.size());
  parallel_for(surface.points.size(), [&](std::size_t i) {
    features.kind[VertexId(i)] = kind_of(surface, topology, features, VertexId(i), options);
  });
  return features;
}

std::vector<int> discrete_patches(const Topology& topology, const Features& features, VertexId v) {
  const auto fan = topology.fan(v);
  std::vector<int> patch(fan.size(), 0);
  if (fan.empty()) return patch;
  int last = 0;
  // Halfedge i separates face i from the face before it.
  for (std::size_t i = 1; i < fan.size(); ++i) {
    if (features.is_ridge[fan[i]]) ++last;
    patch[i] = last;
  }
  if (topology.is_boundary(v) || features.is_ridge[fan[0]] || last == 0) return patch;
  // No ridge where the turn round the vertex closes: its last run of faces goes on into the first.
  std::replace(patch.begin(), patch.end(), last, 0);
  return patch;
}

}  // namespace nearwall::surface

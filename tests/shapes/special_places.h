#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "nearwall/geometry/angles.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/shapes/shapes.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/normals.h"
#include "nearwall/surface/point_normals.h"

namespace nearwall::shapes {

/// Turns of the ridges at a vertex [deg]: convex ones, and concave ones, as positive numbers.
struct RidgesAt {
  std::vector<double> convex, concave;
};

/// A shape with its ridges, to be looked at in special places.
class Place {
 public:
  explicit Place(mesh::SurfaceMesh made) : surface(std::move(made)) {}
  Place(std::string_view name, const ParameterValues& parameters, double size = 0)
      : Place(make_shape(name, parameters, size)) {}

  const mesh::SurfaceMesh surface;
  const mesh::Topology topology{surface};
  const surface::Features features = surface::find_features(surface, topology);

  /// The vertex nearest to p.
  VertexId vertex_at(const Vec3& p) const {
    VertexId nearest(0);
    for (const VertexId v : surface.points.ids()) {
      if (distance(surface.points[v], p) < distance(surface.points[nearest], p)) nearest = v;
    }
    return nearest;
  }

  RidgesAt ridges_at(VertexId v) const {
    RidgesAt ridges;
    for (const HalfedgeId h : topology.fan(v)) {
      const double turn = geometry::to_degrees(features.turn[h]);
      if (features.is_ridge[h]) (turn > 0 ? ridges.convex : ridges.concave).push_back(std::abs(turn));
    }
    return ridges;
  }
  RidgesAt ridges_at(const Vec3& p) const { return ridges_at(vertex_at(p)); }

  /// Calls body(midpoint, turn [deg]) once for each edge.
  template <class Body>
  void for_each_edge(const Body& body) const {
    for (const HalfedgeId h : features.turn.ids()) {
      if (topology.twin(h) < h) continue;
      const Vec3 middle = (surface.points[topology.origin(h)] + surface.points[topology.target(h)]) * 0.5;
      body(middle, geometry::to_degrees(features.turn[h]));
    }
  }

  /// Worst angle under which the best direction sees the faces round v [deg]; nullopt if none sees all.
  std::optional<double> best_view(VertexId v) const {
    std::vector<Vec3> normals;
    for (const HalfedgeId h : topology.fan(v)) normals.push_back(features.face_normal[mesh::Topology::face(h)]);
    const auto best = surface::most_visible_normal(normals);
    if (!best) return std::nullopt;
    return geometry::to_degrees(best->max_angle);
  }

  std::size_t n_blind() const {
    std::size_t n = 0;
    for (const auto& normal : surface::point_normals(surface, topology, features)) n += !normal.is_visible;
    return n;
  }

  std::size_t n_of_kind(surface::PointKind kind) const {
    return static_cast<std::size_t>(std::count(features.kind.begin(), features.kind.end(), kind));
  }
};

}  // namespace nearwall::shapes

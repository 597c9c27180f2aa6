#pragma once

#include <cmath>
#include <vector>

#include "nearwall/surface/smoothing.h"
#include "tests/support/shapes.h"
#include "tests/surface/fans.h"

/// Surfaces and normals to be smoothed.
namespace nearwall::surface::smoothed {

namespace shapes = shapes_for_tests;
using fans::Random;
using Normals = IdVector<VertexId, PointNormal>;

inline SmoothingOptions sweeps(SmoothingFilter filter, int iterations) {
  SmoothingOptions options;
  options.filter = filter;
  options.iterations = iterations;
  return options;
}

/// A surface with what smoothing wants to know about it.
struct Prepared {
  mesh::SurfaceMesh surface;
  mesh::Topology topology;
  Features features;
  explicit Prepared(mesh::SurfaceMesh s, const FeatureOptions& options = {})
      : surface(std::move(s)), topology(surface), features(find_features(surface, topology, options)) {}

  Normals normals() const { return point_normals(surface, topology, features); }
  Normals smoothed(Normals normals, const SmoothingOptions& options) const {
    smooth_normals(surface, topology, features, options, normals);
    return normals;
  }
  std::vector<Vec3> faces_at(VertexId v) const {
    std::vector<Vec3> faces;
    for (const HalfedgeId h : topology.fan(v)) faces.push_back(features.face_normal[mesh::Topology::face(h)]);
    return faces;
  }
  /// Mean squared difference between the directions at the ends of an edge.
  double roughness(const Normals& normals) const {
    double sum = 0;
    for (const HalfedgeId h : features.turn.ids()) {
      sum += squared_norm(normals[topology.origin(h)].direction - normals[topology.target(h)].direction);
    }
    return sum / static_cast<double>(features.turn.size());
  }
};

inline mesh::SurfaceMesh bumpy_sphere(int level, double height, unsigned seed) {
  Random random(seed);
  return shapes::mapped(shapes::sphere(level),
                        [&](const Vec3& p) { return p * random.uniform(1 - height, 1 + height); });
}

/// Gently waved plate whose normals are disturbed within their room.
inline mesh::SurfaceMesh waves(std::size_t n) {
  return shapes::height_field(n, [](double x, double y) { return 0.03 * std::sin(6 * x) * std::cos(5 * y); });
}

inline Normals disturbed(Normals normals, double size, unsigned seed) {
  Random random(seed);
  for (PointNormal& normal : normals) normal.direction = normalized(normal.direction + random.direction() * size);
  return normals;
}

}  // namespace nearwall::surface::smoothed

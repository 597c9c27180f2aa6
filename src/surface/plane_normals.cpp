#include "nearwall/surface/plane_normals.h"

#include <algorithm>
#include <vector>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "surface/face_normals.h"
#include "surface/normals_visible.h"

namespace nearwall::surface {

namespace {

/// Point of the segment from a to b that is nearest to the origin.
Vec3 nearest_to_origin(const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length = squared_norm(way);
  if (!(length > 0)) return a;
  return a + way * std::clamp(-dot(a, way) / length, 0.0, 1.0);
}

Vec3 sum_of(std::span<const Vec3> normals) {
  Vec3 sum;
  for (const Vec3& n : normals) sum += n;
  return sum;
}

/// Zero if there is none.
Vec3 direction_in(const mesh::SidePlanes& planes, VertexId v, std::span<const Vec3> normals) {
  const auto all = planes.of(v);
  if (all.size() == 1) return most_visible_in_plane(normals, planes.planes[all[0]]).value_or(Vec3());
  return planes.direction_within(v, sum_of(normals));
}

}  // namespace

std::optional<Vec3> most_visible_in_plane(std::span<const Vec3> normals, const mesh::SidePlane& plane) {
  std::vector<Vec3> parts;
  for (const Vec3& n : normals) parts.push_back(plane.within(n));
  if (parts.empty()) return std::nullopt;
  Vec3 nearest = parts.front();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i; j < parts.size(); ++j) {
      const Vec3 p = nearest_to_origin(parts[i], parts[j]);
      if (squared_norm(p) < squared_norm(nearest)) nearest = p;
    }
  }
  const double size = norm(nearest);
  if (!(size > 0)) return std::nullopt;
  // Rounding leaves a trace of the normal of a plane along no axis.
  const Vec3 direction = normalized(plane.within(nearest / size));
  if (!sees_all(direction, normals)) return std::nullopt;
  return direction;
}

void hold_in_planes(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                    const mesh::SidePlanes& planes, IdVector<VertexId, PointNormal>& normals) {
  if (planes.empty()) return;
  expect(planes.of_vertex.size() == surface.points.size() && normals.size() == surface.points.size(),
         "hold_in_planes: planes and normals of each vertex");
  parallel_blocks(normals.size(), kVertexBlock, [&](std::size_t begin, std::size_t end) {
    FaceNormals faces(features);
    for (std::size_t i = begin; i < end; ++i) {
      const VertexId v(i);
      if (!planes.is_on_plane(v)) continue;
      const auto round = faces.of(topology.fan(v));
      const Vec3 direction = direction_in(planes, v, round);
      const bool has_direction = squared_norm(direction) > 0;
      const Vec3& shown = has_direction ? direction : normals[v].direction;
      normals[v] = judged(shown, round, squared_chord_to_worst(shown, round));
      if (!has_direction) normals[v].is_visible = false;
    }
  });
}

}  // namespace nearwall::surface

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "nearwall/shapes/shapes.h"
#include "tests/support/shapes.h"

/// Surfaces that no user draws on purpose: bodies a hair apart, bodies in bodies, dense meshes beside coarse ones.
/// Normals outward.
namespace nearwall::shapes_for_tests {

/// Cuts the faces for which is_dense(face) holds into n² each; of the others those beside them get a fan of triangles
/// towards the new points, so edges jump by a factor of n.
template <class IsDense>
mesh::SurfaceMesh refined_where(const mesh::SurfaceMesh& surface, std::size_t n, IsDense&& is_dense) {
  mesh::SurfaceMesh result = surface;
  result.faces.clear();
  result.face_patch.clear();
  std::map<std::pair<VertexId, VertexId>, std::vector<VertexId>> cut_edges;
  const auto between = [&](const Vec3& a, const Vec3& b, std::size_t i, std::size_t parts) {
    return a + (b - a) * (static_cast<double>(i) / static_cast<double>(parts));
  };
  // The points from a to b, both included, if the edge is cut.
  const auto points_of = [&](VertexId a, VertexId b) {
    const auto found = cut_edges.find(std::minmax(a, b));
    if (found == cut_edges.end()) return std::vector<VertexId>{a, b};
    return a < b ? found->second : std::vector<VertexId>(found->second.rbegin(), found->second.rend());
  };
  for (const FaceId f : surface.faces.ids()) {
    if (!is_dense(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(surface.faces[f][k], surface.faces[f][(k + 1) % 3]);
      auto& points = cut_edges[{a, b}];
      if (!points.empty()) continue;
      points.push_back(a);
      for (std::size_t i = 1; i < n; ++i) {
        points.push_back(result.points.push_back(between(surface.points[a], surface.points[b], i, n)));
      }
      points.push_back(b);
    }
  }
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.faces[f];
    const auto add = [&](VertexId p, VertexId q, VertexId r) {
      result.faces.push_back({p, q, r});
      result.face_patch.push_back(surface.face_patch[f]);
    };
    if (is_dense(f)) {
      // Rows parallel to bc, from a down: row i has i + 1 points.
      const auto left = points_of(a, b), right = points_of(a, c), last = points_of(b, c);
      std::vector<VertexId> above{a};
      for (std::size_t i = 1; i <= n; ++i) {
        std::vector<VertexId> row{left[i]};
        for (std::size_t j = 1; j < i; ++j) {
          row.push_back(i == n
                            ? last[j]
                            : result.points.push_back(between(result.points[left[i]], result.points[right[i]], j, i)));
        }
        row.push_back(right[i]);
        for (std::size_t j = 0; j < i; ++j) {
          add(above[j], row[j], row[j + 1]);
          if (j + 1 < i) add(above[j], row[j + 1], above[j + 1]);
        }
        above = row;
      }
      continue;
    }
    std::vector<VertexId> outline;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      const auto edge = points_of(from, to);
      outline.insert(outline.end(), edge.begin(), edge.end() - 1);
    }
    if (outline.size() == 3) {
      add(a, b, c);
      continue;
    }
    const auto t = surface.triangle(f);
    const VertexId middle = result.points.push_back((t[0] + t[1] + t[2]) / 3);
    for (std::size_t i = 0; i < outline.size(); ++i) add(middle, outline[i], outline[(i + 1) % outline.size()]);
  }
  return result;
}

/// Cube of a few large triangles, but for one side's, which are cut into 24² each.
inline mesh::SurfaceMesh dense_side() {
  const mesh::SurfaceMesh coarse = cube();
  return refined_where(coarse, 24, [&](FaceId f) {
    const auto t = coarse.triangle(f);
    return t[0].z() > 0 && t[1].z() > 0 && t[2].z() > 0;
  });
}

/// Sphere with one dense triangle among coarse ones.
inline mesh::SurfaceMesh dense_spot() {
  return mapped(refined_where(sphere(2), 24, [](FaceId f) { return f.index() == 5; }),
                [](const Vec3& p) { return normalized(p); });
}

/// A coarse body and a dense one close to it.
inline mesh::SurfaceMesh dense_before_coarse() {
  const mesh::SurfaceMesh dense = sphere(4, 0.1, {0.65, 0.05, 0.05});
  return joined(cube(), dense);
}

/// A sphere whose lowest vertex is `gap` above a cube.
inline mesh::SurfaceMesh sphere_above_cube(double gap) { return joined(cube(), sphere(3, 0.5, {0.13, 0.17, 1 + gap})); }

/// A cylinder along x that lies on a block but for `gap`.
inline mesh::SurfaceMesh cylinder_above_block(double gap) {
  const mesh::SurfaceMesh cylinder = shapes::make_shape("cylinder", {{"length", 1.5}}, 0.26);
  double lowest = 0;
  for (const Vec3& p : cylinder.points) lowest = std::min(lowest, p.z());
  const mesh::SurfaceMesh block = shapes::make_shape("box", {{"length", 2}, {"width", 1.5}, {"height", 0.5}}, 0.25);
  return joined(block, translated(cylinder, {0, 0, 0.25 + gap - lowest}));
}

/// Two cubes, an edge of one above an edge of the other and at a right angle to it, `gap` apart.
inline mesh::SurfaceMesh crossed_edges(double gap) {
  const double r = std::sqrt(0.5);
  const auto stood_on_edge = [&](bool along_x) {
    return mapped(cube(), [&](const Vec3& p) {
      const double u = (along_x ? p.y() : p.x()) * r, w = p.z() * r;
      return along_x ? Vec3(p.x(), u - w, u + w) : Vec3(u - w, p.y(), u + w);
    });
  };
  return joined(stood_on_edge(true), translated(stood_on_edge(false), {0, 0, 2 * r + gap}));
}

/// A cube that stands on its corner on another one but for `gap`.
inline mesh::SurfaceMesh corner_above_cube(double gap) {
  const Vec3 up = normalized(Vec3(1, 1, 1)), side = normalized(Vec3(1, -1, 0)), back = cross(up, side);
  const mesh::SurfaceMesh stood =
      mapped(cube(), [&](const Vec3& p) { return Vec3(dot(p, side), dot(p, back), dot(p, up)); });
  return joined(cube(), translated(stood, {0.11, 0.07, 0.5 + std::sqrt(0.75) + gap}));
}

/// A ball in a ring: concentric bodies with the fluid between and outside.
inline mesh::SurfaceMesh ball_in_ring() { return joined(shapes::make_shape("torus", {}, 0.25), sphere(3, 0.6)); }

/// Bodies in a hollow ball, one of them tiny and close to another one; for fluid inside.
inline mesh::SurfaceMesh bodies_in_a_ball() {
  mesh::SurfaceMesh all = sphere(3, 3);
  for (const mesh::SurfaceMesh& body :
       {sphere(2), sphere(1, 0.01, {0, 0, 1.02}), cube(0.3, {1.5, 0.2, 0.1}), sphere(2, 0.4, {-2.5, 0, 0.3})}) {
    all = joined(std::move(all), flipped(body));
  }
  return all;
}

/// Tiny bodies all round a cube, nearer than its layers are thick.
inline mesh::SurfaceMesh swarm() {
  mesh::SurfaceMesh all = cube();
  for (int i = 0; i < 24; ++i) {
    const double t = i;
    // A spiral from pole to pole, at changing distances from the cube.
    const double z = (2 * t + 1) / 24 - 1, angle = 2.4 * t, r = std::sqrt(1 - z * z);
    const Vec3 direction(r * std::cos(angle), r * std::sin(angle), z);
    const double distance = (0.5 + 0.015 + 0.004 * t) / max_norm(direction);
    all = joined(std::move(all), sphere(i % 2, 0.005, direction * distance));
  }
  return all;
}

}  // namespace nearwall::shapes_for_tests

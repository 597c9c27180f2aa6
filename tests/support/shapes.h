#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/mesh/surface_mesh.h"

/// Small surfaces for tests, normals outward, one patch "wall" unless said otherwise.
namespace nearwall::shapes_for_tests {

using Corners = std::array<std::size_t, 3>;

inline mesh::SurfaceMesh make_surface(const std::vector<Vec3>& points, const std::vector<Corners>& faces,
                                      const std::string& patch = "wall") {
  mesh::SurfaceMesh surface;
  surface.points.raw() = points;
  for (const Corners& f : faces) surface.faces.push_back({VertexId(f[0]), VertexId(f[1]), VertexId(f[2])});
  surface.face_patch.assign(faces.size(), PatchId(0));
  surface.patch_names.push_back(patch);
  return surface;
}

// Changes of a surface.

template <class Map>
mesh::SurfaceMesh mapped(mesh::SurfaceMesh surface, Map&& map) {
  for (Vec3& p : surface.points) p = map(p);
  return surface;
}

inline mesh::SurfaceMesh translated(mesh::SurfaceMesh surface, const Vec3& by) {
  return mapped(std::move(surface), [&](const Vec3& p) { return p + by; });
}

inline mesh::SurfaceMesh scaled(mesh::SurfaceMesh surface, double factor) {
  return mapped(std::move(surface), [&](const Vec3& p) { return p * factor; });
}

inline void flip(mesh::SurfaceMesh& surface, FaceId f) { std::swap(surface.faces[f][1], surface.faces[f][2]); }

/// All triangles turned round.
inline mesh::SurfaceMesh flipped(mesh::SurfaceMesh surface) {
  for (const FaceId f : surface.faces.ids()) flip(surface, f);
  return surface;
}

/// Both surfaces as one; patches of the same name become one.
inline mesh::SurfaceMesh joined(mesh::SurfaceMesh a, const mesh::SurfaceMesh& b) {
  const std::size_t first = a.points.size();
  for (const Vec3& p : b.points) a.points.push_back(p);
  for (const FaceId f : b.faces.ids()) {
    auto face = b.faces[f];
    for (VertexId& v : face) v = VertexId(v.index() + first);
    a.faces.push_back(face);
    const std::string& name = b.patch_names[b.face_patch[f]];
    const auto found = std::find(a.patch_names.begin(), a.patch_names.end(), name);
    const auto patch = static_cast<std::size_t>(found - a.patch_names.begin());
    if (found == a.patch_names.end()) a.patch_names.push_back(name);
    a.face_patch.push_back(PatchId(patch));
  }
  return a;
}

/// Every triangle with points of its own, as in an STL file.
inline mesh::SurfaceMesh as_soup(const mesh::SurfaceMesh& surface) {
  mesh::SurfaceMesh soup = surface;
  soup.points.clear();
  for (auto& face : soup.faces) {
    for (VertexId& v : face) v = soup.points.push_back(surface.points[v]);
  }
  return soup;
}

inline mesh::SurfaceMesh without_face(mesh::SurfaceMesh surface, FaceId f) {
  surface.faces.raw().erase(surface.faces.raw().begin() + f.index());
  surface.face_patch.raw().erase(surface.face_patch.raw().begin() + f.index());
  return surface;
}

inline void add_face(mesh::SurfaceMesh& surface, const Corners& corners, PatchId patch = PatchId(0)) {
  surface.faces.push_back({VertexId(corners[0]), VertexId(corners[1]), VertexId(corners[2])});
  surface.face_patch.push_back(patch);
}

/// Every triangle in four, with new points in the middle of the edges.
inline mesh::SurfaceMesh subdivided(const mesh::SurfaceMesh& surface) {
  mesh::SurfaceMesh fine = surface;
  fine.faces.clear();
  fine.face_patch.clear();
  std::map<std::pair<VertexId, VertexId>, VertexId> middles;
  const auto middle = [&](VertexId a, VertexId b) {
    const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b));
    if (is_new) entry->second = fine.points.push_back((surface.points[a] + surface.points[b]) * 0.5);
    return entry->second;
  };
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.faces[f];
    const VertexId ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const auto& corners :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
      fine.faces.push_back(corners);
      fine.face_patch.push_back(surface.face_patch[f]);
    }
  }
  return fine;
}

// Bodies.

inline mesh::SurfaceMesh tetrahedron() {
  return make_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

/// Axis-parallel box, two triangles a side.
inline mesh::SurfaceMesh box(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < 8; ++i) {
    points.emplace_back(i & 1u ? high.x() : low.x(), i & 2u ? high.y() : low.y(), i & 4u ? high.z() : low.z());
  }
  return make_surface(points, {{0, 2, 3},
                               {0, 3, 1},
                               {4, 5, 7},
                               {4, 7, 6},
                               {0, 1, 5},
                               {0, 5, 4},
                               {2, 6, 7},
                               {2, 7, 3},
                               {0, 4, 6},
                               {0, 6, 2},
                               {1, 3, 7},
                               {1, 7, 5}});
}

/// Cube with the given half edge.
inline mesh::SurfaceMesh cube(double half = 0.5, const Vec3& centre = {}) {
  const Vec3 d(half, half, half);
  return box(centre - d, centre + d);
}

inline mesh::SurfaceMesh octahedron() {
  return make_surface({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

/// Sphere of 8 * 4^level triangles, from an octahedron.
inline mesh::SurfaceMesh sphere(int level, double radius = 1, const Vec3& centre = {}) {
  mesh::SurfaceMesh surface = octahedron();
  for (int i = 0; i < level; ++i) {
    surface = mapped(subdivided(surface), [](const Vec3& p) { return normalized(p); });
  }
  return mapped(std::move(surface), [&](const Vec3& p) { return p * radius + centre; });
}

/// Prism over a polygon in the plane z = 0 (counterclockwise, star-shaped as seen from its first corner), up to z =
/// height.
inline mesh::SurfaceMesh prism_over(const std::vector<std::array<double, 2>>& polygon, double height) {
  const std::size_t n = polygon.size();
  std::vector<Vec3> points;
  for (const auto& [x, y] : polygon) points.emplace_back(x, y, 0.0);
  for (const auto& [x, y] : polygon) points.emplace_back(x, y, height);
  std::vector<Corners> faces;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    faces.push_back({0, i + 1, i});
    faces.push_back({n, n + i, n + i + 1});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    faces.push_back({i, j, n + j});
    faces.push_back({i, n + j, n + i});
  }
  return make_surface(points, faces);
}

/// A step: prism over an L, with one concave edge along z at x = y = 1.
inline mesh::SurfaceMesh l_step() { return prism_over({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}, 1); }

/// Wedge with a sharp edge along z at the origin, opening by `angle` [rad] towards +x.
inline mesh::SurfaceMesh wedge(double angle) {
  const double c = std::cos(angle / 2), s = std::sin(angle / 2);
  return prism_over({{0, 0}, {c, -s}, {c, s}}, 1);
}

/// Cone of n sides with its tip at z = height over a unit circle.
inline mesh::SurfaceMesh cone(std::size_t n, double height) {
  std::vector<Vec3> points = {{0, 0, height}, {0, 0, 0}};
  std::vector<Corners> faces;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * geometry::kPi * static_cast<double>(i) / static_cast<double>(n);
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    faces.push_back({0, 2 + i, 2 + (i + 1) % n});
    faces.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  return make_surface(points, faces);
}

/// Union of unit cubes given by their lowest corners, each of their faces cut in two.
inline mesh::SurfaceMesh voxels(const std::vector<std::array<int, 3>>& cells) {
  mesh::SurfaceMesh surface;
  surface.patch_names.push_back("wall");
  std::map<std::array<int, 3>, VertexId> vertices;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = vertices.try_emplace(p);
    if (is_new) it->second = surface.points.push_back(Vec3(p[0], p[1], p[2]));
    return it->second;
  };
  for (const auto& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        auto neighbour = cell;
        neighbour[axis] += side == 0 ? -1 : 1;
        if (std::find(cells.begin(), cells.end(), neighbour) != cells.end()) continue;
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<std::array<int, 3>, 4> quad{cell, cell, cell, cell};
        for (auto& corner : quad) corner[axis] += side;
        ++quad[1][u], ++quad[2][u], ++quad[2][v], ++quad[3][v];
        if (side == 0) std::swap(quad[1], quad[3]);
        surface.faces.push_back({vertex(quad[0]), vertex(quad[1]), vertex(quad[2])});
        surface.faces.push_back({vertex(quad[0]), vertex(quad[2]), vertex(quad[3])});
      }
    }
  }
  surface.face_patch.assign(surface.faces.size(), PatchId(0));
  return surface;
}

/// Four cubes in a chain round the origin, which has faces that look along y and against it: no direction sees both.
inline mesh::SurfaceMesh blind_corner() { return voxels({{-1, -1, -1}, {0, -1, -1}, {0, 0, -1}, {0, 0, 0}}); }

/// Two tetrahedra that have one point in common.
inline mesh::SurfaceMesh pinched_vertex() {
  mesh::SurfaceMesh surface = tetrahedron();
  const mesh::SurfaceMesh mirrored = scaled(flipped(tetrahedron()), -1);
  for (std::size_t i = 1; i < 4; ++i) surface.points.push_back(mirrored.points[VertexId(i)]);
  for (const auto& f : mirrored.faces) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = f[k].index() == 0 ? 0 : f[k].index() + 3;
    add_face(surface, corners);
  }
  return surface;
}

/// Two cubes that have one edge in common: four faces at that edge.
inline mesh::SurfaceMesh cubes_sharing_an_edge() {
  mesh::SurfaceMesh surface = box({0, 0, 0}, {1, 1, 1});
  const mesh::SurfaceMesh other = box({1, 1, 0}, {2, 2, 1});
  // Corners 3 and 7 of the first are corners 0 and 4 of the second.
  std::array<std::size_t, 8> number{};
  for (std::size_t i = 0; i < 8; ++i) {
    number[i] = i == 0 ? 3 : i == 4 ? 7 : std::size_t{surface.points.push_back(other.points[VertexId(i)]).index()};
  }
  for (const auto& f : other.faces)
    add_face(surface, {number[f[0].index()], number[f[1].index()], number[f[2].index()]});
  return surface;
}

// Open surfaces.

/// Square [0, 1]^2 in the plane z = 0 as n x n squares of two triangles, normals along z; lifted to z = height(x, y).
template <class Height>
mesh::SurfaceMesh height_field(std::size_t n, Height&& height) {
  std::vector<Vec3> points;
  std::vector<Corners> faces;
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(n);
      const double y = static_cast<double>(j) / static_cast<double>(n);
      points.emplace_back(x, y, height(x, y));
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j * (n + 1) + i;
      faces.push_back({a, a + 1, a + n + 2});
      faces.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return make_surface(points, faces);
}

inline mesh::SurfaceMesh plate(std::size_t n) {
  return height_field(n, [](double, double) { return 0.0; });
}

inline mesh::SurfaceMesh saddle(std::size_t n) {
  return height_field(n, [](double x, double y) { return (x - 0.5) * (y - 0.5); });
}

/// Moebius strip of n rectangles (2 n triangles): one side, one boundary.
inline mesh::SurfaceMesh moebius_strip(std::size_t n) {
  std::vector<Vec3> points;
  std::vector<Corners> faces;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * geometry::kPi * static_cast<double>(i) / static_cast<double>(n);
    for (const double t : {-0.25, 0.25}) {
      const double radius = 1 + t * std::cos(angle / 2);
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), t * std::sin(angle / 2));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_last = i + 1 == n;
    const std::size_t a = 2 * i, b = a + 1;
    const std::size_t c = is_last ? 1 : a + 2, d = is_last ? 0 : a + 3;
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  return make_surface(points, faces);
}

}  // namespace nearwall::shapes_for_tests

#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/search/self_intersection.h"

namespace nearwall::soups_for_tests {

/// Owns what IndexedTriangles only looks at.
struct Soup {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  search::IndexedTriangles view() const { return {points, triangles}; }
};

inline Soup soup_of(const mesh::SurfaceMesh& surface) {
  Soup soup;
  soup.points = surface.points.raw();
  for (const auto& f : surface.faces) soup.triangles.push_back({f[0].index(), f[1].index(), f[2].index()});
  return soup;
}

/// Random points, random triangles of any three different ones: many share corners, some share edges.
/// \param grid  points on a grid of that many steps, so that much is coplanar; 0: anywhere in the cube
inline Soup random_soup(std::uint32_t n_points, std::size_t n_triangles, int grid, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  const auto coordinate = [&] {
    return grid == 0 ? anywhere(random) : double(std::uniform_int_distribution<int>(0, grid)(random)) / grid;
  };
  Soup soup;
  for (std::uint32_t i = 0; i < n_points; ++i) soup.points.emplace_back(coordinate(), coordinate(), coordinate());
  std::uniform_int_distribution<std::uint32_t> corner(0, n_points - 1);
  while (soup.triangles.size() < n_triangles) {
    const std::array<std::uint32_t, 3> t{corner(random), corner(random), corner(random)};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) soup.triangles.push_back(t);
  }
  return soup;
}

inline mesh::SurfaceMesh surface_of(const Soup& soup) {
  mesh::SurfaceMesh surface;
  surface.points.raw() = soup.points;
  for (const auto& t : soup.triangles) surface.faces.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
  surface.face_patch.assign(soup.triangles.size(), PatchId(0));
  surface.patch_names.push_back("wall");
  return surface;
}

}  // namespace nearwall::soups_for_tests

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/volume/fill.h"

namespace nearwall::boundaries_for_tests {

/// Adds a surface whose normals point outward: the region is inside of it, or outside for a hole.
inline void add(volume::FillBoundary& boundary, const mesh::SurfaceMesh& surface, bool is_hole = false) {
  const auto first = static_cast<std::uint32_t>(boundary.points.size());
  boundary.points.insert(boundary.points.end(), surface.points.begin(), surface.points.end());
  for (const auto& f : surface.faces) {
    const std::uint32_t a = first + f[0].index();
    const std::uint32_t b = first + f[1].index();
    const std::uint32_t c = first + f[2].index();
    boundary.triangles.push_back(is_hole ? std::array{a, c, b} : std::array{a, b, c});
  }
}

inline volume::FillBoundary region(const mesh::SurfaceMesh& outer, const std::vector<mesh::SurfaceMesh>& holes = {}) {
  volume::FillBoundary boundary;
  add(boundary, outer);
  for (const auto& hole : holes) add(boundary, hole, true);
  return boundary;
}

}  // namespace nearwall::boundaries_for_tests

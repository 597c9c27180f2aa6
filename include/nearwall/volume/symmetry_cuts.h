#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::volume {

/// A plane normal to an axis at which bodies may be cut open.
struct CutPlane {
  int axis = 1;              ///< 0, 1, 2 for x, y, z
  std::optional<double> at;  ///< its coordinate [length]; nullopt: where the open edges are, or else 0
  std::string patch;         ///< name of the patch of its caps
};

struct CutClosing {
  mesh::SurfaceMesh surface;      ///< with caps, each in the patch of its plane
  std::vector<double> at;         ///< (n_planes) coordinate of each plane
  std::vector<std::size_t> caps;  ///< (n_planes) triangles added
  double farthest_move = 0;       ///< of an open vertex onto its plane [length]
};

/// Closes bodies that are open where planes of symmetry cut them: open edges of which both ends lie on a plane, to a
/// hundred thousandth of the surface's diagonal, are moved onto it, and what they go round is filled with triangles
/// without new points. Where two planes meet, the edges go on along the line between them. Open edges on no plane stay
/// open.
/// \throws GeometryError  if the edges on a plane cross each other or do not go round anything
/// Cost: O(n log n).
CutClosing close_cuts(const mesh::SurfaceMesh& surface, const std::vector<CutPlane>& planes);

}  // namespace nearwall::volume

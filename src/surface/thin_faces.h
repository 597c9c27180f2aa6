#pragma once

#include <vector>

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"

namespace nearwall::surface {

/// Long and thin faces along the boundary, whose normals say little about the surface: those with a corner wider than
/// `thin_angle`, and then those that come to lie on the boundary without them, and so on.
/// \param thin_angle  [rad]; pi: none
/// \returns  (n_faces) 1 for each such face; empty if there is none    Source: Bohdal 2017, section 3
/// Cost: O(n_faces) on an open surface, nothing on a closed one.
std::vector<char> thin_boundary_faces(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                      double thin_angle);

}  // namespace nearwall::surface

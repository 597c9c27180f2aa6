#pragma once

#include <cstdint>
#include <string>

#include "nearwall/mesh/boundary.h"
#include "nearwall/mesh/mesh_source.h"
#include "nearwall/mesh/neighbours.h"

namespace nearwall::io {

/// What writers of solver formats read a mesh from: nothing of it is copied, all of it must outlive the call. Cells
/// with a layer above 0 form the group of layers in formats that know groups.
struct WholeMesh {
  const mesh::MeshSource& cells;
  const mesh::Boundary& boundary;           ///< complete, each face counterclockwise seen from outside
  const mesh::NeighbourSource& neighbours;  ///< by the batches of `cells`; read by formats that list faces
  std::string name;                         ///< of the case
};

/// Names of the groups of cells.
inline constexpr const char* kLayersGroup = "layers";
inline constexpr const char* kRestGroup = "rest";

}  // namespace nearwall::io

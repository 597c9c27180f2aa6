#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "nearwall/core/id_vector.h"
#include "nearwall/mesh/cell_faces.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/volume_mesh.h"

namespace nearwall::certify {

/// Where the triangles of a surface are on the boundary of a mesh.
struct WallMatch {
  /// (n_triangles) the boundary face with these corners, a triangle or a quad that has them among its own.
  IdVector<FaceId, std::optional<mesh::FaceName>> face;
  std::uint64_t n_exact = 0;  ///< triangles whose three corners are there bit for bit
  std::uint64_t n_near = 0;   ///< triangles found within the tolerance
};

/// Corners are matched bit for bit, or else within a thousandth of the triangle's shortest edge and what coordinates
/// lose as single precision floats, as in STL files; of several faces that fit the nearest is taken.
/// \param boundary  as Conformity::boundary
/// Cost: O(n log n), on all threads.
WallMatch match_wall(const mesh::VolumeMesh& mesh, std::span<const mesh::FaceName> boundary,
                     const mesh::SurfaceMesh& wall);

}  // namespace nearwall::certify

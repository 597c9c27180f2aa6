#pragma once

#include <cstdint>
#include <optional>

#include "nearwall/core/id_vector.h"
#include "nearwall/mesh/cell_faces.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/volume_mesh.h"
#include "nearwall/quality/statistics.h"

namespace nearwall::quality {

/// The layers that a mesh, of whatever origin, has on one patch of a wall. Percentages and statistics by area of its
/// triangles. Definitions: docs/theory/quality.md.
struct WallPatchLayers {
  double area = 0;
  double matched_percent = 0;     ///< of the area: triangles that are faces of the mesh
  std::uint32_t count = 0;        ///< layers that count as all: as asked, or those of the most area
  double all_layers_percent = 0;  ///< of the area, with `count` layers or more
  double any_percent = 0;         ///< of the area, with one layer or more
  double mean_layers = 0;
  Statistics first_height;  ///< [length] mean distance of the first nodes over a triangle from its plane
  Statistics thickness;     ///< [length] the same of the last ones
  Statistics growth;        ///< upper over lower step, of all successive steps up from a corner [-]
};

/// Climbs from each wall triangle through wedges and hexahedra, from a face to the opposite one; also through pyramids
/// from triangle to triangle, where one of the lines rests. The layers of a triangle are the cells up to the last wedge
/// or hexahedron.
/// \param start  (n_triangles) face of a cell at the wall, as certify::match_wall gives it; nothing: no layers
/// \param count  layers that count as all; nothing: the number that most of the area with layers has
/// Cost: O(n_cells), on all threads; the same bits whatever their number.
IdVector<PatchId, WallPatchLayers> wall_layers(const mesh::VolumeMesh& mesh, const mesh::SurfaceMesh& wall,
                                               const IdVector<FaceId, std::optional<mesh::FaceName>>& start,
                                               std::optional<std::uint32_t> count = std::nullopt);

}  // namespace nearwall::quality

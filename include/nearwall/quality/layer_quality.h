#pragma once

#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/quality/statistics.h"

namespace nearwall::quality {

/// Quality of all cells of the layers. Definitions: docs/theory/quality.md.
struct LayerQuality {
  Statistics scaled_jacobian;  ///< over cells [-]
  Statistics aspect_ratio;     ///< over cells [-]
  Statistics growth;           ///< over all pairs of successive layers of a line: upper height / lower height [-]
  Statistics volume_ratio;     ///< over pairs of successive cells of a column: larger / smaller volume [-]
  Statistics orthogonality;  ///< over wall triangles by area: largest angle of a first layer's line to the normal [deg]

  /// Where the smallest scaled Jacobian is, for the report.
  FrontFaceId worst_column;
  Level worst_level = 0;  ///< of the bottom of the cell
};

/// Cells are streamed column by column; memory is constant but for O(n_wall_faces) of the wall statistics. On all
/// threads, the same bits at any number of them. Cost: O(n_cells).
LayerQuality layer_quality(const mesh::LayerMesh& layers, const mesh::SurfaceMesh& wall);

}  // namespace nearwall::quality

#pragma once

#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/quality/statistics.h"
#include "nearwall/volume/rest_boundary.h"

namespace nearwall::volume {

/// Quality of the tetrahedra. Definitions: docs/theory/quality.md.
struct FillQuality {
  quality::Statistics smallest_dihedral;  ///< of each tetrahedron [deg]
  quality::Statistics radius_edge;        ///< radius of the circumscribed sphere over the shortest edge [-]
  /// Of two neighbours: the larger size over the smaller one, sizes being cube roots of volumes [-].
  quality::Statistics size_ratio;
  /// At each triangle of the front over a layer: height of the tetrahedron on it over that of the last layer [-].
  quality::Statistics interface_ratio;
};

/// Cost: O(n_tetrahedra), on all threads; the same bits whatever their number.
FillQuality fill_quality(const mesh::LayerMesh& layers, const RestBoundary& rest, const Fill& fill);

}  // namespace nearwall::volume

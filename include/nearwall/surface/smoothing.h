#pragma once

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"

namespace nearwall::surface {

enum class SmoothingFilter { None, Laplacian, Taubin };

struct SmoothingOptions {
  SmoothingFilter filter = SmoothingFilter::Taubin;
  int iterations = 0;   ///< sweeps; a Taubin sweep is one lambda and one mu step
  double lambda = 0.5;  ///< step of the Laplacian, (0, 1]
  double mu = -0.53;    ///< counter-step of Taubin, < -lambda (Taubin 1995)
};

/// Smooths the normals of the vertices. Corners, ridge ends and tips keep theirs; ridge vertices look at their two
/// neighbours along the ridge only; all others at their ring. A new direction must see every face round its vertex: the
/// sign is exact, and it keeps at least half of the room that the normal given for the vertex has to the edge of
/// its visibility cone; where it would leave that, it is drawn back along the arc. Blind vertices keep their normal.
/// \param normals  (n_vertices), changed in place; `max_angle` follows the direction
/// \throws InputError if an option is out of range
/// Cost: O(n_faces * iterations), on all threads; the same bits at any number of them.
void smooth_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                    const SmoothingOptions& options, IdVector<VertexId, PointNormal>& normals);

}  // namespace nearwall::surface

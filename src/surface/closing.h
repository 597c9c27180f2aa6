#pragma once

#include <span>

#include "surface/edge_groups.h"

namespace nearwall::surface {

/// The weld length that closes all open edges of the surface, to three decimal digits: 0 if there is none, because
/// they bound a hole rather than a crack, or because welding by as much would collapse triangles.
/// \param open_edges  all halfedges without a partner    Cost: O(n)
double closing_tolerance(const mesh::SurfaceMesh& surface, std::span<const HalfedgeId> open_edges);

}  // namespace nearwall::surface

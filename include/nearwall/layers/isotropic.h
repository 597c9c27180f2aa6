#pragma once

#include <span>

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"

namespace nearwall::layers {

/// Height at which a layer over each vertex is as high as the triangles there are wide: that of a regular tetrahedron
/// over a triangle of their mean area, evened out along the surface so that neighbours differ little.
/// Source: docs/theory/asked.md, Eq. (2)
/// \returns (n_vertices) [length]    Cost: O(n), on all threads
IdVector<VertexId, double> isotropic_heights(const mesh::SurfaceMesh& surface, const mesh::Topology& topology);

/// The level whose layer comes closest to a height, in ratio: 1 … heights.size(), the lowest if there are several.
/// Source: docs/theory/asked.md, Eq. (3)
/// \param heights  of the layers from the wall up, > 0, one at least
Level isotropic_level(std::span<const double> heights, double height);

}  // namespace nearwall::layers

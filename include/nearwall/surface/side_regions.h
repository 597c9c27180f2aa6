#pragma once

#include <cstdint>
#include <vector>

#include "nearwall/mesh/side_planes.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::surface {

/// What a patch is to the layers beside it: nothing; a plane of symmetry; a flat opening of the domain (inlet, outlet,
/// side of a far field).
enum class SideRole : std::uint8_t { None, Symmetry, Opening };

/// A connected part of patches of one role, flat or not.
struct SideRegion {
  SideRole role = SideRole::None;
  std::vector<FaceId> faces;
  mesh::SidePlane plane;  ///< the normal is that of its faces
  double off_plane = 0;   ///< largest distance of a vertex from the plane [length]
  bool is_flat = false;
  bool is_curved = false;  ///< most of its outline goes on over little bends, in the same role: not flat
};

/// Connected parts of the patches with a role, divided where they bend; parts of different roles that lie beside each
/// other in one plane have the same plane. A part is flat if no vertex is farther from its
/// plane than a hundred thousandth of its extent, or than what coordinates lose as single precision floats. A plane
/// normal to an axis, within that, is made exactly so, and such planes at the same place are one.
/// Cost: O(n log n) for the n faces with a role.    Source: docs/theory/planes.md
std::vector<SideRegion> find_side_regions(const mesh::SurfaceMesh& surface, const IdVector<PatchId, SideRole>& role);

/// Moves the vertices of flat regions onto their planes. \returns  the largest way that one is moved [length]
double flatten(const std::vector<SideRegion>& regions, mesh::SurfaceMesh& surface);

}  // namespace nearwall::surface

#pragma once

#include <string>
#include <vector>

#include "nearwall/surface/admission.h"
#include "nearwall/surface/side_regions.h"

namespace nearwall::surface {

/// A wall without the flat sides on which its layers land.
struct OpenWall {
  mesh::SurfaceMesh surface;                    ///< the faces that stay, in their order, and their points
  IdVector<FaceId, FaceId> face;                ///< number in the closed surface
  IdVector<VertexId, VertexId> vertex;          ///< number in the closed surface
  mesh::SidePlanes planes;                      ///< normals into the domain
  std::vector<std::vector<FaceId>> side_faces;  ///< (n_planes) faces of the closed surface that were taken out
  std::vector<PatchId> patch;                   ///< (n_planes) of the first of these faces
  std::vector<SideRole> role;                   ///< (n_planes)
  /// (n_faces) 1: behind a plane of symmetry, where the fluid does not reach; empty: none.
  IdVector<FaceId, char> is_cut_off;
  std::vector<std::string> notes;  ///< sides on which layers do not land, and why
};

struct OpenWallOptions {
  IdVector<PatchId, char> has_layers;  ///< (n_patches)
  FluidSide fluid = FluidSide::Outside;
  bool lands = true;  ///< false: layers end at all sides but the cuts of bodies, as beside patches without layers
};

/// Takes those regions out on which the layers of neighbouring patches land: flat ones that meet these patches in some
/// concave edge, and what lies beside them in their plane. At their other edges lines are held. Symmetric ones of an
/// external flow are the cuts of bodies: they go whatever is beside them, and the domain's side is the rest of their
/// plane. At all other regions layers end as at patches without layers.
///
/// \param closed   admitted, normals into the fluid, flat regions flattened
/// \param regions  as find_side_regions gives them for `closed`
/// \throws GeometryError  if a body lies on both sides of its plane of symmetry or touches it beside its cut
OpenWall open_at_sides(const mesh::SurfaceMesh& closed, const std::vector<SideRegion>& regions,
                       const IdVector<FaceId, char>& is_wetted, const OpenWallOptions& options);

}  // namespace nearwall::surface

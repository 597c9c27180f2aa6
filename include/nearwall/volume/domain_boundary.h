#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "nearwall/mesh/boundary.h"
#include "nearwall/mesh/cell_faces.h"
#include "nearwall/volume/hybrid_mesh.h"

namespace nearwall::volume {

/// The boundary of a mesh: wall, sides of the layers, then rest of the planes and far field, or else the front.
struct DomainBoundary {
  std::vector<NodeIndex> node;          ///< (n_points) of the mesh
  std::vector<Vec3> points;             ///< (n_points)
  std::vector<mesh::FaceNodes> faces;   ///< (n_faces) counterclockwise seen from outside; kNoNode fourth: a triangle
  std::vector<PatchId> patch;           ///< (n_faces)
  std::vector<FaceId> wall_face;        ///< (n_faces) of the wall; invalid elsewhere
  std::vector<mesh::PlaneIndex> plane;  ///< (n_faces) kNoPlane on wall and front

  int size_of(std::size_t face) const { return mesh::size_of(faces[face]); }
};

/// Patch of a face on a plane, from its middle.
using PatchOnPlane = std::function<PatchId(mesh::PlaneIndex plane, const Vec3& middle)>;

/// Wall triangles in the order of the wall, then the sides of the layers plane by plane, from the wall up, then the
/// rest of the planes. Cost: O(n_faces).
DomainBoundary domain_boundary(const mesh::LayerMesh& layers, const certify::CertifiedWall& wall,
                               const RestBoundary& rest, const HybridMesh& mesh, const PatchOnPlane& patch_of);

/// The same of the layers alone: wall triangles that have cells, the sides, the front, which is a patch of its own.
DomainBoundary layers_boundary(const mesh::LayerMesh& layers, const certify::CertifiedWall& wall, PatchId front,
                               const PatchOnPlane& patch_of);

/// As writers read it. \param patches  (n_patches) names and types
mesh::Boundary mesh_boundary(const DomainBoundary& boundary, IdVector<PatchId, mesh::BoundaryPatch> patches);

/// What remains to be shown of the whole once the layers are certified, the boundary of the rest does not meet itself
/// and the tetrahedra fill it (fill.h). Source: docs/theory/planes.md
struct DomainCertificate {
  std::uint64_t n_side_faces = 0;
  /// Sides of the layers that are not convex and counterclockwise, seen along the plane's normal: exact.
  std::uint64_t n_bad_side_faces = 0;
  double cells_volume = 0;     ///< of all cells [length³]
  double enclosed_volume = 0;  ///< within the boundary [length³]
  double summed_volume = 0;    ///< of the cones over the boundary's faces, each counted positive [length³]

  bool is_valid() const { return n_bad_side_faces == 0; }
  /// | cells − enclosed | over the volume that was summed up.
  double closure() const;
};

DomainCertificate certify_domain(const DomainBoundary& boundary, const mesh::SidePlanes* planes, double layers_volume,
                                 const Fill& fill);

}  // namespace nearwall::volume

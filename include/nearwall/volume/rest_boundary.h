#pragma once

#include <array>
#include <vector>

#include "nearwall/certify/certificate.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/side_planes.h"
#include "nearwall/volume/fill.h"

namespace nearwall::volume {

/// In place of a node: the point belongs to no layer.
inline constexpr NodeIndex kNoLayerNode = ~NodeIndex{0};

/// The closed surface round what the layers leave of the domain: the front, triangle for triangle, and what is left of
/// the planes on which the layers land, meshed anew.
struct RestBoundary {
  FillBoundary surface;                      ///< points of the layers first, then those added on planes
  std::vector<NodeIndex> node;               ///< (n_points) of the layer mesh; kNoLayerNode for added points
  std::size_t n_front = 0;                   ///< triangles of the front; the others lie on planes
  std::vector<FrontFaceId> front_face;       ///< (n_front) below
  std::vector<mesh::PlaneIndex> rest_plane;  ///< (n_triangles − n_front)
};

/// Node of a point of certify::FrontSurface; kNoLayerNode beyond the ends of lines and the apices of caps.
NodeIndex node_of_front(const mesh::LayerMesh& layers, std::uint32_t point);

/// Lines in planes that new triangles keep: borders between patches. By plane; those of one line share their ends'
/// bits.
using PlaneBorders = std::vector<std::vector<std::array<Vec3, 2>>>;

/// Triangles on planes are as large as the edges of the layers beside them, and of fronts near the plane, and grow from
/// there at the asked rate; edges between two planes first. Edges of the layers are never split.
/// Borders are kept as edges where they lie in what is left of their plane; those that meet the layers' trace or an
/// edge between two planes are not.
///
/// \pre   the layers are certified
/// \param growth   ratio of an edge to the next one away from the layers, > 1
/// \param borders  (n_planes), or empty
/// Cost: O(n log n). Source: docs/theory/planes.md
RestBoundary rest_boundary(const mesh::LayerMesh& layers, const certify::CertifiedWall& wall, double growth,
                           const PlaneBorders& borders = {});

}  // namespace nearwall::volume

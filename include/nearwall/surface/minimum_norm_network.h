#pragma once

#include "nearwall/core/id_vector.h"
#include "nearwall/core/vec3.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"

namespace nearwall::surface {

struct NetworkNormals {
  IdVector<VertexId, Vec3> direction;  ///< (n_vertices) unit vectors on the side of the axes
  IdVector<VertexId, char> is_axis;    ///< (n_vertices) whether the edges say nothing, and the axis itself stands in
};

/// Normals at all vertices from Nielson's minimum norm network: of all nets of cubics along the edges with one tangent
/// plane at each vertex, the one with the least integral of the squared second derivative over its curves. Each edge is
/// taken as a graph over its projection square to the mean of its ends' axes. Exact where all axes are one; elsewhere
/// the slopes that the tangent planes have there are taken to first order, Eq. (11), and the integral is least for
/// these.
/// \param axes  (n_vertices) any length; usually weighted normals. All z: Nielson's network of the height field z(x, y)
/// \returns  the axis, normalised, where the edges leave the tangent plane open (isolated vertices, all edges along one
///           line or along the axis); zero where that is zero
/// \throws   InputError if a coordinate or an axis is not finite, or an edge too long for doubles
/// Boundaries are free: curves end there with no condition. The same bits at any number of threads and at scales by
/// powers of two. Cost: O(n_faces) time and memory, some 25 products of a vector with the matrix of the network.
/// Source: Bohdal 2017, section 2.3; docs/theory/fitted-normals.md, Eq. (10) to (14).
NetworkNormals minimum_norm_network_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                            const IdVector<VertexId, Vec3>& axes);

}  // namespace nearwall::surface

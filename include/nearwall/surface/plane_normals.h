#pragma once

#include <optional>
#include <span>

#include "nearwall/mesh/side_planes.h"
#include "nearwall/surface/point_normals.h"

namespace nearwall::surface {

/// The direction in a plane that sees all faces best: the largest least cosine with the normals, the minimax of the
/// most visible normal with the direction held in the plane. It is the point nearest to the origin of the convex hull
/// of the normals' parts in the plane. Source: docs/theory/planes.md, Eq. (1).
///
/// \param normals  unit vectors
/// \returns  nullopt if no direction in the plane sees all of them
/// Cost: O(n²) for n normals.
std::optional<Vec3> most_visible_in_plane(std::span<const Vec3> normals, const mesh::SidePlane& plane);

/// Gives the vertices that lie on planes the normal that sees their faces best and stays in their planes: along the
/// edge between two planes where two meet, none where three do. What no such direction sees is not visible.
void hold_in_planes(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                    const mesh::SidePlanes& planes, IdVector<VertexId, PointNormal>& normals);

}  // namespace nearwall::surface

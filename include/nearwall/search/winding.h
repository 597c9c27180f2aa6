#pragma once

#include <span>

#include "nearwall/core/vec3.h"
#include "nearwall/search/self_intersection.h"

namespace nearwall::search {

/// Winding number of closed, oriented triangulations about points, exactly, by counting signed crossings of a ray;
/// degenerate rays are replaced by others until one is generic. +1 inside a surface whose normals point outward.
/// \param include  (n_triangles) triangles that count; empty: all
/// \throws GeometryError if the point lies on the surface.
/// Cost: O(n_triangles) a point, on all threads.
int winding_number(const IndexedTriangles& soup, const Vec3& point, std::span<const char> include = {});

}  // namespace nearwall::search

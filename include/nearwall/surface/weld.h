#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::surface {

/// The point that each point becomes when points within `tolerance` of each other merge.
///
/// Points are visited in the order of their ids: each joins the smallest id among the points kept so far that lie
/// within the tolerance, or is kept itself. So kept points are further apart than the tolerance, no point moves by more
/// than it, and nothing chains: a row of points one tolerance apart does not collapse into one. \param tolerance
/// [length], >= 0; 0: only points with equal coordinates (-0 equals 0) merge \returns          (n_points) id of the
/// kept point; ids of kept points are their own. Points that are not finite merge
///                   only with the very same values
/// \throws InputError if the tolerance is negative or not finite.    Cost: O(n)
std::vector<std::uint32_t> merged_points(std::span<const Vec3> points, double tolerance);

/// The surface with points within `tolerance` of each other made one. Triangles keep their number and patch, also where
/// corners fall together; points keep their order, those that no triangle uses are dropped before anything merges.
/// Point arrays follow: a point that others merge into has the smallest of their values, NaN if one of them is.
/// \throws InputError if the tolerance is negative or not finite.    Cost: O(n)
mesh::SurfaceMesh weld(const mesh::SurfaceMesh& surface, double tolerance);

/// Drops the points that no triangle uses; the others keep their order, and point arrays follow them.
void drop_unused_points(mesh::SurfaceMesh& surface);

}  // namespace nearwall::surface

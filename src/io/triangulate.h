#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"

namespace nearwall::io {

/// Longest polygon that is triangulated: the cost of ear clipping grows with the square of the number of corners.
inline constexpr std::size_t kMostCorners = 4096;

/// Cuts a polygon into corners − 2 triangles, turned as the polygon is.
///
/// Quadrilaterals: along the shorter diagonal, along the other one if only that keeps both triangles turned the same
/// way. More corners: ear clipping in the plane across the mean normal, always the ear with the shortest new side; what
/// is left of a polygon without ears (folded, or all on one line) becomes a fan. The same result, up to the turn, in
/// every scale by powers of two and with the axes permuted.
///
/// \param corners  at least 3 points
/// \param out      triples of 0 … corners.size() − 1 are appended
void triangulate(std::span<const Vec3> corners, std::vector<std::array<std::uint32_t, 3>>& out);

}  // namespace nearwall::io

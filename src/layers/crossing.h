#pragma once

#include <array>

#include "nearwall/core/vec3.h"

namespace nearwall::layers {

/// Which corners of a triangle bear the part of it in which another one crosses it: those with a quarter or more of a
/// point there, in barycentric coordinates. In plain doubles: for choosing what to lower, not for deciding.
/// \returns  1 for each that does; all 0 if no crossing is found, as of triangles that only touch
std::array<char, 3> bearing_corners(const std::array<Vec3, 3>& triangle, const std::array<Vec3, 3>& other);

}  // namespace nearwall::layers

#pragma once

#include <array>

#include "nearwall/core/vec3.h"

namespace nearwall::search {

/// Point of a triangle nearest to p: the nearest of those on its three sides and of p's projection, where that falls
/// inside. In doubles; always a point of the triangle up to rounding, of one without area as well. A corner is returned
/// bit for bit.
Vec3 nearest_point(const std::array<Vec3, 3>& triangle, const Vec3& p);

}  // namespace nearwall::search

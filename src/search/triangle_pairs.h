#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "nearwall/core/vec3.h"

namespace nearwall::search {

/// Whether two triangles meet elsewhere than in the corners and edges that they share by index. Exact. Those of the
/// same three corners do.
bool triangles_meet(std::span<const Vec3> points, const std::array<std::uint32_t, 3>& a,
                    const std::array<std::uint32_t, 3>& b);

}  // namespace nearwall::search

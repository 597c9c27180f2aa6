#pragma once

#include <optional>
#include <span>

#include "nearwall/core/vec3.h"

namespace nearwall::surface {

/// A direction v with n · v > 0 for all normals, if there is any: decided in rational arithmetic on the doubles given.
/// The direction itself is rounded, and in a cone thinner than rounding it may miss a normal.
/// \param normals  finite, at least one, none zero
/// Cost: expected O(n) rational operations. Source: Seidel 1991; docs/theory/normals.md.
std::optional<Vec3> find_seeing_direction(std::span<const Vec3> normals);

}  // namespace nearwall::surface

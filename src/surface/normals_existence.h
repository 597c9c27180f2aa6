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

/// Whether some direction sees all faces between successive points of a ring and the apex, decided for the points given
/// rather than for their normals, which are rounded. Faces without area are passed over.
/// \param ring  finite, counterclockwise seen from outside    Cost: as above.
bool some_direction_sees(const Vec3& apex, std::span<const Vec3> ring);

}  // namespace nearwall::surface

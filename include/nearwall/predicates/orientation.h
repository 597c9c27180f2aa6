#pragma once

#include "nearwall/core/vec3.h"

namespace nearwall::predicates {

enum class Sign : int { Negative = -1, Zero = 0, Positive = 1 };

/// Exact sign of (b − a) × (c − a) · (d − a): positive if d lies on the side of the triangle (a, b, c) to which its
/// normal points, zero if the four points are coplanar. Doubles with an error bound first (Shewchuk 1997), exact after.
Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Whether the triangle has no area: exact.
bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c);

/// Exact sign of n · v for the double vectors as given.
Sign sign_of_dot(const Vec3& n, const Vec3& v);

/// Exact sign of (a × b) · c for the double vectors as given.
Sign sign_of_determinant(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace nearwall::predicates

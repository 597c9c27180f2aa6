#pragma once

#include "nearwall/predicates/orientation.h"

namespace nearwall::predicates {

/// Exact side of the bilinear patch over the corners a, b, c, d, for a point p of their tetrahedron: positive nearer
/// the edge a c, negative nearer the edge b d, zero on the patch. Sign of αγ − βδ in p's barycentric coordinates.
/// Doubles with an error bound first, exact after. \throws InputError  if a coordinate is not finite. Source:
/// docs/theory/certificate.md, Eq. (2).
Sign patch_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p);

}  // namespace nearwall::predicates

#pragma once

#include "nearwall/core/vec3.h"

namespace nearwall::surface {

/// Right-handed frame with its third vector along an axis.
struct TangentFrame {
  Vec3 t1, t2, n;
};

/// Frame along the unit vector `axis` whose first vector points as nearly along `d` as it can. It depends on nothing
/// but the two vectors, so permuting the axes permutes it (an odd permutation turns t2 round). \returns zero t1 and t2
/// if d is along the axis
inline TangentFrame tangent_frame(const Vec3& axis, const Vec3& d) {
  Vec3 t1 = normalized(d - axis * dot(axis, d));
  // What rounding left along the axis is large if d is nearly along it.
  t1 = normalized(t1 - axis * dot(axis, t1));
  return {t1, cross(axis, t1), axis};
}

/// Upward normal of the plane with slopes a and b along t1 and t2; docs/theory/fitted-normals.md, Eq. (1).
inline Vec3 normal_of_slopes(const TangentFrame& frame, double a, double b) {
  return normalized(frame.n - frame.t1 * a - frame.t2 * b);
}

}  // namespace nearwall::surface

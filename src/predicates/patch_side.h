#pragma once

#include "nearwall/predicates/patch_side.h"
#include "predicates/formulas.h"

namespace nearwall::predicates {

/// Products of the barycentric coordinates of opposite corners, times the square of the tetrahedron's volume.
template <class T>
T patch_form(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p) {
  return orientation_determinant<T>(p, b, c, d) * orientation_determinant<T>(a, b, p, d) -
         orientation_determinant<T>(a, p, c, d) * orientation_determinant<T>(a, b, c, p);
}

namespace exact {

Sign patch_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p);

}  // namespace exact

}  // namespace nearwall::predicates

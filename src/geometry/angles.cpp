#include "nearwall/geometry/angles.h"

#include <cmath>

#include "nearwall/geometry/arctangent.h"

namespace nearwall::geometry {

double angle_between(const Vec3& a, const Vec3& b) { return angle_from(norm(cross(a, b)), dot(a, b)); }

double corner_angle(const Vec3& apex, const Vec3& b, const Vec3& c) { return angle_between(b - apex, c - apex); }

double edge_turn(const Vec3& left, const Vec3& right, const Vec3& along) {
  // On a box, top left and side right of an edge: the normal turns from left to right about it, (left x right) . along
  // > 0.
  const double size = angle_between(left, right);
  return dot(cross(left, right), along) < 0 ? -size : size;
}

Vec3 slerp(const Vec3& a, const Vec3& b, double t) {
  const double angle = angle_between(a, b);
  const double sine = std::sin(angle);
  if (!(sine > 0)) return a;
  return normalized(a * std::sin((1 - t) * angle) + b * std::sin(t * angle));
}

}  // namespace nearwall::geometry

#include "search/nearest_point.h"

namespace nearwall::search {

namespace {

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 ab = b - a;
  const double along = dot(ab, p - a), length = dot(ab, ab);
  if (!(along > 0)) return a;
  return along < length ? a + along / length * ab : b;
}

}  // namespace

Vec3 nearest_point(const std::array<Vec3, 3>& triangle, const Vec3& p) {
  const auto& [a, b, c] = triangle;
  Vec3 nearest = nearest_on_segment(a, b, p);
  const auto offer = [&](const Vec3& q) {
    if (squared_norm(q - p) < squared_norm(nearest - p)) nearest = q;
  };
  offer(nearest_on_segment(b, c, p));
  offer(nearest_on_segment(c, a, p));
  // Barycentric coordinates of the projection, times one factor.
  const Vec3 normal = cross(b - a, c - a);
  const double at_a = dot(normal, cross(c - b, p - b));
  const double at_b = dot(normal, cross(a - c, p - c));
  const double at_c = dot(normal, cross(b - a, p - a));
  if (at_a > 0 && at_b > 0 && at_c > 0) {
    const double sum = sum3(at_a, at_b, at_c);
    offer(a + at_b / sum * (b - a) + at_c / sum * (c - a));
  }
  return nearest;
}

}  // namespace nearwall::search

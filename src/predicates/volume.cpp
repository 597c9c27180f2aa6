#include "nearwall/predicates/volume.h"

#include <cmath>

#include "nearwall/geometry/measures.h"
#include "predicates/bounded.h"
#include "predicates/exact.h"

namespace nearwall::predicates {

namespace {

Vec3 absolute(const Vec3& a) { return {std::abs(a.x()), std::abs(a.y()), std::abs(a.z())}; }

/// The cross product with every term positive: what its rounding is in proportion to.
Vec3 cross_of_sizes(const Vec3& a, const Vec3& b) {
  const Vec3 p = absolute(a), q = absolute(b);
  return {p.y() * q.z() + p.z() * q.y(), p.z() * q.x() + p.x() * q.z(), p.x() * q.y() + p.y() * q.x()};
}

}  // namespace

EnclosedVolume enclosed_volume(std::size_t n_triangles, const std::function<Triangle(std::size_t)>& triangle) {
  if (n_triangles == 0) return {};
  // Cones about a point of the surface: far from the origin they lose no digits.
  const Vec3 tip = triangle(0)[0];
  geometry::CompensatedSum six_volumes;
  double sizes = 0, underflow = 0;
  for (std::size_t i = 0; i < n_triangles; ++i) {
    const Triangle t = triangle(i);
    const Vec3 a = t[0] - tip, b = t[1] - tip, c = t[2] - tip;
    six_volumes.add(dot(a, cross(b, c)));
    sizes += dot(absolute(a), cross_of_sizes(b, c));
    underflow += kUnderflow * (1.0 + max_norm(a));
  }
  const double value = six_volumes.value();
  const auto n = static_cast<double>(n_triangles);
  const double bound = (32.0 + 2.0 * n * (n * kRoundoff)) * kRoundoff * sizes + underflow;  // Eq. (12)
  if (value > bound) return {Sign::Positive, value / 6};
  if (value < -bound) return {Sign::Negative, value / 6};
  return {exact::enclosed_volume(n_triangles, triangle), value / 6};
}

}  // namespace nearwall::predicates

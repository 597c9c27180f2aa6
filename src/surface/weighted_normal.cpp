#include <algorithm>

#include "nearwall/core/errors.h"
#include "nearwall/surface/normals.h"
#include "surface/corner_weight.h"
#include "surface/power_of_two.h"

namespace nearwall::surface {

namespace {

/// Below this sine of its angle a corner is thin: b x c cancels to less than 1e-13 of its size in doubles.
constexpr double kThin = 0x1p-9;

/// Vectors of long doubles, whose eleven more bits make up for what thin corners cancel.
struct LongVec {
  long double x, y, z;
};

LongVec difference(const Vec3& a, const Vec3& b) {
  return {static_cast<long double>(a.x()) - static_cast<long double>(b.x()),
          static_cast<long double>(a.y()) - static_cast<long double>(b.y()),
          static_cast<long double>(a.z()) - static_cast<long double>(b.z())};
}

/// (p - apex) x (q - apex), times `scale` twice.
Vec3 area_vector_of_thin(const Vec3& apex, const Vec3& p, const Vec3& q, double scale) {
  const LongVec b = difference(p, apex), c = difference(q, apex);
  const long double s = static_cast<long double>(scale) * static_cast<long double>(scale);
  return {static_cast<double>((b.y * c.z - b.z * c.y) * s), static_cast<double>((b.z * c.x - b.x * c.z) * s),
          static_cast<double>((b.x * c.y - b.y * c.x) * s)};
}

/// Power of two that brings the longest edge at the apex near 1, so that no product leaves the range of doubles.
double scale_of(const Vec3& apex, std::span<const Vec3> ring) {
  double longest = 0;
  for (const Vec3& p : ring) {
    const Vec3 edge = p - apex;
    if (!is_finite(edge)) throw InputError("weighted_normal: expected finite points, found one that is not");
    longest = std::max(longest, max_norm(edge));
  }
  return 1 / power_above(longest);
}

}  // namespace

Vec3 weighted_normal(Weight weight, const Vec3& apex, std::span<const Vec3> ring, bool closed) {
  const double scale = scale_of(apex, ring);
  const std::size_t n_faces = closed ? ring.size() : std::max<std::size_t>(ring.size(), 1) - 1;
  Vec3 sum;
  for (std::size_t k = 0; k < n_faces; ++k) {
    const Vec3 &p = ring[k], &q = ring[k + 1 < ring.size() ? k + 1 : 0];
    const Vec3 b = (p - apex) * scale, c = (q - apex) * scale;
    Vec3 area_vector = cross(b, c);
    const double thin = kThin * kThin * (squared_norm(b) * squared_norm(c));
    if (squared_norm(area_vector) < thin) area_vector = area_vector_of_thin(apex, p, q, scale);
    if (area_vector == Vec3{}) continue;
    const FaceCorner corner((q - p) * scale, b, c, area_vector);
    sum += area_vector * (corner_weight(weight, corner) / corner.sine());
  }
  return normalized(sum);
}

}  // namespace nearwall::surface

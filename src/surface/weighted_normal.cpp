#include <algorithm>
#include <array>
#include <cmath>

#include "nearwall/core/errors.h"
#include "nearwall/surface/normals.h"
#include "surface/corner_weight.h"
#include "surface/power_of_two.h"

namespace nearwall::surface {

namespace {

/// Below this sine of its angle a corner is thin: b x c cancels to less than 1e-13 of its size in doubles.
constexpr double kThin = 0x1p-9;

/// Two doubles whose sum is twice as precise: `rest` is what `value` was rounded by.
struct Double2 {
  double value, rest;
};

/// a - b, exactly (Knuth's TwoSum).
Double2 difference(double a, double b) {
  const double value = a - b, minus_b = value - a;
  return {value, (a - (value - minus_b)) - (b + minus_b)};
}

/// a d - b c to some 2^-100 of the products: these are held exactly, and so are their small corrections.
double determinant(const Double2& a, const Double2& b, const Double2& c, const Double2& d) {
  const double ad = a.value * d.value, bc = b.value * c.value;
  const Double2 large = difference(ad, bc);
  const double rounded = std::fma(a.value, d.value, -ad) - std::fma(b.value, c.value, -bc);
  const double corrections = (a.value * d.rest - b.value * c.rest) + (a.rest * d.value - b.rest * c.value);
  return large.value + (large.rest + rounded + corrections);
}

/// (p - apex) x (q - apex), times `scale` twice, where it cancels.
Vec3 area_vector_of_thin(const Vec3& apex, const Vec3& p, const Vec3& q, double scale) {
  std::array<Double2, 3> b, c;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    b[k] = difference(p[axis], apex[axis]), c[k] = difference(q[axis], apex[axis]);
    b[k].value *= scale, b[k].rest *= scale, c[k].value *= scale, c[k].rest *= scale;
  }
  return {determinant(b[1], b[2], c[1], c[2]), determinant(b[2], b[0], c[2], c[0]),
          determinant(b[0], b[1], c[0], c[1])};
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

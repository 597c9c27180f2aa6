#pragma once

#include <cmath>

#include "nearwall/core/vec3.h"

namespace nearwall::shapes {

/// Unit vector in the (x, z) plane at an angle from x towards z [rad]. What is zero but for the rounding of pi is zero,
/// so that a cap normal to an axis is flat bit for bit.
inline Vec3 heading_vector(double angle) {
  /// Sines and cosines of the multiples of a quarter turn up to a whole one are rounded to less than this.
  constexpr double kZero = 1e-15;
  const auto clean = [](double v) { return std::abs(v) < kZero ? 0 : v; };
  return {clean(std::cos(angle)), 0, clean(std::sin(angle))};
}

/// A vector in the (x, z) plane turned by a quarter, from x towards z.
inline Vec3 across(const Vec3& heading) { return {-heading.z(), 0, heading.x()}; }

}  // namespace nearwall::shapes

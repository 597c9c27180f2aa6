#pragma once

#include <array>
#include <cmath>

#include "nearwall/core/vec3.h"

namespace nearwall::search {

/// Rays that are tried one after another until one meets no edge.
inline constexpr int kMaxRays = 64;

/// The ray number k: along an axis first, since its boxes sort out most cheaply, then in directions that come from the
/// golden ratio's relatives, so that no two are alike and none is likely to hit an edge.
inline Vec3 ray_direction(int k) {
  if (k == 0) return {1.0, 0.0, 0.0};
  constexpr std::array<double, 3> kRatio{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  Vec3 d;
  for (int axis = 0; axis < 3; ++axis) {
    const double v = k * kRatio[static_cast<std::size_t>(axis)];
    d[axis] = 2.0 * (v - std::floor(v)) - 1.0;
  }
  return d;
}

}  // namespace nearwall::search

#pragma once

#include <algorithm>
#include <cmath>

namespace nearwall::surface {

/// Power of two just above a length. To measure in units of it is exact, so all scales give the same bits, and squares
/// of what is left stay in range. Held to powers whose reciprocals are doubles, too: at the very ends of the range
/// lengths are merely near 1.
inline double power_above(double length) {
  constexpr int kLeast = -1022, kGreatest = 1023;
  int exponent = 0;
  std::frexp(length, &exponent);
  return std::ldexp(1.0, std::clamp(exponent, kLeast, kGreatest));
}

}  // namespace nearwall::surface

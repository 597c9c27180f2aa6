#pragma once

#include <cmath>
#include <numbers>

namespace nearwall::geometry {

/// Angle whose sine and cosine are in the ratio given, in [0, pi]; 0 where both are 0. What std::atan2 gives, to 1e-15
/// of its size, but with the same bits on every machine and in under half the time.
/// \param sine  >= 0; any common factor, but finite    \param cosine  any sign
/// Not a number if one of them is not.
/// Source: a polynomial of least error (5e-18 of the angle) for arctan(x) / x in x^2, |x| <= tan(pi / 8).
inline double angle_from(double sine, double cosine) {
  constexpr double kTangentOfEighth = 0.41421356237309503;
  constexpr double c[] = {-0x1.5555555555555p-2, 0x1.999999999934cp-3, -0x1.2492492436201p-3, 0x1.c71c71853d7fap-4,
                          -0x1.745d0b28a7e37p-4, 0x1.3b1263064f6b9p-4, -0x1.10fa77b1a6d57p-4, 0x1.dfe6497e96323p-5,
                          -0x1.a0999c632b6edp-5, 0x1.4162c02b1dda3p-5, -0x1.3a31b1c0fd3b7p-6};
  const double size = std::abs(cosine);
  const double low = sine < size ? sine : size, high = sine < size ? size : sine;
  if (high == 0) return 0.0;
  // The angle below pi / 4 whose tangent is low / high, counted from pi / 4 where it is nearer to that.
  const bool is_steep = low > kTangentOfEighth * high;
  const double x = (is_steep ? low - high : low) / (is_steep ? low + high : high);
  const double z = x * x, z2 = z * z, z4 = z2 * z2;
  // Pairs first: a chain of eleven products would wait for each other.
  const double p = ((c[0] + c[1] * z) + (c[2] + c[3] * z) * z2) +
                   (((c[4] + c[5] * z) + (c[6] + c[7] * z) * z2) + ((c[8] + c[9] * z) + c[10] * z2) * z4) * z4;
  const double folded = x + x * z * p;
  const double below = is_steep ? std::numbers::pi / 4 + folded : folded;
  const double upright = sine < size ? below : std::numbers::pi / 2 - below;
  return cosine < 0 ? std::numbers::pi - upright : upright;
}

/// Angle between two unit vectors at this squared distance, in [0, pi]; more than 4 counts as 4.
inline double angle_of_chord(double squared_chord) {
  const double squared_sine = squared_chord > 4 ? 1.0 : 0.25 * squared_chord;
  return 2.0 * angle_from(std::sqrt(squared_sine), std::sqrt(1.0 - squared_sine));
}

}  // namespace nearwall::geometry

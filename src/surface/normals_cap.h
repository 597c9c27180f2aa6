#pragma once

#include <array>
#include <cmath>
#include <span>

#include "nearwall/core/vec3.h"

namespace nearwall::surface {

/// Cap of the unit sphere that holds a set of unit vectors.
struct Cap {
  Vec3 centre;                      ///< unit vector; zero if no cap smaller than a hemisphere was found
  double squared_chord = 0;         ///< squared distance of the centre from the farthest vector
  std::array<std::size_t, 4> seat;  ///< vectors that the cap rests on, or that no hemisphere seems to hold together
  std::size_t n_seat = 0;
};

/// Smallest cap round unit vectors: an active set of two or three of them, enlarged by the farthest vector outside
/// until there is none (Elzinga & Hearn 1972); within a set of four, all pairs, then all triples. Distances are chords
/// |v - c|, which keep their digits in small caps where cosines lose half of them. \param units  at least one Cost:
/// O(n) for each vector that enters the active set, a handful in practice. No memory is allocated.
Cap smallest_cap(std::span<const Vec3> units);

/// Direction in the middle of the arc between the unit vectors a and b. Not normalised.
inline Vec3 centre_of_pair(const Vec3& a, const Vec3& b) {
  const Vec3 sum = a + b, difference = a - b;
  const double squared_sum = squared_norm(sum), squared_difference = squared_norm(difference);
  if (squared_sum >= squared_difference) return sum;
  // The sum of nearly opposite vectors is small, and rounding of their lengths tilts it: make it square to a - b again.
  return sum - difference * (dot(sum, difference) / squared_difference);
}

/// a / |a| for a vector that is not zero: the same bits as `normalized`, without its detour where |a|² is in range.
inline Vec3 unit_vector(const Vec3& a) {
  constexpr double kSmallest = 0x1p-900, kLargest = 0x1p900;
  const double squared = squared_norm(a);
  return squared > kSmallest && squared < kLargest ? a / std::sqrt(squared) : normalized(a);
}

}  // namespace nearwall::surface

#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "nearwall/core/vec3.h"

namespace nearwall::shapes {

/// Number of equal pieces, none longer than `size` (up to rounding), into which a length is cut; at least `minimum`.
/// \throws InputError if there would be more pieces than a surface can number
int n_segments(double length, double size, int minimum = 1);

/// n + 1 numbers from a to b at equal distances; both ends exactly.
std::vector<double> uniform(double a, double b, int n);

/// How a curve is cut into edges.
struct Spacing {
  double size = 0;                                            ///< longest edge [length]
  double max_turn = std::numeric_limits<double>::infinity();  ///< largest angle between neighbouring edges [rad]
  int minimum = 1;                                            ///< least number of edges
};

/// Parameters 0 = t[0] < … < t[n] = 1 of points along a smooth curve over [0, 1]: edges as long as `spacing` lets them
/// be, growing by no more than kEdgeGrowth from one to the next.
std::vector<double> graded_parameters(const std::function<Vec3(double)>& curve, const Spacing& spacing);

/// Largest ratio of neighbouring edges along a graded curve, less one.
inline constexpr double kEdgeGrowth = 0.2;

}  // namespace nearwall::shapes

#include "spacing/law.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nearwall/core/errors.h"

namespace nearwall::spacing {

namespace {

/// (r^n - 1) / (r - 1), Eq. (2), without cancellation near r = 1, Eq. (3).
double geometric_sum(double growth, int count) {
  const double excess = growth - 1;
  if (excess == 0) return count;
  return std::expm1(count * std::log1p(excess)) / excess;
}

std::vector<double> geometric_heights(double growth, int count) {
  std::vector<double> heights(static_cast<std::size_t>(count), 1.0);
  for (std::size_t k = 1; k < heights.size(); ++k) heights[k] = heights[k - 1] * growth;
  return heights;
}

/// Eq. (5)
std::vector<double> accelerating_heights(double growth, int count, const Acceleration& a) {
  std::vector<double> heights(static_cast<std::size_t>(count), 1.0);
  double ratio = std::min(growth, a.cap);
  for (auto k = static_cast<std::size_t>(a.constant_layers); k < heights.size(); ++k) {
    heights[k] = heights[k - 1] * ratio;
    ratio = std::min(ratio * (1 + a.rate), a.cap);
  }
  return heights;
}

/// Bisection to the last bit for an increasing function: as robust as can be, and some 60 evaluations of O(count).
template <class Function>
double bisect(double low, double high, double target, Function&& value) {
  while (true) {
    const double middle = low + 0.5 * (high - low);
    if (middle <= low || middle >= high) break;
    (value(middle) < target ? low : high) = middle;
  }
  return std::abs(value(low) - target) <= std::abs(value(high) - target) ? low : high;
}

/// Eq. (7): the stretching for which the second layer is `growth` times as high as the first.
double tanh_stretching(double growth, int count) {
  if (growth == 1 || count < 2) return 0;
  const auto ratio_of_first_two = [count](double delta) {
    return std::cosh(delta) / std::cosh(delta * (1 - 2.0 / count));
  };
  // exp(x) / 2 <= cosh(x) <= exp(x): the ratio is at least exp(2 delta / count) / 2, so this stretching is enough.
  const double enough = 0.5 * count * std::log(2 * growth);
  return bisect(0, enough, growth, ratio_of_first_two);
}

/// Eq. (6). A product of two quotients, since that of two hyperbolic cosines may overflow.
std::vector<double> tanh_heights(double growth, int count) {
  const double delta = tanh_stretching(growth, count);
  const auto slope = [&](std::size_t level) { return std::cosh(delta * (1 - static_cast<double>(level) / count)); };
  std::vector<double> heights(static_cast<std::size_t>(count), 1.0);
  for (std::size_t k = 1; k < heights.size(); ++k) heights[k] = (slope(0) / slope(k)) * (slope(1) / slope(k + 1));
  return heights;
}

}  // namespace

std::vector<double> relative_heights(Law law, double growth, int count, const Acceleration& acceleration) {
  switch (law) {
    case Law::Geometric:
      return geometric_heights(growth, count);
    case Law::Accelerating:
      return accelerating_heights(growth, count, acceleration);
    case Law::Tanh:
      return tanh_heights(growth, count);
    case Law::Table:
      break;
  }
  throw InternalError("a table of heights has no growth to compute heights from");
}

double relative_thickness(Law law, double growth, int count, const Acceleration& acceleration) {
  if (law == Law::Geometric) return geometric_sum(growth, count);
  const std::vector<double> heights = relative_heights(law, growth, count, acceleration);
  return std::accumulate(heights.begin(), heights.end(), 0.0);
}

double largest_growth(Law law, const Acceleration& acceleration) {
  return law == Law::Accelerating ? acceleration.cap : kMaxGrowth;
}

double solve_growth(Law law, int count, double ratio, const Acceleration& acceleration) {
  return bisect(1, largest_growth(law, acceleration), ratio,
                [&](double growth) { return relative_thickness(law, growth, count, acceleration); });
}

}  // namespace nearwall::spacing

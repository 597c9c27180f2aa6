#include "shapes/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"

namespace nearwall::shapes {
namespace {

/// More pieces than this along one edge would make surfaces that no 32-bit id can number.
constexpr double kMaxSegments = 4000;

/// A length that is a whole number of sizes up to rounding is cut into that number.
constexpr double kRoundingSlack = 1e-9;

/// Points at which a curve is looked at to find its length and curvature.
constexpr int kCurveSamples = 4000;

/// Longest edge allowed at each sample, before grading: the size, or less where the curve turns.
std::vector<double> wanted_edges(const std::vector<Vec3>& points, const Spacing& spacing) {
  const std::size_t n = points.size();
  std::vector<double> wanted(n, spacing.size);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vec3 before = points[i] - points[i - 1], after = points[i + 1] - points[i];
    const double turn = geometry::angle_between(before, after);
    const double length = 0.5 * (norm(before) + norm(after));
    if (turn * spacing.size > spacing.max_turn * length) wanted[i] = spacing.max_turn * length / turn;
  }
  if (n > 2) {
    wanted[0] = wanted[1];
    wanted[n - 1] = wanted[n - 2];
  }
  return wanted;
}

}  // namespace

int n_segments(double length, double size, int minimum) {
  const double n = std::ceil(length / size * (1 - kRoundingSlack));
  if (!(n <= kMaxSegments)) {
    throw InputError(fmt::format("size {:g} cuts a length of {:g} into more than {:g} pieces; give a larger size", size,
                                 length, kMaxSegments));
  }
  return std::max(minimum, static_cast<int>(n));
}

std::vector<double> uniform(double a, double b, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(a + (b - a) * (static_cast<double>(i) / n));
  values.push_back(b);
  return values;
}

std::vector<double> graded_parameters(const std::function<Vec3(double)>& curve, const Spacing& spacing) {
  const std::vector<double> t = uniform(0, 1, kCurveSamples);
  std::vector<Vec3> points;
  for (const double ti : t) points.push_back(curve(ti));
  std::vector<double> edge = wanted_edges(points, spacing);
  for (std::size_t i = 1; i < edge.size(); ++i) {
    edge[i] = std::min(edge[i], edge[i - 1] + kEdgeGrowth * distance(points[i], points[i - 1]));
  }
  for (std::size_t i = edge.size() - 1; i-- > 0;) {
    edge[i] = std::min(edge[i], edge[i + 1] + kEdgeGrowth * distance(points[i], points[i + 1]));
  }

  // The number of edges up to each sample, as a real number; the points lie where it is whole.
  std::vector<double> count{0};
  for (std::size_t i = 1; i < t.size(); ++i) {
    count.push_back(count.back() + distance(points[i], points[i - 1]) * 0.5 * (1 / edge[i] + 1 / edge[i - 1]));
  }
  const int n = n_segments(count.back(), 1, spacing.minimum);
  std::vector<double> result{0};
  std::size_t i = 1;
  for (int k = 1; k < n; ++k) {
    const double target = count.back() * k / n;
    while (count[i] < target) ++i;
    const double fraction = (target - count[i - 1]) / (count[i] - count[i - 1]);
    result.push_back(t[i - 1] + fraction * (t[i] - t[i - 1]));
  }
  result.push_back(1);
  return result;
}

}  // namespace nearwall::shapes

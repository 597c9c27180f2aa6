#include "swept_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nearwall::layers {

namespace {

/// Smallest t > 0 at which a + b t + c t² falls to zero, given a > 0; infinity if it never does.
double first_root(double a, double b, double c) {
  // Cubes of lengths: their squares would leave the range of doubles on very large or small bodies.
  const double size = std::max({a, std::abs(b), std::abs(c)});
  a /= size, b /= size, c /= size;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return std::numeric_limits<double>::infinity();
  // The numerically stable pair: q has the sign of -b, so nothing cancels.
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const double t1 = q != 0 ? a / q : std::numeric_limits<double>::infinity();
  const double t2 = c != 0 ? q / c : std::numeric_limits<double>::infinity();
  double first = std::numeric_limits<double>::infinity();
  if (t1 > 0) first = std::min(first, t1);
  if (t2 > 0) first = std::min(first, t2);
  return first;
}

}  // namespace

double swept_limit(const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& v) {
  const Vec3 e1 = x[1] - x[0], e2 = x[2] - x[0], g1 = v[1] - v[0], g2 = v[2] - v[0];
  const Vec3 c0 = cross(e1, e2), c1 = cross(e1, g2) + cross(g1, e2), c2 = cross(g1, g2);
  double limit = std::numeric_limits<double>::infinity();
  for (const Vec3& h : v) {
    if (squared_norm(h) == 0) continue;  // a line that stays does not sweep
    const double a = dot(c0, h);
    if (!(a > 0)) return 0;
    limit = std::min(limit, first_root(a, dot(c1, h), dot(c2, h)));
  }
  return limit;
}

std::array<double, 3> shares_kept(const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& v, double limit) {
  const double all = kSweptShare * limit;
  // A face without orientation from the start says nothing of heights: the certificate will judge it.
  if (!(all < 1) || all == 0) return {1.0, 1.0, 1.0};
  std::array<double, 3> shares = {all, all, all};
  double most_room = 1;
  for (std::size_t far = 0; far < 3; ++far) {
    std::array<Vec3, 3> lowered = {v[0] * all, v[1] * all, v[2] * all};
    lowered[far] = v[far];
    const double room = kSweptShare * swept_limit(x, lowered);
    if (room < most_room) continue;
    shares = {all, all, all};
    shares[far] = 1;
    most_room = room;
  }
  return shares;
}

}  // namespace nearwall::layers

#include "nearwall/predicates/orientation.h"

#include <cmath>
#include <optional>

#include "predicates/bounded.h"
#include "predicates/exact.h"

namespace nearwall::predicates {

namespace {

/// The sign of `value` if it is farther from zero than `bound`. False, too, for what has overflowed.
std::optional<Sign> certain_sign(double value, double bound) {
  if (value > bound) return Sign::Positive;
  if (value < -bound) return Sign::Negative;
  return std::nullopt;
}

/// Sign of (a × b) · c, of which each component may carry one rounding. docs/theory/predicates.md, Eq. (5).
std::optional<Sign> filtered_determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double kBound = 10.0 * kRoundoff;
  const double yz = b.y() * c.z(), zy = b.z() * c.y();
  const double zx = b.z() * c.x(), xz = b.x() * c.z();
  const double xy = b.x() * c.y(), yx = b.y() * c.x();
  const double value = a.x() * (yz - zy) + a.y() * (zx - xz) + a.z() * (xy - yx);
  const double x = std::abs(a.x()), y = std::abs(a.y()), z = std::abs(a.z());
  const double permanent =
      x * (std::abs(yz) + std::abs(zy)) + y * (std::abs(zx) + std::abs(xz)) + z * (std::abs(xy) + std::abs(yx));
  return certain_sign(value, kBound * permanent + kUnderflow * (1.0 + x + y + z));
}

/// Whether the three vectors lie in one coordinate plane: frequent, since many surfaces have flat sides along the axes.
bool lie_in_coordinate_plane(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (a.x() == 0 && b.x() == 0 && c.x() == 0) || (a.y() == 0 && b.y() == 0 && c.y() == 0) ||
         (a.z() == 0 && b.z() == 0 && c.z() == 0);
}

}  // namespace

Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  if (const auto sign = filtered_determinant(ab, ac, ad)) return *sign;
  // A difference of doubles is zero only if they are equal.
  return lie_in_coordinate_plane(ab, ac, ad) ? Sign::Zero : exact::orientation(a, b, c, d);
}

Sign sign_of_determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (const auto sign = filtered_determinant(a, b, c)) return *sign;
  return lie_in_coordinate_plane(a, b, c) ? Sign::Zero : exact::determinant(a, b, c);
}

Sign sign_of_dot(const Vec3& n, const Vec3& v) {
  constexpr double kBound = 5.0 * kRoundoff;  // Eq. (4)
  const double x = n.x() * v.x(), y = n.y() * v.y(), z = n.z() * v.z();
  const double bound = kBound * (std::abs(x) + std::abs(y) + std::abs(z)) + kUnderflow;
  if (const auto sign = certain_sign(x + y + z, bound)) return *sign;
  return exact::dot(n, v);
}

bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double kBound = 6.0 * kRoundoff;  // Eq. (6)
  const Vec3 u = b - a, v = c - a;
  const auto is_nonzero = [&](int i, int j) {
    const double ij = u[i] * v[j], ji = u[j] * v[i];
    return certain_sign(ij - ji, kBound * (std::abs(ij) + std::abs(ji)) + kUnderflow).has_value();
  };
  if (is_nonzero(0, 1) || is_nonzero(1, 2) || is_nonzero(2, 0)) return false;
  return exact::is_degenerate(a, b, c);
}

}  // namespace nearwall::predicates

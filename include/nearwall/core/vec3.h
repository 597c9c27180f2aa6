#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace nearwall {

/// A point or vector in space: three doubles.
///
/// Sums over the three components do not depend on the order of the axes (see `sum3`), so permuting the axes of an
/// input permutes every result bit for bit.
class Vec3 {
 public:
  constexpr Vec3() = default;
  constexpr Vec3(double x, double y, double z) : c_{x, y, z} {}

  constexpr double x() const { return c_[0]; }
  constexpr double y() const { return c_[1]; }
  constexpr double z() const { return c_[2]; }
  constexpr double operator[](int axis) const { return c_[axis]; }
  constexpr double& operator[](int axis) { return c_[axis]; }

  constexpr Vec3& operator+=(const Vec3& b) {
    c_[0] += b.c_[0], c_[1] += b.c_[1], c_[2] += b.c_[2];
    return *this;
  }
  constexpr Vec3& operator-=(const Vec3& b) {
    c_[0] -= b.c_[0], c_[1] -= b.c_[1], c_[2] -= b.c_[2];
    return *this;
  }
  constexpr Vec3& operator*=(double s) {
    c_[0] *= s, c_[1] *= s, c_[2] *= s;
    return *this;
  }

  friend constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
  friend constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
  friend constexpr Vec3 operator*(Vec3 a, double s) { return a *= s; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return a *= s; }
  friend constexpr Vec3 operator/(const Vec3& a, double s) { return {a.x() / s, a.y() / s, a.z() / s}; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x(), -a.y(), -a.z()}; }
  friend constexpr auto operator<=>(const Vec3&, const Vec3&) = default;

 private:
  std::array<double, 3> c_{};
};

namespace detail {

/// a < b ? a : b, without a branch: which of two sums is larger is anybody's guess, and compilers jump on it otherwise.
constexpr double smaller(double a, double b) {
#if defined(__SSE2__)
  if (!std::is_constant_evaluated()) return _mm_cvtsd_f64(_mm_min_sd(_mm_set_sd(a), _mm_set_sd(b)));
#endif
  return a < b ? a : b;
}

/// a > b ? a : b, likewise.
constexpr double larger(double a, double b) {
#if defined(__SSE2__)
  if (!std::is_constant_evaluated()) return _mm_cvtsd_f64(_mm_max_sd(_mm_set_sd(a), _mm_set_sd(b)));
#endif
  return a > b ? a : b;
}

}  // namespace detail

/// Sum of three doubles that is the same in whatever order they come: the smallest and the largest first. Not a number
/// if one of them is not.
constexpr double sum3(double a, double b, double c) {
  // Where a comparison has no answer the second one counts: one of each two results keeps what is not a number.
  const double low_ab = detail::smaller(a, b);
  const double high_ab = detail::larger(b, a);
  const double low = detail::smaller(low_ab, c);
  const double high = detail::larger(c, high_ab);
  const double rest = detail::smaller(high_ab, c);
  const double middle = detail::larger(rest, low_ab);
  return (low + high) + middle;
}

constexpr double dot(const Vec3& a, const Vec3& b) { return sum3(a.x() * b.x(), a.y() * b.y(), a.z() * b.z()); }

constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

constexpr double squared_norm(const Vec3& a) { return dot(a, a); }

inline double norm(const Vec3& a) { return std::sqrt(squared_norm(a)); }

/// a / |a|; the zero vector stays zero. Safe against overflow and underflow of |a|².
Vec3 normalized(const Vec3& a);

inline double distance(const Vec3& a, const Vec3& b) { return norm(a - b); }

/// Largest absolute component.
constexpr double max_norm(const Vec3& a) {
  const auto abs = [](double v) { return v < 0 ? -v : v; };
  const double x = abs(a.x()), y = abs(a.y()), z = abs(a.z());
  const double xy = x < y ? y : x;
  return xy < z ? z : xy;
}

inline bool is_finite(const Vec3& a) { return std::isfinite(a.x()) && std::isfinite(a.y()) && std::isfinite(a.z()); }

}  // namespace nearwall

#pragma once

#include <cmath>

namespace nearwall::studies {

/// A number that depends on x and y, with its two derivatives: formulas written for jets differentiate themselves.
struct Jet {
  double value = 0;
  double dx = 0;
  double dy = 0;

  friend Jet operator+(const Jet& a, const Jet& b) { return {a.value + b.value, a.dx + b.dx, a.dy + b.dy}; }
  friend Jet operator-(const Jet& a, const Jet& b) { return {a.value - b.value, a.dx - b.dx, a.dy - b.dy}; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.dx * b.value + a.value * b.dx, a.dy * b.value + a.value * b.dy};
  }
  friend Jet operator+(const Jet& a, double b) { return {a.value + b, a.dx, a.dy}; }
  friend Jet operator-(const Jet& a, double b) { return {a.value - b, a.dx, a.dy}; }
  friend Jet operator*(double s, const Jet& a) { return {s * a.value, s * a.dx, s * a.dy}; }
};

/// outer(a) by the chain rule, given the outer function's value and derivative at a.
inline Jet chained(double outer, double derivative, const Jet& a) {
  return {outer, derivative * a.dx, derivative * a.dy};
}

inline Jet square(const Jet& a) { return a * a; }
inline Jet inverse(const Jet& a) { return chained(1.0 / a.value, -1.0 / (a.value * a.value), a); }
inline Jet sqrt(const Jet& a) { return chained(std::sqrt(a.value), 0.5 / std::sqrt(a.value), a); }
inline Jet exp(const Jet& a) { return chained(std::exp(a.value), std::exp(a.value), a); }
inline Jet sin(const Jet& a) { return chained(std::sin(a.value), std::cos(a.value), a); }
inline Jet cos(const Jet& a) { return chained(std::cos(a.value), -std::sin(a.value), a); }
inline Jet tanh(const Jet& a) {
  const double t = std::tanh(a.value);
  return chained(t, 1.0 - t * t, a);
}

}  // namespace nearwall::studies

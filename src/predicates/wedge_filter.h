#pragma once

#include <cmath>

#include "predicates/bounded.h"
#include "predicates/formulas.h"

/// The first look at a wedge, in plain doubles without a branch, so that a compiler turns loops over it into vector
/// code.
namespace nearwall::predicates {

constexpr double larger(double a, double b) { return a < b ? b : a; }
constexpr double smaller(double a, double b) { return a < b ? a : b; }

inline double max_norm(const Vector<double>& a) { return larger(larger(std::abs(a.x), std::abs(a.y)), std::abs(a.z)); }

/// Whether all nine Bernstein coefficients of the wedge are greater than their error bound, docs/theory/predicates.md,
/// Eq. (11): then it is positive. Nothing follows if they are not.
inline bool is_surely_positive(const WedgeEdges<double>& e) {
  constexpr double kBound = 112.0 * kRoundoff;
  constexpr double kLow = 0x1p-900, kHigh = 0x1p+900;  // between them nothing underflows or overflows
  const auto q = wedge_quadratics(e);
  const auto least = [](const Quadratic<double>& c) { return smaller(smaller(c.c0, c.twice_c1), c.c2); };
  const double base = larger(max_norm(e.a1), max_norm(e.b1)) * larger(max_norm(e.a2), max_norm(e.b2));
  const double rise = larger(larger(max_norm(e.rise[0]), max_norm(e.rise[1])), max_norm(e.rise[2]));
  const double scale = base * rise;
  const double value = smaller(smaller(least(q[0]), least(q[1])), least(q[2]));
  return bool((value > kBound * scale) & (base > kLow) & (base < kHigh) & (scale > kLow) & (scale < kHigh));
}

}  // namespace nearwall::predicates

#pragma once

#include "predicates/bounded.h"
#include "predicates/formulas.h"

/// The first look at wedges, in plain doubles without a branch, for T double or a pack of doubles (a vector type of the
/// compiler, which compares to masks).
namespace nearwall::predicates {

template <class T>
T larger(const T& a, const T& b) {
  return a < b ? b : a;
}

template <class T>
T max_norm(const Vector<T>& a) {
  const auto magnitude = [](const T& v) { return larger(v, T(-v)); };
  return larger(larger(magnitude(a.x), magnitude(a.y)), magnitude(a.z));
}

/// Whether all nine Bernstein coefficients of the wedge are greater than their error bound, docs/theory/predicates.md,
/// Eq. (11): then it is positive. Nothing follows if they are not.
template <class T>
auto is_surely_positive(const WedgeEdges<T>& e) {
  constexpr double kBound = 112.0 * kRoundoff;
  constexpr double kLow = 0x1p-900, kHigh = 0x1p+900;  // between them nothing underflows or overflows
  const T base = larger(max_norm(e.a1), max_norm(e.b1)) * larger(max_norm(e.a2), max_norm(e.b2));
  const T rise = larger(larger(max_norm(e.rise[0]), max_norm(e.rise[1])), max_norm(e.rise[2]));
  const T scale = base * rise;
  const T bound = kBound * scale;
  const auto q = wedge_quadratics(e);
  // Comparisons rather than a minimum, which would lose what is not a number.
  const auto exceeds = [&](const Quadratic<T>& c) { return (c.c0 > bound) & (c.twice_c1 > bound) & (c.c2 > bound); };
  return exceeds(q[0]) & exceeds(q[1]) & exceeds(q[2]) & (base > kLow) & (base < kHigh) & (scale > kLow) &
         (scale < kHigh);
}

}  // namespace nearwall::predicates

#pragma once

#include "predicates/bounded.h"
#include "predicates/formulas.h"

/// The first look at wedges and hexahedra, in plain doubles without a branch; for wedges T is double or a pack of
/// doubles (a vector type of the compiler, which compares to masks).
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

/// Between 2^-900 and 2^900 nothing that the filters add or multiply underflows or overflows.
template <class T>
auto is_in_safe_range(const T& product) {
  constexpr double kLow = 0x1p-900, kHigh = 0x1p+900;
  return (product > kLow) & (product < kHigh);
}

/// Whether all nine Bernstein coefficients of the wedge are greater than their error bound, docs/theory/predicates.md,
/// Eq. (11): then it is positive. Nothing follows if they are not.
template <class T>
auto is_surely_positive(const WedgeEdges<T>& e) {
  constexpr double kBound = 112.0 * kRoundoff;
  const T base = larger(max_norm(e.a1), max_norm(e.b1)) * larger(max_norm(e.a2), max_norm(e.b2));
  const T rise = larger(larger(max_norm(e.rise[0]), max_norm(e.rise[1])), max_norm(e.rise[2]));
  const T scale = base * rise;
  const T bound = kBound * scale;
  const auto q = wedge_quadratics(e);
  // Comparisons rather than a minimum, which would lose what is not a number.
  const auto exceeds = [&](const Quadratic<T>& c) { return (c.c0 > bound) & (c.twice_c1 > bound) & (c.c2 > bound); };
  return exceeds(q[0]) & exceeds(q[1]) & exceeds(q[2]) & is_in_safe_range(base) & is_in_safe_range(scale);
}

/// The same for the 27 coefficients of a hexahedron, Eq. (13).
inline bool is_surely_positive(const HexahedronEdges<double>& e) {
  constexpr double kBound = 580.0 * kRoundoff;
  const auto largest = [](const std::array<std::array<Vector<double>, 2>, 2>& edges) {
    return larger(larger(max_norm(edges[0][0]), max_norm(edges[0][1])),
                  larger(max_norm(edges[1][0]), max_norm(edges[1][1])));
  };
  const double base = largest(e.u) * largest(e.v);
  const double scale = base * largest(e.w);
  const double bound = kBound * scale;
  bool exceed = true;
  for (const double c : hexahedron_coefficients(e)) exceed &= c > bound;
  return exceed & is_in_safe_range(base) & is_in_safe_range(scale);
}

}  // namespace nearwall::predicates

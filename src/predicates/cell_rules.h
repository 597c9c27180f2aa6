#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "predicates/formulas.h"
#include "predicates/verdict.h"

/// The rules by which wedges and hexahedra are judged, for number types T that know is_positive(T) and
/// is_nonnegative(T).
namespace nearwall::predicates {

/// docs/theory/predicates.md, Eq. (8).
template <class T>
Verdict is_positive_on_unit_interval(const Quadratic<T>& q) {
  const Verdict ends = both(is_positive(q.c0), is_positive(q.c2));
  if (ends == Verdict::No) return Verdict::No;
  const Verdict middle = is_nonnegative(q.twice_c1);
  if (middle == Verdict::Yes) return ends;
  const T product = q.c0 * q.c2;
  const T twice = product + product;
  return both(ends, either(middle, is_positive((twice + twice) - q.twice_c1 * q.twice_c1)));
}

template <class T>
Verdict wedge_verdict(std::span<const Vec3, 6> p) {
  Verdict all = Verdict::Yes;
  for (const Quadratic<T>& q : wedge_quadratics(wedge_edges<T>(p))) all = both(all, is_positive_on_unit_interval(q));
  return all;
}

/// Halves the box along the axis whose coefficients lie `stride` apart; four times the two halves' coefficients.
template <class T>
std::pair<Triquadratic<T>, Triquadratic<T>> halves(const Triquadratic<T>& c, int stride) {
  const auto twice = [](const T& a) { return a + a; };
  std::pair<Triquadratic<T>, Triquadratic<T>> h;
  for (int i = 0; i < 27; ++i) {
    if (i / stride % 3 != 0) continue;
    const T &a = c[i], &b = c[i + stride], &d = c[i + 2 * stride];
    const T left = a + b, right = b + d, centre = left + right;
    h.first[i] = twice(twice(a)), h.first[i + stride] = twice(left), h.first[i + 2 * stride] = centre;
    h.second[i] = centre, h.second[i + stride] = twice(right), h.second[i + 2 * stride] = twice(twice(d));
  }
  return h;
}

/// What the coefficients of a box tell about the polynomial on it.
struct BoxVerdict {
  Verdict corners = Verdict::Yes;  ///< whether the values at the corners, eight of the coefficients, are positive
  Verdict all = Verdict::Yes;      ///< whether all coefficients are
};

template <class T>
BoxVerdict box_verdict(const Triquadratic<T>& c) {
  BoxVerdict verdict;
  for (int i = 0; i < 27; ++i) {
    const Verdict sign = is_positive(c[i]);
    verdict.all = both(verdict.all, sign);
    if (i / 9 != 1 && i / 3 % 3 != 1 && i % 3 != 1) verdict.corners = both(verdict.corners, sign);
  }
  return verdict;
}

inline constexpr int kMaxHalvings = 8;              ///< boxes of 2^-8 of the cell are not cut any more
inline constexpr std::size_t kMaxOpenBoxes = 1024;  ///< nor are more than these at a time

/// Level by level, so that the answer does not depend on the numbering of the nodes (Johnen, Remacle and Geuzaine
/// 2013).
template <class T>
Verdict hexahedron_verdict(std::span<const Vec3, 8> p) {
  std::vector<Triquadratic<T>> open{hexahedron_coefficients(hexahedron_edges<T>(p))};
  for (int level = 0; level <= kMaxHalvings; ++level) {
    std::vector<Triquadratic<T>> left_open;
    for (auto& box : open) {
      const BoxVerdict verdict = box_verdict(box);
      // A corner stays a corner however the box is cut: where its sign is open, cutting is in vain.
      if (verdict.corners != Verdict::Yes) return verdict.corners;
      if (verdict.all != Verdict::Yes) left_open.push_back(std::move(box));
    }
    if (left_open.empty()) return Verdict::Yes;
    if (left_open.size() > kMaxOpenBoxes) return Verdict::Open;
    open.clear();
    for (const auto& box : left_open) {
      const auto slabs = halves(box, 9);
      for (const auto& slab : {slabs.first, slabs.second}) {
        const auto bars = halves(slab, 3);
        for (const auto& bar : {bars.first, bars.second}) {
          auto cubes = halves(bar, 1);
          open.push_back(std::move(cubes.first));
          open.push_back(std::move(cubes.second));
        }
      }
    }
  }
  return Verdict::Open;
}

}  // namespace nearwall::predicates

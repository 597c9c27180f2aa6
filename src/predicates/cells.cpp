#include "nearwall/predicates/cells.h"

#include "nearwall/predicates/orientation.h"
#include "predicates/bounded.h"
#include "predicates/cell_filters.h"
#include "predicates/cell_rules.h"
#include "predicates/exact.h"

namespace nearwall::predicates {

namespace {

Positivity positive_if(bool holds) { return holds ? Positivity::Positive : Positivity::NotPositive; }

}  // namespace

Positivity tetrahedron(std::span<const Vec3, 4> p) {
  return positive_if(orientation(p[0], p[1], p[2], p[3]) == Sign::Positive);
}

Positivity pyramid(std::span<const Vec3, 5> p) {
  // det J is bilinear over the base: docs/theory/predicates.md, Eq. (9).
  for (int i = 0; i < 4; ++i) {
    if (orientation(p[i], p[(i + 1) % 4], p[(i + 3) % 4], p[4]) != Sign::Positive) return Positivity::NotPositive;
  }
  return Positivity::Positive;
}

Positivity wedge(std::span<const Vec3, 6> p) {
  if (is_surely_positive(wedge_edges<double>(p))) return Positivity::Positive;
  const Verdict verdict = wedge_verdict<Bounded>(p);
  return verdict == Verdict::Open ? exact::wedge(p) : to_positivity(verdict);
}

Positivity hexahedron(std::span<const Vec3, 8> p) {
  if (is_surely_positive(hexahedron_edges<double>(p))) return Positivity::Positive;
  const Verdict verdict = hexahedron_verdict<Bounded>(p);
  return verdict == Verdict::Open ? exact::hexahedron(p) : to_positivity(verdict);
}

}  // namespace nearwall::predicates

#include "predicates/patch_side.h"

#include "predicates/bounded.h"

namespace nearwall::predicates {

Sign patch_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p) {
  const Bounded form = patch_form<Bounded>(a, b, c, d, p);
  const Bounded negative = patch_form<Bounded>(b, c, d, a, p);
  if (is_positive(form) == Verdict::Yes) return Sign::Positive;
  if (is_positive(negative) == Verdict::Yes) return Sign::Negative;
  return exact::patch_side(a, b, c, d, p);
}

}  // namespace nearwall::predicates

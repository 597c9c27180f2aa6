#include <algorithm>
#include <array>

#include <CGAL/Mpzf.h>

#include "nearwall/core/errors.h"
#include "predicates/patch_side.h"

namespace nearwall::predicates::exact {

Sign patch_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p) {
  const std::array<Vec3, 5> all{a, b, c, d, p};
  if (!std::all_of(all.begin(), all.end(), is_finite)) {
    throw InputError("expected finite coordinates in a geometric predicate, found an infinite one or not a number");
  }
  return static_cast<Sign>(static_cast<int>(patch_form<CGAL::Mpzf>(a, b, c, d, p).sign()));
}

}  // namespace nearwall::predicates::exact

#include "predicates/exact.h"

#include <algorithm>
#include <initializer_list>

#include <CGAL/Mpzf.h>

#include "nearwall/core/errors.h"
#include "predicates/cell_rules.h"

namespace CGAL {

// Found by argument-dependent look-up from the rules in cell_rules.h.
static nearwall::predicates::Verdict is_positive(const Mpzf& a) {
  return a.sign() > 0 ? nearwall::predicates::Verdict::Yes : nearwall::predicates::Verdict::No;
}
static nearwall::predicates::Verdict is_nonnegative(const Mpzf& a) {
  return a.sign() >= 0 ? nearwall::predicates::Verdict::Yes : nearwall::predicates::Verdict::No;
}

}  // namespace CGAL

namespace nearwall::predicates::exact {

namespace {

using Exact = CGAL::Mpzf;

Sign sign_of(const Exact& a) { return static_cast<Sign>(static_cast<int>(a.sign())); }

void require_finite(std::initializer_list<Vec3> points) {
  if (!std::all_of(points.begin(), points.end(), is_finite)) {
    throw InputError("expected finite coordinates in a geometric predicate, found an infinite one or not a number");
  }
}

}  // namespace

Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  require_finite({a, b, c, d});
  return sign_of(orientation_determinant<Exact>(a, b, c, d));
}

Sign determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
  require_finite({a, b, c});
  return sign_of(predicates::dot(cross(as_vector<Exact>(a), as_vector<Exact>(b)), as_vector<Exact>(c)));
}

Sign dot(const Vec3& a, const Vec3& b) {
  require_finite({a, b});
  return sign_of(predicates::dot(as_vector<Exact>(a), as_vector<Exact>(b)));
}

Sign same_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  require_finite({a, b, c, d});
  return sign_of(same_side_product<Exact>(a, b, c, d));
}

bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  require_finite({a, b, c});
  const Vector<Exact> n = cross(edge<Exact>(a, b), edge<Exact>(a, c));
  return n.x.sign() == 0 && n.y.sign() == 0 && n.z.sign() == 0;
}

Positivity wedge(std::span<const Vec3, 6> p) {
  if (!std::all_of(p.begin(), p.end(), is_finite)) return Positivity::NotPositive;
  return to_positivity(wedge_verdict<Exact>(p));
}

Positivity hexahedron(std::span<const Vec3, 8> p) {
  if (!std::all_of(p.begin(), p.end(), is_finite)) return Positivity::NotPositive;
  return to_positivity(hexahedron_verdict<Exact>(p));
}

Sign enclosed_volume(std::size_t n_triangles, const std::function<Triangle(std::size_t)>& triangle) {
  Exact six_volumes = 0;
  for (std::size_t i = 0; i < n_triangles; ++i) {
    const auto [a, b, c] = triangle(i);
    require_finite({a, b, c});
    const Vector<Exact> normal = cross(as_vector<Exact>(b), as_vector<Exact>(c));
    six_volumes = six_volumes + predicates::dot(as_vector<Exact>(a), normal);
  }
  return sign_of(six_volumes);
}

}  // namespace nearwall::predicates::exact

#include "nearwall/predicates/intersection.h"

#include <algorithm>

#include "nearwall/predicates/orientation.h"
#include "predicates/bounded.h"
#include "predicates/exact_intersection.h"
#include "predicates/formulas.h"

namespace nearwall::predicates {

namespace {

/// On which side of the plane of a triangle three or two points lie.
struct Sides {
  bool has_positive = false;
  bool has_negative = false;
  bool has_zero = false;

  void add(Sign s) {
    has_positive |= s == Sign::Positive;
    has_negative |= s == Sign::Negative;
    has_zero |= s == Sign::Zero;
  }
  /// All points strictly on one side.
  bool is_apart() const { return !has_zero && has_positive != has_negative; }
};

Sign side(const Triangle& plane, const Vec3& p) { return orientation(plane[0], plane[1], plane[2], p); }

/// How the line from p to q passes the three edges of t: with its normal all are positive.
Sides passes(const Vec3& p, const Vec3& q, const Triangle& t) {
  Sides sides;
  for (int i = 0; i < 3 && !(sides.has_positive && sides.has_negative); ++i) {
    sides.add(orientation(p, q, t[i], t[(i + 1) % 3]));
  }
  return sides;
}

/// Whether the segment meets the closed triangle, if its ends lie strictly on different sides of the plane.
bool pierces(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Sides sides = passes(p, q, t);
  return !(sides.has_positive && sides.has_negative);
}

/// The same for the edges of a triangle of which no corner lies in the plane of t.
bool edges_pierce(const Triangle& a, const std::array<Sign, 3>& sides, const Triangle& t) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (sides[i] != sides[j] && pierces(a[i], a[j], t)) return true;
  }
  return false;
}

std::array<Sign, 3> sides_of(const Triangle& a, const Triangle& plane) {
  return {side(plane, a[0]), side(plane, a[1]), side(plane, a[2])};
}

Sides summary(const std::array<Sign, 3>& signs) {
  Sides sides;
  for (const Sign s : signs) sides.add(s);
  return sides;
}

/// Whether a plane across an axis through the common corner a[0] has one triangle on its one side and the rest of the
/// other strictly on its other side.
bool are_apart_along_an_axis(const Triangle& a, const Triangle& b) {
  for (int k = 0; k < 3; ++k) {
    const double v = a[0][k];
    const double a_low = std::min(a[1][k], a[2][k]), a_high = std::max(a[1][k], a[2][k]);
    const double b_low = std::min(b[1][k], b[2][k]), b_high = std::max(b[1][k], b[2][k]);
    if ((a_low > v && b_high <= v) || (a_low >= v && b_high < v)) return true;
    if ((b_low > v && a_high <= v) || (b_low >= v && a_high < v)) return true;
  }
  return false;
}

}  // namespace

bool triangles_intersect(const Triangle& a, const Triangle& b) {
  const auto signs_b = sides_of(b, a);
  const Sides sides_b = summary(signs_b);
  if (sides_b.is_apart()) return false;
  const auto signs_a = sides_of(a, b);
  const Sides sides_a = summary(signs_a);
  if (sides_a.is_apart()) return false;
  if (sides_a.has_zero || sides_b.has_zero) return exact::triangles_intersect(a, b);
  return edges_pierce(a, signs_a, b) || edges_pierce(b, signs_b, a);
}

bool segment_intersects_triangle(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Sign side_p = side(t, p), side_q = side(t, q);
  if (side_p == Sign::Zero || side_q == Sign::Zero) return exact::segment_intersects_triangle(p, q, t);
  return side_p != side_q && pierces(p, q, t);
}

bool triangles_intersect_beyond_vertex(const Triangle& a, const Triangle& b) {
  if (are_apart_along_an_axis(a, b)) return false;
  const Sign b1 = side(a, b[1]), b2 = side(a, b[2]);
  if (b1 == b2 && b1 != Sign::Zero) return false;
  const Sign a1 = side(b, a[1]), a2 = side(b, a[2]);
  if (a1 == a2 && a1 != Sign::Zero) return false;
  if (a1 == Sign::Zero || a2 == Sign::Zero || b1 == Sign::Zero || b2 == Sign::Zero) {
    return exact::triangles_intersect_beyond_vertex(a, b);
  }
  // What they have in common beyond the corner is a segment from it that ends on the opposite edge of one of them.
  return pierces(b[1], b[2], a) || pierces(a[1], a[2], b);
}

bool triangles_overlap_beyond_edge(const Triangle& a, const Triangle& b) {
  if (orientation(a[0], a[1], a[2], b[2]) != Sign::Zero) return false;
  const Verdict fast = is_positive(same_side_product<Bounded>(a[0], a[1], a[2], b[2]));
  if (fast != Verdict::Open) return fast == Verdict::Yes;
  return exact::triangles_overlap_beyond_edge(a, b);
}

RayCrossing ray_crossing(const Vec3& origin, const Vec3& through, const Triangle& t) {
  const Sides line = passes(origin, through, t);
  if (line.has_positive && line.has_negative) return RayCrossing::None;
  if (!line.has_positive && !line.has_negative) return RayCrossing::Degenerate;
  // The line meets the closed triangle in one point: ahead of the origin, behind it, or there?
  const Sign start = side(t, origin);
  if (start == Sign::Zero) return RayCrossing::Degenerate;
  if ((start == Sign::Positive) == line.has_positive) return RayCrossing::None;
  if (line.has_zero) return RayCrossing::Degenerate;
  return line.has_positive ? RayCrossing::Along : RayCrossing::Against;
}

}  // namespace nearwall::predicates

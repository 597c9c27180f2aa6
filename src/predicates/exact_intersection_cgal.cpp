#include "predicates/exact_intersection.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "predicates/exact.h"

namespace nearwall::predicates::exact {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
/// What a triangle is as a set of points: CGAL wants neither triangles without area nor segments without length.
using Shape = std::variant<Point, Segment, Kernel::Triangle_3>;

Point to_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Shape segment_shape(const Vec3& a, const Vec3& b) {
  if (a == b) return to_point(a);
  return Segment(to_point(a), to_point(b));
}

bool has_no_area(const Triangle& t) { return is_degenerate(t[0], t[1], t[2]); }

Shape shape(const Triangle& t) {
  if (!has_no_area(t)) return Kernel::Triangle_3(to_point(t[0]), to_point(t[1]), to_point(t[2]));
  const auto [low, high] = std::minmax_element(t.begin(), t.end());  // along their common line
  return segment_shape(*low, *high);
}

bool meet(const Shape& a, const Shape& b) {
  return std::visit(
      [](const auto& x, const auto& y) {
        using X = std::decay_t<decltype(x)>;
        using Y = std::decay_t<decltype(y)>;
        if constexpr (std::is_same_v<X, Point> && std::is_same_v<Y, Point>) {
          return x == y;
        } else if constexpr (std::is_same_v<X, Point>) {
          return y.has_on(x);
        } else if constexpr (std::is_same_v<Y, Point>) {
          return x.has_on(y);
        } else {
          return CGAL::do_intersect(x, y);
        }
      },
      a, b);
}

/// Where a straight way from the corner t[0] leaves the triangle: its opposite edge; the ends of what has no area.
std::vector<Shape> exits(const Triangle& t) {
  if (!has_no_area(t)) return {segment_shape(t[1], t[2])};
  std::vector<Shape> ends;
  for (int i = 1; i < 3; ++i) {
    if (t[i] != t[0]) ends.push_back(to_point(t[i]));
  }
  return ends;
}

bool any_meets(const std::vector<Shape>& parts, const Shape& other) {
  return std::any_of(parts.begin(), parts.end(), [&](const Shape& part) { return meet(part, other); });
}

}  // namespace

bool triangles_intersect(const Triangle& a, const Triangle& b) { return meet(shape(a), shape(b)); }

bool segment_intersects_triangle(const Vec3& p, const Vec3& q, const Triangle& t) {
  return meet(segment_shape(p, q), shape(t));
}

bool triangles_intersect_beyond_vertex(const Triangle& a, const Triangle& b) {
  // Their common part is convex and holds the corner: if it holds more, it reaches where one of the two ends.
  return any_meets(exits(a), shape(b)) || any_meets(exits(b), shape(a));
}

bool triangles_overlap_beyond_edge(const Triangle& a, const Triangle& b) {
  if (orientation(a[0], a[1], a[2], b[2]) != Sign::Zero) return false;
  const Sign sides = same_side(a[0], a[1], a[2], b[2]);
  if (sides != Sign::Zero) return sides == Sign::Positive;
  if (!has_no_area(a) || !has_no_area(b)) return false;
  // Both on one line: does the third corner of one lie on the other, but not on what they share?
  const Shape shared = segment_shape(a[0], a[1]);
  const auto lies_beyond = [&](const Vec3& apex, const Triangle& other) {
    return meet(to_point(apex), shape(other)) && !meet(to_point(apex), shared);
  };
  return lies_beyond(a[2], b) || lies_beyond(b[2], a);
}

}  // namespace nearwall::predicates::exact

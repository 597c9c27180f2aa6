#include "search/patch.h"

#include "nearwall/predicates/orientation.h"
#include "nearwall/predicates/patch_side.h"

namespace nearwall::search {

using predicates::orientation;
using predicates::Sign;

PatchShape Patch::shape_of(std::span<const Vec3> points, const Corners& c) {
  if (c[3] == kNoCorner) return PatchShape::Triangle;
  const Sign turn = orientation(points[c[0]], points[c[1]], points[c[2]], points[c[3]]);
  return turn == Sign::Zero ? PatchShape::Planar : PatchShape::Warped;
}

std::array<std::uint32_t, 3> Patch::triangle_nodes(int i) const {
  static constexpr std::array<std::array<int, 3>, 4> kCorners{{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}};
  const auto [a, b, c] = kCorners[static_cast<std::size_t>(i)];
  return {node(a), node(b), node(c)};
}

predicates::Triangle Patch::triangle(int i) const {
  const auto [a, b, c] = triangle_nodes(i);
  return {points_[a], points_[b], points_[c]};
}

bool Patch::hull_contains(const Vec3& p) const {
  const Vec3 &a = point(0), &b = point(1), &c = point(2), &d = point(3);
  const Sign inside = orientation(a, b, c, d);
  const auto is_outside = [&](Sign s) { return s != Sign::Zero && s != inside; };
  return !is_outside(orientation(p, b, c, d)) && !is_outside(orientation(a, p, c, d)) &&
         !is_outside(orientation(a, b, p, d)) && !is_outside(orientation(a, b, c, p));
}

bool Patch::is_surely_crossed(const Vec3& from, const Vec3& to) const {
  const auto meets = [&](int i) {
    return i < n_triangles() && predicates::segment_intersects_triangle(from, to, triangle(i));
  };
  if (!meets(0) && !meets(1)) return false;
  return !is_warped() || meets(2) || meets(3);
}

bool Patch::may_be_met(const Vec3& from, const Vec3& to) const {
  bool is_met = is_warped() && hull_contains(from);
  for (int i = 0; i < n_triangles() && !is_met; ++i) {
    is_met = predicates::segment_intersects_triangle(from, to, triangle(i));
  }
  return is_met && !(is_warped() && are_surely_apart(corners(), {from, to, to, from}));
}

Sign Patch::side_in_hull(const Vec3& p) const {
  const Vec3 &a = point(0), &b = point(1), &c = point(2), &d = point(3);
  // With d above the triangle a b c, the edge a c is on the side where the corners are seen clockwise from.
  const Sign nearer_ac = predicates::patch_side(a, b, c, d, p);
  return static_cast<Sign>(-static_cast<int>(nearer_ac) * static_cast<int>(orientation(a, b, c, d)));
}

Vec3 Patch::middle() const {
  Vec3 sum;
  for (int k = 0; k < size(); ++k) sum += point(k) / size();
  return sum;
}

}  // namespace nearwall::search

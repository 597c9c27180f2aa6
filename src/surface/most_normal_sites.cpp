#include "surface/most_normal_sites.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "surface/normals_cap.h"

namespace nearwall::surface {

namespace {

/// Chord below which a vertex is the pole of a plane, or opposite to another: the distances along their bisector then
/// differ by less than the tie tolerance.
constexpr double kSamePlace = 1e-10;

/// A discriminant this much below zero, relative to its terms, belongs to a double root.
constexpr double kDoubleRoot = 1e-13;

/// Relative size below which a vector is the rounding of zero.
constexpr double kNothing = 0x1p-48;

/// Sum and difference of two unit vectors, square to each other: rounding of the lengths tilts the shorter one.
struct SumAndDifference {
  SumAndDifference(const Vec3& a, const Vec3& b) : sum(a + b), difference(a - b) {
    const double squared_sum = squared_norm(sum), squared_difference = squared_norm(difference);
    const double tilt = dot(sum, difference);
    if (squared_sum > squared_difference) {
      difference -= sum * (tilt / squared_sum);
    } else if (squared_difference > 0) {
      sum -= difference * (tilt / squared_difference);
    }
  }

  Vec3 sum, difference;
};

/// Where circles of the same height about two axes meet, Eq. (5).
/// \param other  sqrt(1 - height²)
Directions meet_of_equal(const Vec3& a, const Vec3& b, double height, double other) {
  const auto [sum, difference] = SumAndDifference(a, b);
  const double squared_sum = squared_norm(sum), squared_difference = squared_norm(difference);
  // 1 + a · b - 2 height², the way that does not cancel.
  const double room =
      height > other ? 2.0 * other * other - 0.5 * squared_difference : 0.5 * squared_sum - 2.0 * height * height;
  if (!(room >= 0) || !(squared_sum > 0) || !(squared_difference > 0)) return {};
  const Vec3 middle = sum * (2.0 * height / squared_sum);
  const Vec3 aside = cross(difference, sum) * (std::sqrt(2.0 * room / squared_difference) / squared_sum);
  Directions x;
  x.add(middle + aside);
  x.add(middle - aside);
  return x;
}

/// Where the level circles of a plane and a vertex meet, Eqs. (6) and (7).
Directions meet_of_unequal(const Site& plane, const Site& vertex, const Level& level) {
  const Vec3 &n = plane.axis, &v = vertex.axis;
  Directions x;
  if (vertex.is_end_of(plane)) {
    x.add(n * level.sine + v * level.cosine);
    return x;
  }
  const double c = dot(n, v);
  if (c < 0) return x;
  const auto [sum, difference] = SumAndDifference(n, v);
  const double squared_sum = squared_norm(sum), squared_difference = squared_norm(difference);
  // sin 2D - c, where both are nearly one by their distances from one.
  const double gap = level.cosine - level.sine;
  const double room = c * (c > 0.5 ? 0.5 * squared_difference - gap * gap : 2.0 * level.sine * level.cosine - c);
  if (!(room >= 0) || !(squared_difference > 0)) return x;
  const Vec3 middle = sum * ((level.sine + level.cosine) / squared_sum) - difference * (gap / squared_difference);
  const Vec3 aside = cross(sum, difference) * (2.0 * std::sqrt(room) / (squared_sum * squared_difference));
  x.add(middle + aside);
  x.add(middle - aside);
  return x;
}

/// Orthonormal axes of a plane's normal and a vertex, turned apart or together evenly, and the third one.
struct Frame {
  Vec3 normal, vertex, side;
};

Frame frame_of(const Vec3& n, const Vec3& v, const Vec3& fallback) {
  auto [sum, difference] = SumAndDifference(n, v);
  sum = unit_vector(sum);
  // A vertex in the pole: any direction square to it.
  if (squared_norm(difference) <= kNothing * kNothing) difference = cross(sum, fallback);
  difference = unit_vector(difference);
  constexpr double kHalf = std::numbers::sqrt2 / 2;
  return {(sum + difference) * kHalf, (sum - difference) * kHalf, cross(sum, difference)};
}

/// Directions square to g and equally far from a plane and a vertex, Eqs. (10) to (12).
Directions on_circle(const Vec3& g, const Site& plane, const Site& vertex) {
  const double c = vertex.is_end_of(plane) ? 0.0 : dot(plane.axis, vertex.axis);
  if (c < 0) return {};
  const Frame frame = frame_of(plane.axis, vertex.axis, g);
  Vec3 first = cross(g, frame.side);
  if (squared_norm(first) <= kNothing * kNothing * squared_norm(g)) first = frame.normal;
  const Vec3 e = unit_vector(first), f = unit_vector(cross(g, e));
  const double en = dot(e, frame.normal), ev = dot(e, frame.vertex);
  const double fn = dot(f, frame.normal), fv = dot(f, frame.vertex), fs = dot(f, frame.side);
  // x = r e + s f:  a s² - b r s - d r² = 0.
  const double a = fs * fs - 2.0 * c * fn * fv, b = 2.0 * c * (en * fv + fn * ev), d = 2.0 * c * en * ev;
  const double discriminant = b * b + 4.0 * a * d;
  if (discriminant < -kDoubleRoot * (b * b + 4.0 * std::abs(a * d))) return {};
  const double q = 0.5 * (b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
  Directions x;
  for (const auto& [r, s] : {std::pair(a, q), std::pair(q, -d)}) {
    const Vec3 root = e * r + f * s;
    if (!(squared_norm(root) > 0)) continue;
    const double side = dot(root, plane.axis) + dot(root, vertex.axis);
    x.add(unit_vector(side < 0 ? -root : root));
  }
  return x;
}

/// Directions equally far from three planes or three vertices, Eq. (9).
Directions equally_far_from_equal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = SumAndDifference(a, b).difference, bc = SumAndDifference(b, c).difference,
             ca = SumAndDifference(c, a).difference;
  const double longest = std::max({squared_norm(ab), squared_norm(bc), squared_norm(ca)});
  // The base between the two shortest edges makes the cross product sharpest.
  const Vec3 axis = longest == squared_norm(ab)   ? cross(bc, ca)
                    : longest == squared_norm(bc) ? cross(ca, ab)
                                                  : cross(ab, bc);
  Directions x;
  if (!(squared_norm(axis) > 0)) return x;
  const Vec3 pole = unit_vector(axis);
  const double height = dot(pole, a);
  // Which end of the axis is a right angle away from vertices, or in a plane, is anybody's guess.
  if (height > -kSamePlace) x.add(pole);
  if (height < kSamePlace) x.add(-pole);
  return x;
}

}  // namespace

Directions at_level(const Site& a, const Site& b, const Level& level) {
  if (a.is_vertex && b.is_vertex) return meet_of_equal(a.axis, b.axis, level.cosine, level.sine);
  if (!a.is_vertex && !b.is_vertex) return meet_of_equal(a.axis, b.axis, level.sine, level.cosine);
  return a.is_vertex ? meet_of_unequal(b, a, level) : meet_of_unequal(a, b, level);
}

Directions equally_far(const Site& a, const Site& b, const Site& c) {
  if (a.is_vertex == b.is_vertex && b.is_vertex == c.is_vertex) return equally_far_from_equal(a.axis, b.axis, c.axis);
  const Site& other = a.is_vertex == b.is_vertex ? c : a.is_vertex == c.is_vertex ? b : a;
  const Site& first = &other == &a ? b : a;
  const Site& second = &other == &c ? b : c;
  const Vec3 g = SumAndDifference(first.axis, second.axis).difference;
  if (!(squared_norm(g) > 0)) return {};
  // An arc and its own end make the third equation exact.
  const bool has_second_end = second.is_end_of(other) || other.is_end_of(second);
  const Site& same = has_second_end ? second : first;
  return other.is_vertex ? on_circle(g, same, other) : on_circle(g, other, same);
}

Directions farthest_of_pair(const Site& a, const Site& b, const Vec3& towards) {
  Directions x;
  const auto add = [&x](const Vec3& v) {
    if (squared_norm(v) > kNothing * kNothing) x.add(unit_vector(v));
  };
  const auto [sum, difference] = SumAndDifference(a.axis, b.axis);
  if (!a.is_vertex && !b.is_vertex) {
    add(sum);
  } else if (a.is_vertex && b.is_vertex) {
    if (squared_norm(sum) < kSamePlace * kSamePlace) {
      const Vec3 along = unit_vector(difference);
      add(towards - along * dot(along, towards));
    }
  } else if (squared_norm(difference) < kSamePlace * kSamePlace) {
    const Vec3 pole = unit_vector(sum), aside = towards - pole * dot(pole, towards);
    if (squared_norm(aside) > kNothing * kNothing) add(pole + unit_vector(aside));
  } else if (!a.is_end_of(b) && !b.is_end_of(a) && dot(a.axis, b.axis) > 0) {
    add(frame_of(a.is_vertex ? b.axis : a.axis, a.is_vertex ? a.axis : b.axis, towards).normal);
  }
  return x;
}

}  // namespace nearwall::surface

#include <algorithm>
#include <cmath>

#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/arctangent.h"
#include "nearwall/surface/iterative_normals.h"
#include "surface/normals_visible.h"
#include "surface/scratch.h"
#include "surface/unit_normals.h"

namespace nearwall::surface {

namespace {

struct Pair {
  std::size_t first = 0;
  std::size_t second = 0;
};

/// The two unit vectors with the longest chord; the first such pair in the order given.
Pair widest_pair(std::span<const Vec3> units) {
  Pair widest;
  double squared_chord = 0;
  for (std::size_t i = 0; i < units.size(); ++i) {
    for (std::size_t j = i + 1; j < units.size(); ++j) {
      const double squared = squared_norm(units[i] - units[j]);
      if (squared > squared_chord) widest = {i, j}, squared_chord = squared;
    }
  }
  return widest;
}

/// Middle of the directions in the plane that bisects the faces with the unit normals a and b from which all faces are
/// seen; zero if there are none. Equations (1) and (2) of docs/theory/iterative-normals.md.
Vec3 middle_of_bisecting_plane(const Vec3& a, const Vec3& b, std::span<const Vec3> units) {
  const Vec3 across = a - b, bisector = centre_of_pair(a, b);
  if (!(max_norm(bisector) > 0)) return {};
  const Vec3 up = unit_vector(bisector), along = unit_vector(cross(across, bisector));
  double least = 0, greatest = 0;
  for (const Vec3& unit : units) {
    const double side = dot(unit, along), height = dot(unit, up);
    if (side == 0 && height == 0) return {};  // this face holds the whole plane
    const double angle = std::copysign(geometry::angle_from(std::abs(side), height), side);
    least = std::min(least, angle);
    greatest = std::max(greatest, angle);
  }
  if (!(greatest - least < geometry::kPi)) return {};
  const double middle = 0.5 * (least + greatest);
  return unit_vector(up * std::cos(middle) + along * std::sin(middle));
}

}  // namespace

std::optional<VisibleNormal> kallinderis_normal(std::span<const Vec3> face_normals) {
  Scratch<Vec3> given(face_normals.size()), units(face_normals.size());
  for_each_unit_normal("kallinderis_normal", face_normals, [&](const Vec3& normal, const Vec3& unit) {
    given.add(normal);
    units.add(unit);
  });
  if (units.all().empty()) return std::nullopt;
  const auto [i, j] = widest_pair(units.all());
  const Vec3 direction =
      i == j ? units.all()[i] : middle_of_bisecting_plane(units.all()[i], units.all()[j], units.all());
  if (direction == Vec3{} || !sees_all(direction, given.all())) return std::nullopt;
  const double squared_chord = squared_chord_to_worst(direction, units.all());
  return VisibleNormal{direction, judged(direction, units.all(), squared_chord).max_angle};
}

}  // namespace nearwall::surface

#include "nearwall/surface/normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nearwall/geometry/arctangent.h"
#include "nearwall/predicates/orientation.h"
#include "surface/normals_cap.h"
#include "surface/normals_existence.h"
#include "surface/normals_visible.h"
#include "surface/scratch.h"
#include "surface/unit_normals.h"

namespace nearwall::surface {

namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

double cosine_of(double squared_chord) { return 1.0 - 0.5 * squared_chord; }
/// A direction that sees all faces sees the worst one under less than a right angle, however little.
double below_right_angle(double angle) { return std::min(angle, std::nextafter(kRightAngle, 0.0)); }

/// Where no direction was found that surely sees all: decides exactly, the few vectors in the way first.
std::optional<VisibleNormal> most_visible_at_the_limit(std::span<const Vec3> given, std::span<const Vec3> units,
                                                       const Cap& cap) {
  std::array<Vec3, 4> seat;
  for (std::size_t k = 0; k < cap.n_seat; ++k) seat[k] = given[cap.seat[k]];
  if (!find_seeing_direction({seat.data(), cap.n_seat})) return std::nullopt;
  // The cone is open by no more than rounding: any direction in it is optimal to all digits.
  const std::optional<Vec3> direction = find_seeing_direction(given);
  if (!direction) return std::nullopt;
  return VisibleNormal{*direction,
                       below_right_angle(geometry::angle_of_chord(squared_chord_to_worst(*direction, units)))};
}

}  // namespace

bool sees_all(const Vec3& direction, std::span<const Vec3> normals) {
  return std::all_of(normals.begin(), normals.end(), [&](const Vec3& normal) {
    return predicates::sign_of_dot(normal, direction) == predicates::Sign::Positive;
  });
}

double squared_chord_to_worst(const Vec3& direction, std::span<const Vec3> normals) {
  double worst = 0;
  for (const Vec3& normal : normals) worst = std::max(worst, squared_norm(normal - direction));
  return worst;
}

PointNormal judged(const Vec3& direction, std::span<const Vec3> normals, double squared_chord) {
  if (direction == Vec3{}) return {{}, kRightAngle, false, true};
  const bool is_visible = cosine_of(squared_chord) > kSurelyPositive || sees_all(direction, normals);
  const double angle = geometry::angle_of_chord(squared_chord);
  return {direction, is_visible ? below_right_angle(angle) : std::max(angle, kRightAngle), is_visible};
}

std::optional<VisibleNormal> most_visible_of(std::span<const Vec3> given, std::span<const Vec3> units) {
  const Cap cap = smallest_cap(units);
  const double worst_cosine = cosine_of(cap.squared_chord);
  if (worst_cosine > kSurelyPositive || (worst_cosine > 0 && sees_all(cap.centre, given))) {
    return VisibleNormal{cap.centre, below_right_angle(geometry::angle_of_chord(cap.squared_chord))};
  }
  return most_visible_at_the_limit(given, units, cap);
}

std::optional<VisibleNormal> most_visible_normal(std::span<const Vec3> face_normals) {
  Scratch<Vec3> given(face_normals.size()), units(face_normals.size());
  for_each_unit_normal("most_visible_normal", face_normals, [&](const Vec3& normal, const Vec3& unit) {
    given.add(normal);
    units.add(unit);
  });
  if (given.all().empty()) return std::nullopt;
  return most_visible_of(given.all(), units.all());
}

}  // namespace nearwall::surface

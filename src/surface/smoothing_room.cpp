#include "surface/smoothing_room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/arctangent.h"
#include "surface/normals_visible.h"

namespace nearwall::surface {

namespace {

/// In a room narrower than this [rad] rounding plays a part, and every new direction is held against the faces.
constexpr double kNarrow = 0x1p-20;

/// Share of the free chord that is used: its last digits are rounded.
constexpr double kSurely = 1.0 - 0x1p-30;

/// Angle from `start` towards the unit vector `along`, square to it, at which the cosine to `normal` falls to `cosine`.
double angle_of_leaving(const Vec3& normal, const Vec3& start, const Vec3& along, double cosine) {
  const double at_start = dot(normal, start), ahead = dot(normal, along);
  const double peak = std::sqrt(at_start * at_start + ahead * ahead);
  const double to_peak = geometry::angle_from(std::abs(ahead), at_start);
  const double share = std::clamp(cosine / peak, -1.0, 1.0);
  return (ahead < 0 ? -to_peak : to_peak) + geometry::angle_from(std::sqrt(1.0 - share * share), share);
}

}  // namespace

Room room_of(const PointNormal& given) {
  const double room = std::numbers::pi / 2 - given.max_angle;
  // No face can come nearer to the edge of sight than the direction itself has moved.
  const double free_chord = room > kNarrow ? 2.0 * std::sin(0.25 * room) * kSurely : 0.0;
  return {given.direction, std::sin(0.5 * room), free_chord * free_chord};
}

Vec3 drawn_back(const Vec3& wanted, const Room& room, std::span<const Vec3> normals) {
  const double turn = geometry::angle_between(room.given, wanted);
  const Vec3 aside = wanted - room.given * dot(wanted, room.given);
  const double size = norm(aside);
  double allowed = turn;
  for (const Vec3& normal : normals) {
    if (dot(normal, wanted) >= room.smallest_cosine) continue;
    if (!(size > 0)) return room.given;
    allowed = std::min(allowed, angle_of_leaving(normal, room.given, aside / size, room.smallest_cosine));
  }
  const Vec3 result = allowed < turn ? geometry::slerp(room.given, wanted, std::max(allowed, 0.0) / turn) : wanted;
  return sees_all(result, normals) ? result : room.given;
}

}  // namespace nearwall::surface

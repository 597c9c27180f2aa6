#include <algorithm>
#include <cmath>
#include <numbers>

#include "nearwall/geometry/arctangent.h"
#include "nearwall/surface/normals.h"
#include "surface/most_normal_ring.h"
#include "surface/most_normal_search.h"
#include "surface/normals_cap.h"

namespace nearwall::surface {

namespace {

/// A distance above a right angle by more than this is not a rounded right angle, of which there may be several [rad].
constexpr double kSurelyObtuse = 1e-10;

/// A fan is flat if the most visible normal keeps a right angle from all arcs, up to this cosine. But for Eq. (3) no
/// direction keeps more than a right angle, so that none is better by more than a tie.
constexpr double kFlat = 1e-10;

constexpr double kRightAngle = std::numbers::pi / 2;

/// Whether the fluid is on the outside of a ring that lies in a cap smaller than a hemisphere: whether the ring runs
/// clockwise, projected from the apex upon the plane that touches the sphere in the cap's centre.
bool is_clockwise_about(const Vec3& centre, const Ring& ring) {
  double doubled_area = 0;
  for (std::size_t k = 0; k < ring.arcs().size(); ++k) {
    const Vec3 &start = ring.arcs()[k].start, &end = ring.arcs()[ring.after(k)].start;
    doubled_area += dot(centre, cross(start - centre, end - centre)) / (dot(start, centre) * dot(end, centre));
  }
  return doubled_area < 0;
}

/// Of a ring that fits into a cap smaller than a hemisphere, with the fluid round the other end: that end, Eq. (3).
std::optional<NormalNormal> opposite_of_cap(const Ring& ring) {
  Scratch<Vec3> starts(ring.arcs().size());
  for (const Arc& arc : ring.arcs()) starts.add(arc.start);
  const Cap cap = smallest_cap(starts.all());
  const double radius = geometry::angle_of_chord(cap.squared_chord);
  if (cap.centre == Vec3{} || !(radius < kRightAngle - kSurelyObtuse)) return std::nullopt;
  if (!is_clockwise_about(cap.centre, ring)) return std::nullopt;
  const Vec3 x = -cap.centre;
  return NormalNormal{x, 2.0 * kRightAngle - radius, ring.is_seen(x)};
}

/// Whether the arcs lie round a direction that the most visible normal looks away from: a guess at the above.
bool looks_like_tip(const Ring& ring) {
  Vec3 sum;
  for (const Arc& arc : ring.arcs()) sum += arc.start;
  return dot(sum, ring.most_visible()) < 0 &&
         std::all_of(ring.arcs().begin(), ring.arcs().end(), [&](const Arc& arc) { return dot(sum, arc.start) > 0; });
}

NormalNormal judged(const Ring& ring, const Candidate& c) {
  return {c.direction, c.distance.angle(), ring.is_seen(c.direction)};
}

}  // namespace

std::optional<NormalNormal> most_normal_normal(const Vec3& apex, std::span<const Vec3> neighbours) {
  Ring ring(neighbours.size());
  if (!ring.prepare(apex, neighbours)) return std::nullopt;
  Search search(ring);
  if (ring.reflex().empty()) return judged(ring, search.best());
  const bool is_flat = search.best().distance.cosine < kFlat;
  const bool is_tip = is_flat || looks_like_tip(ring);
  if (is_tip) {
    if (const auto opposite = opposite_of_cap(ring)) return opposite;
  }
  if (is_flat) return judged(ring, search.best());
  search.climb();
  if (search.is_proven()) return judged(ring, search.best());
  if (!is_tip) {
    if (const auto opposite = opposite_of_cap(ring)) return opposite;
  }
  return judged(ring, search.prove());
}

}  // namespace nearwall::surface

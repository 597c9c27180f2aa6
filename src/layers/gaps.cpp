#include <algorithm>
#include <cmath>
#include <optional>

#include "nearwall/core/parallel.h"
#include "nearwall/search/wall_tree.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;
using mesh::Topology;

/// Share of a gap that the two fronts in it may fill: a tenth of it stays free.
constexpr double kFilled = 0.9;

/// The point of a wall that is nearest to the middle of one ball is met by a smaller one elsewhere: a second ball comes
/// within a hundredth.
constexpr int kMostBalls = 2;

/// A ball reaches no farther than so many edges of its vertex: it is there for what rays miss between vertices, and on
/// bumpy walls larger ones hold ever more of them.
constexpr double kReach = 4.0;

/// Cosine from which a wall faces a line for the ball: one seen more edge-on stands beside the line, as at a concave
/// corner, from which lines lean away. On real surfaces 0 does the same, but there rounding would tell the two sides of
/// a square corner apart.
constexpr double kLeastFacing = 0.1;

/// The end of a line that is as far from another wall as the line is thick.
struct Meeting {
  double thickness = 0;  ///< of both, if both take the same
  double rate = 0;       ///< of the way to the other wall that the line loses for each unit by which it is thicker
};

/// Thickness at which the end of the line from p along s d is as far from q as the line is thick; nullopt if it moves
/// away from q or never comes so near. With w = p - q: (s² - 1) t² + 2 s (d·w) t + w² = 0, and the ball of that radius
/// round the end touches both walls. Source: docs/theory/layers.md, Eq. (7)
std::optional<Meeting> meeting_with(const Vec3& p, const Vec3& d, double s, const Vec3& q) {
  const Vec3 w = p - q;
  const double a = s * s - 1, b = s * dot(d, w), c = squared_norm(w);
  if (!(b < 0)) return std::nullopt;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  // The numerically stable form of the smaller root.
  const double t = c / (std::sqrt(discriminant) - b);
  if (!(t > 0)) return std::nullopt;
  const double rate = dot(d, q - (p + d * (s * t))) * s / t;
  if (!(rate > 0)) return std::nullopt;
  return Meeting{t, rate};
}

/// Limits lines by the walls that face them. Fronts share a gap fairly: each may have half, and what the other side
/// does not ask for.
class GapLimiter {
 public:
  GapLimiter(const Wall& wall, VertexField& field)
      : wall_(wall), field_(field), asked_(field.thickness), tree_(wall.surface) {}

  /// By the next wall on the way of a line.
  /// \param s  length along the direction for each thickness
  void limit_by_ray(VertexId v, const Vec3& d, double s) {
    const Vec3& p = wall_.surface.points[v];
    // Farther than this both sides may have all: an equal share is no less than what is asked.
    const Vec3 end = p + d * ((1 + s) * field_.thickness[v] / kFilled);
    const auto is_apart = [&](FaceId f) { return !has_corner(f, v); };
    auto hit = tree_.first_hit(p, end, is_apart);
    if (!hit.face.is_valid()) return;
    if (!faces(hit.face, d)) {
      // A wall met from behind or edge on is the far side of the corner that v stands in, unless the ray meets an edge
      // or a corner there, of which another face looks this way.
      const auto facing = tree_.first_hit(p, end, [&](FaceId f) { return is_apart(f) && faces(f, d); });
      if (!facing.face.is_valid() || facing.distance > hit.distance) return;
      hit = facing;
    }
    field_.lower(v, share(hit.face, {hit.distance / (1 + s), s}), LimitReason::Gap);
  }

  /// By walls that the front at the end of a line would come too near: those it passes by, and oblique ones.
  void limit_by_balls(VertexId v, const Vec3& d, double s) {
    const Vec3& p = wall_.surface.points[v];
    const double reach = kReach * longest_edge(v);
    for (int i = 0; i < kMostBalls; ++i) {
      // What lies outside of this ball leaves a tenth of the way free, or is so far away that the rays of neighbours
      // find it.
      const double radius = std::min(field_.thickness[v] / kFilled, reach);
      const Vec3 centre = p + d * (s * radius);
      bool is_lowered = false;
      for (const FaceId f : tree_.faces_near(centre, radius)) {
        if (has_corner(f, v) || !(dot(wall_.features.face_normal[f], d) < -kLeastFacing)) continue;
        const Vec3 q = tree_.nearest_on(f, centre);
        // Seen from behind it is a far side of v's own body.
        if (!(distance(q, centre) < radius) || !(dot(wall_.features.face_normal[f], p - q) > 0)) continue;
        const auto meeting = meeting_with(p, d, s, q);
        if (meeting && field_.lower(v, share(f, *meeting), LimitReason::Gap)) is_lowered = true;
      }
      if (!is_lowered) return;
    }
  }

 private:
  bool has_corner(FaceId f, VertexId v) const {
    const auto& corners = wall_.surface.faces[f];
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  }

  double longest_edge(VertexId v) const {
    double longest = 0;
    wall_.topology.for_each_neighbour(v, [&](VertexId u) {
      longest = std::max(longest, distance(wall_.surface.points[v], wall_.surface.points[u]));
    });
    return longest;
  }

  bool faces(FaceId f, const Vec3& d) const { return dot(wall_.features.face_normal[f], d) < 0; }

  /// The equal share, and what the other side leaves of its own. Its layers are taken for as thick as at its corner
  /// where most is asked. Source: docs/theory/layers.md, Eq. (8)
  double share(FaceId other, const Meeting& meeting) const {
    const double equal = kFilled * meeting.thickness;
    double asked = 0;
    for (const VertexId v : wall_.surface.faces[other]) asked = std::max(asked, asked_[v]);
    return asked < equal ? equal + (equal - asked) / meeting.rate : equal;
  }

  const Wall& wall_;
  VertexField& field_;
  const IdVector<VertexId, double> asked_;  // before any limit by gaps
  search::WallTree tree_;
};

}  // namespace

void limit_by_gaps(const Wall& wall, const LinePlan& plan, VertexField& field) {
  GapLimiter limiter(wall, field);
  parallel_for(field.thickness.size(), [&](std::size_t i) {
    const VertexId v(i);
    if (!(field.thickness[v] > 0)) return;
    for (const LineId line : plan.front.lines_of(v)) limiter.limit_by_ray(v, plan.direction[line], plan.stretch[line]);
    if (wall.features.kind[v] != surface::PointKind::Smooth) {
      // At a ridge or corner the line leaves between its faces and may pass by what each of them looks at.
      for (const HalfedgeId h : wall.topology.fan(v)) {
        limiter.limit_by_ray(v, wall.features.face_normal[Topology::face(h)], 1.0);
      }
    }
    for (const LineId line : plan.front.lines_of(v)) {
      limiter.limit_by_balls(v, plan.direction[line], plan.stretch[line]);
    }
  });
}

}  // namespace nearwall::layers

#include "plane_limit.h"

#include <algorithm>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"

namespace nearwall::layers {

namespace {

/// Share of the distance to a plane that a line leaves free.
constexpr double kLeftFree = 0.1;

/// Halvings by which the place where a line comes too near is found.
constexpr int kHalvings = 20;

class PlaneLimiter {
 public:
  PlaneLimiter(const Wall& wall, const LinePlan& plan, const VertexField& field)
      : wall_(wall), plan_(plan), field_(field), reach_(wall.planes->planes.size()) {
    const mesh::SidePlanes& planes = *wall.planes;
    for (const VertexId v : wall.surface.points.ids()) {
      for (const mesh::PlaneIndex p : planes.of(v)) reach_[p].include(wall.surface.points[v]);
    }
  }

  /// Largest thickness with which the lines of v end before all planes.
  double limit(VertexId v) const {
    double limit = field_.thickness[v];
    for (mesh::PlaneIndex p = 0; p < reach_.size(); ++p) {
      const double start = wall_.planes->planes[p].height(wall_.surface.points[v]);
      if (wall_.planes->is_on(v, p) || !(start > 0)) continue;
      for (const LineId line : plan_.front.lines_of(v)) limit = limit_at(line, p, start, limit);
    }
    return limit;
  }

 private:
  /// A plane counts as far as it goes, which is about as far as what lies on it.
  bool is_near(LineId line, mesh::PlaneIndex p, double thickness) const {
    const Vec3 end = wall_.surface.points[plan_.front.line_vertex[line]] + plan_.offset(line, thickness);
    const Vec3 margin(thickness, thickness, thickness);
    return geometry::Box{reach_[p].low - margin, reach_[p].high + margin}.contains(end);
  }

  double limit_at(LineId line, mesh::PlaneIndex p, double start, double thickness) const {
    const mesh::SidePlane& plane = wall_.planes->planes[p];
    const auto is_clear = [&](double t) {
      return start + dot(plane.normal, plan_.offset(line, t)) >= kLeftFree * start;
    };
    if (!(thickness > 0) || is_clear(thickness) || !is_near(line, p, thickness)) return thickness;
    double clear = 0, near = thickness;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (clear + near);
      (is_clear(middle) ? clear : near) = middle;
    }
    return clear;
  }

  const Wall& wall_;
  const LinePlan& plan_;
  const VertexField& field_;
  std::vector<geometry::Box> reach_;  // of what lies on each plane
};

}  // namespace

std::vector<VertexId> limit_by_planes(const Wall& wall, const LinePlan& plan, VertexField& field) {
  std::vector<VertexId> lowered;
  if (!wall.has_planes()) return lowered;
  const PlaneLimiter limiter(wall, plan, field);
  IdVector<VertexId, double> limit(field.thickness.size());
  parallel_for(limit.size(), [&](std::size_t i) { limit[VertexId(i)] = limiter.limit(VertexId(i)); });
  for (const VertexId v : limit.ids()) {
    if (field.lower(v, limit[v], mesh::LimitReason::Gap)) lowered.push_back(v);
  }
  return lowered;
}

}  // namespace nearwall::layers

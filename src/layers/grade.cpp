#include <algorithm>
#include <functional>
#include <optional>
#include <queue>

#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;

/// Rates at which thickness may rise along the surface from a vertex, by why it is thin there: docs/theory/layers.md,
/// section 7, has the figures. From one in a gap a front that rises by 45 degrees over a flat wall: its neighbours look
/// past the wall whose front they would meet. From a line that stays at the wall, as steep as the cells round it keep
/// their quality. The others between.
constexpr double kSlopeAtGap = 1.0;
constexpr double kSlopeAtBlocked = 4.0;
constexpr double kSlopeElsewhere = 2.0;

struct Entry {
  double thickness;
  VertexId vertex;
  friend bool operator>(const Entry& a, const Entry& b) {
    return a.thickness != b.thickness ? a.thickness > b.thickness : a.vertex > b.vertex;
  }
};

/// Nothing where no layer is asked for, and from what a neighbour lowered: that is graded already.
std::optional<double> slope_at(const VertexField& field, VertexId v) {
  if (!(field.asked[v] > 0)) return std::nullopt;
  if (!(field.thickness[v] > 0)) return kSlopeAtBlocked;
  if (field.reason[v] == LimitReason::Neighbour) return std::nullopt;
  return field.reason[v] == LimitReason::Gap ? kSlopeAtGap : kSlopeElsewhere;
}

/// Lowers what rises from the seeds of one slope by more than it, in order of thickness.
/// \param lowered  those that were are added
template <class Seeds>
void grade_at(double slope, const Wall& wall, const Seeds& seeds, VertexField& field, std::vector<VertexId>& lowered) {
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto lower_neighbours = [&](VertexId v) {
    const Vec3& p = wall.surface.points[v];
    wall.topology.for_each_neighbour(v, [&](VertexId u) {
      if (!(field.thickness[u] > field.thickness[v])) return;
      const double limit = field.thickness[v] + slope * distance(p, wall.surface.points[u]);
      if (!field.lower(u, limit, LimitReason::Neighbour)) return;
      lowered.push_back(u);
      queue.push({field.thickness[u], u});
    });
  };
  for (const VertexId v : seeds) {
    if (slope_at(field, v) == slope) lower_neighbours(v);
  }
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.thickness == field.thickness[entry.vertex]) lower_neighbours(entry.vertex);
  }
}

}  // namespace

std::vector<VertexId> grade(const Wall& wall, VertexField& field, const std::vector<VertexId>& seeds) {
  std::vector<VertexId> lowered;
  for (const double slope : {kSlopeAtGap, kSlopeElsewhere, kSlopeAtBlocked}) {
    if (seeds.empty()) {
      grade_at(slope, wall, field.thickness.ids(), field, lowered);
    } else {
      grade_at(slope, wall, seeds, field, lowered);
    }
  }
  std::sort(lowered.begin(), lowered.end());
  lowered.erase(std::unique(lowered.begin(), lowered.end()), lowered.end());
  return lowered;
}

}  // namespace nearwall::layers

#include <algorithm>
#include <queue>

#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;

/// Largest rate at which thickness may change along the surface: a front that rises by 45 degrees over a flat wall.
constexpr double kGradingSlope = 1.0;

struct Entry {
  double thickness;
  VertexId vertex;
  friend bool operator>(const Entry& a, const Entry& b) {
    return a.thickness != b.thickness ? a.thickness > b.thickness : a.vertex > b.vertex;
  }
};

void sort_and_unite(std::vector<VertexId>& vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

}  // namespace

std::vector<VertexId> grade(const Wall& wall, VertexField& field, const std::vector<VertexId>& seeds) {
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<VertexId> lowered;
  const auto lower_neighbours = [&](VertexId v) {
    // Where no layer is asked for, nothing limits.
    if (!(field.asked[v] > 0)) return;
    const Vec3& p = wall.surface.points[v];
    for (const HalfedgeId h : wall.topology.fan(v)) {
      const VertexId u = wall.topology.target(h);
      if (!(field.thickness[u] > field.thickness[v])) continue;
      const double limit = field.thickness[v] + kGradingSlope * distance(p, wall.surface.points[u]);
      if (!field.lower(u, limit, LimitReason::Neighbour)) continue;
      lowered.push_back(u);
      queue.push({field.thickness[u], u});
    }
  };
  if (seeds.empty()) {
    for (const VertexId v : field.thickness.ids()) lower_neighbours(v);
  } else {
    for (const VertexId v : seeds) queue.push({field.thickness[v], v});
  }
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.thickness == field.thickness[entry.vertex]) lower_neighbours(entry.vertex);
  }
  sort_and_unite(lowered);
  return lowered;
}

}  // namespace nearwall::layers

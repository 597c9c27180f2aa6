#include <algorithm>
#include <queue>
#include <utility>

#include "vertex_field.h"

namespace nearwall::layers {

std::vector<VertexId> step_levels(const Wall& wall, const Stacks& stacks, VertexField& field,
                                  const std::vector<VertexId>& seeds) {
  if (!stacks.has_level_steps()) return {};
  const auto end_of = [&](VertexId v) {
    return stacks.fit(field.request(v), field.thickness[v], field.max_level[v]).end;
  };
  using LevelEntry = std::pair<Level, VertexId>;
  std::priority_queue<LevelEntry, std::vector<LevelEntry>, std::greater<>> queue;
  const auto push = [&](VertexId v) {
    if (const Level end = end_of(v); end > 0) queue.push({end, v});
  };
  if (seeds.empty()) {
    for (const VertexId v : field.thickness.ids()) push(v);
  } else {
    for (const VertexId v : seeds) push(v);
  }
  std::vector<VertexId> lowered;
  while (!queue.empty()) {
    const auto [end, v] = queue.top();
    queue.pop();
    wall.topology.for_each_neighbour(v, [&, from = end](VertexId u) {
      const int allowed = from + stacks.level_step(field.schedule[u]);
      if (end_of(u) <= allowed) return;
      field.max_level[u] = static_cast<Level>(allowed);
      lowered.push_back(u);
      push(u);
    });
  }
  std::sort(lowered.begin(), lowered.end());
  lowered.erase(std::unique(lowered.begin(), lowered.end()), lowered.end());
  return lowered;
}

}  // namespace nearwall::layers

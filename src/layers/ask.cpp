#include <algorithm>
#include <queue>
#include <tuple>

#include "nearwall/core/parallel.h"
#include "nearwall/layers/isotropic.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;
using mesh::Topology;

/// Layers that a line has where its triangles are too narrow for more: two, for a line that starts a level late needs
/// a second one to go to.
constexpr Level kLeastLevels = 2;

/// What a patch asks of a vertex.
struct Request {
  StackRequest stack;
  bool ends_isotropic = false;
};

class Requests {
 public:
  Requests(const Wall& wall, const GrowOptions& options, const Stacks& stacks)
      : wall_(wall), options_(options), stacks_(stacks) {
    const auto& schedules = options.schedules;
    const bool any =
        std::any_of(schedules.begin(), schedules.end(), [](const auto& s) { return s.is_until_isotropic; });
    if (any) isotropic_ = isotropic_heights(wall.surface, wall.topology);
  }

  bool has_isotropic() const { return !isotropic_.empty(); }

  Request of(PatchId patch, VertexId v) const {
    const PatchSchedule& schedule = options_.schedules[patch];
    Request request{{patch.index(), 1.0, 0.0, stacks_.n_levels(patch.index())}, false};
    StackRequest& stack = request.stack;
    if (schedule.first_height) {
      stack.scale = length(*schedule.first_height, v) / schedule.heights.front();
    } else if (schedule.total_thickness) {
      stack.scale = length(*schedule.total_thickness, v) / stacks_.thickness(stack.patch, stack.levels);
    }
    if (schedule.is_until_isotropic) end_isotropic(schedule, v, request);
    stack.thickness = schedule.total_thickness ? length(*schedule.total_thickness, v)
                                               : stack.scale * stacks_.thickness(stack.patch, stack.levels);
    return request;
  }

 private:
  double length(const VertexLength& length, VertexId v) const {
    return length.array ? wall_.surface.point_arrays[*length.array].values[v] * length.factor : length.factor;
  }

  void end_isotropic(const PatchSchedule& schedule, VertexId v, Request& request) const {
    const std::vector<double>& heights = schedule.heights;
    const double height = isotropic_[v] / request.stack.scale;
    const Level level = isotropic_level(heights, height);
    request.stack.levels = std::max(std::min(kLeastLevels, request.stack.levels), level);
    // Where the heights themselves end first, another one might have come closer.
    const double last = heights.back(), before = heights.size() > 1 ? heights[heights.size() - 2] : last;
    request.ends_isotropic = level < heights.size() || height * height <= last * last * (last / before);
  }

  const Wall& wall_;
  const GrowOptions& options_;
  const Stacks& stacks_;
  IdVector<VertexId, double> isotropic_;  // (n_vertices), empty if no patch asks for it
};

/// Lowers the levels of lines that end where their layers are isotropic until none is asked to end above a neighbour by
/// more than the step of its patch.
void step_down(const Wall& wall, const GrowOptions& options, const Stacks& stacks, VertexField& field) {
  using LevelEntry = std::pair<Level, VertexId>;
  std::priority_queue<LevelEntry, std::vector<LevelEntry>, std::greater<>> queue;
  for (const VertexId v : field.levels.ids()) {
    if (field.levels[v] > 0) queue.push({field.levels[v], v});
  }
  while (!queue.empty()) {
    const auto [level, v] = queue.top();
    queue.pop();
    if (level != field.levels[v]) continue;
    wall.topology.for_each_neighbour(v, [&, from = level](VertexId u) {
      const std::uint32_t patch = field.schedule[u];
      if (field.levels[u] == 0 || !options.schedules[PatchId(patch)].is_until_isotropic) return;
      const int allowed = from + stacks.level_step(patch);
      if (field.levels[u] <= allowed) return;
      field.levels[u] = static_cast<Level>(allowed);
      field.ends_isotropic[u] = 1;
      field.asked[u] = field.scale[u] * stacks.thickness(patch, field.levels[u]);
      queue.push({field.levels[u], u});
    });
  }
}

VertexField empty_field(std::size_t n) {
  VertexField field;
  field.schedule.resize(n, 0);
  field.scale.resize(n, 1.0);
  field.asked.resize(n, 0.0);
  field.levels.resize(n, 0);
  field.ends_isotropic.resize(n, 0);
  field.thickness.resize(n, 0.0);
  field.max_level.resize(n, 0);
  field.reached.resize(n, 0.0);
  field.reason.resize(n, LimitReason::None);
  return field;
}

}  // namespace

VertexField ask(const Wall& wall, const GrowOptions& options, const Stacks& stacks) {
  const std::size_t n = wall.surface.points.size();
  const Requests requests(wall, options, stacks);
  VertexField field = empty_field(n);
  std::vector<char> is_at_edge(n, 0);  // of a patch without layers
  parallel_for(n, [&](std::size_t i) {
    const VertexId v(i);
    Request least;
    bool is_first = true;
    PatchId last;
    for (const HalfedgeId h : wall.topology.fan(v)) {
      const FaceId f = Topology::face(h);
      const PatchId patch = wall.surface.face_patch[f];
      if (!wall.is_wetted[f] || !options.schedules[patch].has_layers) {
        is_at_edge[i] = 1;
        continue;
      }
      if (patch == last) continue;
      last = patch;
      const Request request = requests.of(patch, v);
      // The patch number last: equal stacks must not be told apart by which face comes first.
      const auto size = [](const StackRequest& r) { return std::tuple(r.levels, r.thickness, r.patch); };
      if (is_first || size(request.stack) < size(least.stack)) least = request;
      is_first = false;
    }
    if (is_first) return;
    field.schedule[v] = least.stack.patch;
    field.scale[v] = least.stack.scale;
    field.asked[v] = least.stack.thickness;
    field.levels[v] = least.stack.levels;
    field.ends_isotropic[v] = least.ends_isotropic;
  });
  if (requests.has_isotropic()) step_down(wall, options, stacks, field);
  field.thickness = field.asked;
  field.max_level = field.levels;
  for (const VertexId v : field.asked.ids()) {
    const bool is_held = wall.has_planes() && !wall.planes->is_held.empty() && wall.planes->is_held[v];
    if ((is_at_edge[v.index()] || is_held) && field.asked[v] > 0) field.lower(v, 0, LimitReason::PatchEdge);
  }
  return field;
}

}  // namespace nearwall::layers

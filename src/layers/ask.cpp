#include <tuple>

#include "nearwall/core/parallel.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;
using mesh::Topology;

}  // namespace

VertexField ask(const Wall& wall, const GrowOptions& options, const Stacks& stacks) {
  const std::size_t n = wall.surface.points.size();
  VertexField field;
  field.schedule.resize(n, 0);
  field.asked.resize(n, 0.0);
  field.thickness.resize(n, 0.0);
  field.max_level.resize(n, 0);
  field.reached.resize(n, 0.0);
  field.reason.resize(n, LimitReason::None);
  parallel_for(n, [&](std::size_t i) {
    const VertexId v(i);
    std::size_t n_without = 0;
    const auto fan = wall.topology.fan(v);
    std::tuple<Level, double, std::uint32_t> least{};
    bool is_first = true;
    for (const HalfedgeId h : fan) {
      const FaceId f = Topology::face(h);
      const PatchId patch = wall.surface.face_patch[f];
      if (!wall.is_wetted[f] || !options.schedules[patch].has_layers) {
        ++n_without;
        continue;
      }
      // The patch number last: equal stacks must not be told apart by which face comes first.
      const std::tuple size(stacks.n_levels(patch.index()), stacks.asked_thickness(patch.index()), patch.index());
      if (is_first || size < least) {
        least = size;
        field.schedule[v] = patch.index();
        is_first = false;
      }
    }
    if (is_first) return;
    field.asked[v] = std::get<double>(least);
    field.thickness[v] = field.asked[v];
    field.max_level[v] = stacks.n_levels(field.schedule[v]);
    if (n_without > 0) field.lower(v, 0, LimitReason::PatchEdge);
  });
  return field;
}

}  // namespace nearwall::layers

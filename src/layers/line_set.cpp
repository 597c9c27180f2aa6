#include "line_set.h"

#include <algorithm>
#include <limits>

#include "nearwall/core/parallel.h"

namespace nearwall::layers {

namespace {

/// Heights below so many units in the last place of the largest coordinate would be more rounding than height.
constexpr double kResolvableUlps = 1e3;

mesh::LimitReason reason_or(mesh::LimitReason known, mesh::LimitReason otherwise) {
  return known == mesh::LimitReason::None ? otherwise : known;
}

void update_vertex(const LinePlan& plan, const Stacks& stacks, VertexId v, double finest, VertexField& field,
                   mesh::Lines& lines) {
  const mesh::Front& front = plan.front;
  Stack stack = stacks.fit(field.request(v), field.thickness[v], field.max_level[v]);
  if (stack.end > 0) {
    const mesh::Heights& h = stack.heights;
    const double first = (h.weight_0 + h.weight_1) * lines.table.row(h.row)[1];
    // A line that starts late needs a level to go to.
    if (!(first >= finest) || stack.end <= plan.start[v]) stack = {};
  }
  if (stack.end == 0) field.lower(v, 0, reason_or(field.reason[v], mesh::LimitReason::Quality));
  field.reached[v] = stack.thickness;
  if (stack.thickness < field.asked[v]) field.reason[v] = reason_or(field.reason[v], mesh::LimitReason::Neighbour);
  for (const LineId line : front.lines_of(v)) {
    lines.heights[line] = stack.heights;
    lines.windows[line] = {plan.start[v], stack.end};
  }
}

/// One straight piece up to each knot of a line.
void add_pieces(const LinePlan& plan, mesh::Lines& lines) {
  const std::size_t n = plan.direction.size();
  lines.pieces.reserve(n);
  lines.first_piece.reserve(n + 1);
  lines.first_piece.push_back(0);
  for (const LineId line : plan.direction.ids()) {
    lines.pieces.push_back({plan.foot(line), 0.0});
    if (plan.is_bent(line)) {
      const std::vector<Knot>& knots = plan.bends[line];
      for (std::size_t k = 1; k < knots.size(); ++k) {
        const Knot &from = knots[k - 1], &to = knots[k];
        lines.pieces.push_back({(to.offset - from.offset) / (to.at - from.at), from.at});
      }
    }
    lines.first_piece.push_back(static_cast<std::uint32_t>(lines.pieces.size()));
  }
}

}  // namespace

double resolution(const Wall& wall, const VertexField& field) {
  double largest = 0;
  for (const VertexId v : wall.surface.points.ids()) {
    if (field.asked[v] > 0) largest = std::max(largest, max_norm(wall.surface.points[v]));
  }
  return kResolvableUlps * std::numeric_limits<double>::epsilon() * largest;
}

mesh::Lines make_lines(const Wall& wall, const LinePlan& plan, const Stacks& stacks, VertexField& field) {
  const mesh::Front& front = plan.front;
  const std::size_t n = front.n_lines();
  mesh::Lines lines;
  lines.table = stacks.table();
  lines.base.resize(n);
  lines.heights.resize(n);
  lines.windows.resize(n);
  add_pieces(plan, lines);
  const double finest = resolution(wall, field);
  parallel_for(wall.surface.points.size(), [&](std::size_t i) {
    const VertexId v(i);
    for (const LineId line : front.lines_of(v)) lines.base[line] = wall.surface.points[v];
    update_vertex(plan, stacks, v, finest, field, lines);
  });
  return lines;
}

void update_lines(const LinePlan& plan, const Stacks& stacks, std::span<const VertexId> vertices, double resolution,
                  VertexField& field, mesh::Lines& lines) {
  for (const VertexId v : vertices) update_vertex(plan, stacks, v, resolution, field, lines);
}

}  // namespace nearwall::layers

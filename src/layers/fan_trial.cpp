#include "fan_trial.h"

#include <algorithm>

#include "nearwall/certify/certificate.h"
#include "nearwall/mesh/front_part.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

/// Thickness of the trial over the shortest edge at the vertex: small enough that directions alone matter.
constexpr double kTrialThickness = 1e-3;

double shortest_edge(const Wall& wall, VertexId v) {
  double shortest = 0;
  bool is_first = true;
  wall.topology.for_each_neighbour(v, [&](VertexId u) {
    const double length = distance(wall.surface.points[v], wall.surface.points[u]);
    if (is_first || length < shortest) shortest = length;
    is_first = false;
  });
  return shortest;
}

/// The faces round vertices with several lines, wall faces first as in any front.
mesh::FrontPart part_with_fans(const mesh::Front& front) {
  mesh::FrontPart part(front);
  for (const FrontFaceId f : front.faces.ids()) {
    const mesh::FrontFace& face = front.faces[f];
    const bool concerns_fans = std::any_of(face.lines.begin(), face.lines.begin() + face.size(),
                                           [&](LineId line) { return front.n_lines(front.line_vertex[line]) > 1; });
    if (concerns_fans) part.add(f);
  }
  return part;
}

/// Lines of the part, two layers high.
mesh::Lines trial_lines(const Wall& wall, const LinePlan& plan, const mesh::FrontPart& part) {
  mesh::Lines lines;
  lines.table = mesh::HeightTable({{0.0, 0.5, 1.0}});
  lines.first_piece.push_back(0);
  for (const LineId line : part.original_line()) {
    const VertexId v = plan.front.line_vertex[line];
    const double thickness = plan.cannot_leave[v] ? 0.0 : kTrialThickness * shortest_edge(wall, v);
    lines.base.push_back(wall.surface.points[v]);
    lines.pieces.push_back({plan.direction[line] * plan.stretch[line], 0.0});
    lines.first_piece.push_back(static_cast<std::uint32_t>(lines.pieces.size()));
    lines.heights.push_back({0, thickness, 0.0});
    lines.windows.push_back({plan.start[v], thickness > 0 ? Level{2} : Level{0}});
  }
  return lines;
}

std::vector<VertexId> vertices_of(const mesh::Front& front, FrontFaceId f) {
  std::vector<VertexId> vertices;
  for (int k = 0; k < front.faces[f].size(); ++k) {
    vertices.push_back(front.line_vertex[front.faces[f].lines[static_cast<std::size_t>(k)]]);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

std::vector<VertexId> find_unfit(const Wall& wall, const LinePlan& plan) {
  std::vector<VertexId> unfit;
  if (plan.front.faces.size() == plan.front.n_wall_faces) return unfit;
  const mesh::FrontPart part = part_with_fans(plan.front);
  const mesh::Front& front = part.front();
  const mesh::Lines lines = trial_lines(wall, plan, part);
  const auto blame = [&](const std::vector<VertexId>& vertices) {
    for (const VertexId v : vertices) {
      if (front.n_lines(v) > 1) unfit.push_back(part.original_vertex(v));
    }
  };
  for (const auto& bad : certify::bad_columns(front, lines)) blame(vertices_of(front, bad.face));
  for (const auto& [a, b] : certify::front_intersections(certify::front_surface(front, lines))) {
    const auto of_a = vertices_of(front, a), of_b = vertices_of(front, b);
    std::vector<VertexId> common;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
    blame(common.empty() ? of_a : common);
    if (common.empty()) blame(of_b);
  }
  for (const VertexId v : wall.surface.points.ids()) {
    if (plan.cannot_leave[v] && plan.front.n_lines(v) > 1) unfit.push_back(v);
  }
  std::sort(unfit.begin(), unfit.end());
  unfit.erase(std::unique(unfit.begin(), unfit.end()), unfit.end());
  return unfit;
}

}  // namespace nearwall::layers

#include "fan_trial.h"

#include <algorithm>

#include "nearwall/certify/certificate.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

/// Thickness of the trial over the shortest edge at the vertex: small enough that directions alone matter.
constexpr double kTrialThickness = 1e-3;

/// The part of a front that fans have to do with, with lines of its own.
struct Trial {
  mesh::Front front;
  mesh::Lines lines;
  IdVector<VertexId, VertexId> original;  ///< vertex of the wall
};

double shortest_edge(const Wall& wall, VertexId v) {
  double shortest = 0;
  bool is_first = true;
  for (const HalfedgeId h : wall.topology.fan(v)) {
    const double length = distance(wall.surface.points[v], wall.surface.points[wall.topology.target(h)]);
    if (is_first || length < shortest) shortest = length;
    is_first = false;
  }
  return shortest;
}

class TrialBuilder {
 public:
  TrialBuilder(const Wall& wall, const LinePlan& plan)
      : wall_(wall), plan_(plan), first_(wall.surface.points.size(), kNone) {
    trial_.front.first_line.push_back(0);
    trial_.lines.first_piece.push_back(0);
    trial_.lines.table = mesh::HeightTable({{0.0, 0.5, 1.0}});
  }

  void add_face(FrontFaceId f) {
    mesh::FrontFace face = plan_.front.faces[f];
    for (int k = 0; k < plan_.front.faces[f].size(); ++k) {
      LineId& line = face.lines[static_cast<std::size_t>(k)];
      line = local(line);
    }
    trial_.front.faces.push_back(face);
    if (plan_.front.is_wall(f)) ++trial_.front.n_wall_faces;
  }

  Trial take() { return std::move(trial_); }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  LineId local(LineId line) {
    const VertexId v = plan_.front.line_vertex[line];
    if (first_[v] == kNone) add_vertex(v);
    return LineId(first_[v] + (line.index() - plan_.front.first_line[v.index()]));
  }

  void add_vertex(VertexId v) {
    first_[v] = static_cast<std::uint32_t>(trial_.front.n_lines());
    const VertexId own = trial_.original.push_back(v);
    const double thickness = plan_.cannot_leave[v] ? 0.0 : kTrialThickness * shortest_edge(wall_, v);
    const mesh::Window window{plan_.start[v], thickness > 0 ? Level{2} : Level{0}};
    for (std::uint32_t i = plan_.front.first_line[v.index()]; i < plan_.front.first_line[v.index() + 1]; ++i) {
      trial_.front.line_vertex.push_back(own);
      trial_.lines.base.push_back(wall_.surface.points[v]);
      trial_.lines.pieces.push_back({plan_.direction[LineId(i)] * plan_.stretch[LineId(i)], 0.0});
      trial_.lines.first_piece.push_back(static_cast<std::uint32_t>(trial_.lines.pieces.size()));
      trial_.lines.heights.push_back({0, thickness, 0.0});
      trial_.lines.windows.push_back(window);
    }
    trial_.front.first_line.push_back(static_cast<std::uint32_t>(trial_.front.n_lines()));
  }

  const Wall& wall_;
  const LinePlan& plan_;
  Trial trial_;
  IdVector<VertexId, std::uint32_t> first_;  // line of the trial, (n_vertices)
};

bool has_several(const mesh::Front& front, VertexId v) {
  return front.first_line[v.index() + std::size_t{1}] - front.first_line[v.index()] > 1;
}

/// Wall faces first, as a front has them.
Trial make_trial(const Wall& wall, const LinePlan& plan) {
  TrialBuilder builder(wall, plan);
  for (const FrontFaceId f : plan.front.faces.ids()) {
    const mesh::FrontFace& face = plan.front.faces[f];
    const bool concerns_fans = std::any_of(face.lines.begin(), face.lines.begin() + face.size(), [&](LineId line) {
      return has_several(plan.front, plan.front.line_vertex[line]);
    });
    if (concerns_fans) builder.add_face(f);
  }
  return builder.take();
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
  const Trial trial = make_trial(wall, plan);
  const auto blame = [&](const std::vector<VertexId>& vertices) {
    for (const VertexId v : vertices) {
      if (has_several(trial.front, v)) unfit.push_back(trial.original[v]);
    }
  };
  for (const auto& bad : certify::bad_columns(trial.front, trial.lines)) blame(vertices_of(trial.front, bad.face));
  for (const auto& [a, b] : certify::front_intersections(certify::front_surface(trial.front, trial.lines))) {
    const auto of_a = vertices_of(trial.front, a), of_b = vertices_of(trial.front, b);
    std::vector<VertexId> common;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
    blame(common.empty() ? of_a : common);
    if (common.empty()) blame(of_b);
  }
  for (const VertexId v : wall.surface.points.ids()) {
    if (plan.cannot_leave[v] && has_several(plan.front, v)) unfit.push_back(v);
  }
  std::sort(unfit.begin(), unfit.end());
  unfit.erase(std::unique(unfit.begin(), unfit.end()), unfit.end());
  return unfit;
}

}  // namespace nearwall::layers

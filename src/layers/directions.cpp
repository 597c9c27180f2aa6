#include <algorithm>
#include <cmath>

#include "fan_trial.h"
#include "nearwall/geometry/measures.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

/// Sweeps per thickness in edge lengths, and their range. A sweep carries a direction about one edge far, less as they
/// go on; near concave ridges directions must lean away over a distance comparable to the thickness.
constexpr double kSweepsPerEdge = 4.0;
constexpr int kMinSweeps = 2;
constexpr int kMaxSweeps = 40;

/// Vertices whose fans do not fit get one line, and whether the ends of the fans beside them fit then has to be seen:
/// what still does not after so many plans is left to the certificate.
constexpr int kMostPlans = 4;

int automatic_sweeps(const Wall& wall, const VertexField& field) {
  geometry::CompensatedSum edges, thickness;
  std::size_t n_edges = 0, n_lines = 0;
  for (const FaceId f : wall.surface.faces.ids()) {
    const auto t = wall.surface.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) edges.add(distance(t[k], t[(k + 1) % 3]));
    n_edges += 3;
  }
  for (const double t : field.asked) {
    if (!(t > 0)) continue;
    thickness.add(t);
    ++n_lines;
  }
  if (n_lines == 0 || !(edges.value() > 0)) return 0;
  const double ratio = (thickness.value() / double(n_lines)) / (edges.value() / double(n_edges));
  return static_cast<int>(std::clamp(std::ceil(kSweepsPerEdge * ratio), double(kMinSweeps), double(kMaxSweeps)));
}

/// What each vertex sees: of its groups the one that is seen worst.
IdVector<VertexId, surface::PointNormal> worst_of_groups(const Wall& wall, const CutWall& cut,
                                                         const IdVector<VertexId, surface::PointNormal>& of_copies) {
  if (!cut.has_cuts()) return of_copies;
  IdVector<VertexId, surface::PointNormal> worst(wall.surface.points.size());
  for (const VertexId v : worst.ids()) {
    worst[v] = of_copies[cut.first_copy(v)];
    for (std::size_t k = 1; k < cut.n_copies(v); ++k) {
      const auto& normal = of_copies[VertexId(cut.first_copy(v).index() + k)];
      if (normal.max_angle > worst[v].max_angle) worst[v] = normal;
    }
  }
  return worst;
}

/// Plans lines, again with fewer cuts where fans do not fit.
class Directions {
 public:
  Directions(const Wall& wall, const GrowOptions& options, const VertexField& field)
      : wall_(wall), options_(options), is_cut_(find_cuts(wall, options)) {
    smoothing_.filter = options.filter;
    if (options.filter != surface::SmoothingFilter::None) {
      smoothing_.iterations = options.smoothing_iterations.value_or(automatic_sweeps(wall, field));
    }
  }

  LinePlan plan() {
    const CutWall cut(wall_, is_cut_);
    auto of_copies =
        surface::point_normals(cut.surface(), cut.topology(), cut.features(), {.method = options_.normals});
    surface::replace_blind_normals(cut.surface(), cut.topology(), cut.features(), of_copies);
    normals_ = worst_of_groups(wall_, cut, of_copies);
    if (smoothing_.filter != surface::SmoothingFilter::None) {
      const auto held = cut.has_cuts() ? cut.held_copies() : IdVector<VertexId, char>();
      surface::smooth_normals(cut.surface(), cut.topology(), cut.features(), smoothing_, of_copies, held);
    }
    return plan_lines(wall_, cut, of_copies, options_.max_turn);
  }

  /// From now on the vertex has one line: the ridges that meet there have several up to their last vertex but it.
  void uncut(VertexId v) {
    for (const HalfedgeId h : wall_.topology.fan(v)) is_cut_[h] = is_cut_[wall_.topology.twin(h)] = 0;
  }

  IdVector<VertexId, surface::PointNormal> take_normals() { return std::move(normals_); }
  int sweeps() const { return smoothing_.iterations; }

 private:
  const Wall& wall_;
  const GrowOptions& options_;
  IdVector<HalfedgeId, char> is_cut_;
  surface::SmoothingOptions smoothing_;
  IdVector<VertexId, surface::PointNormal> normals_;
};

}  // namespace

LinePlan set_lines(const Wall& wall, const GrowOptions& options, VertexField& field,
                   IdVector<VertexId, surface::PointNormal>& normals, int& sweeps) {
  Directions directions(wall, options, field);
  LinePlan plan = directions.plan();
  for (int round = 0; round < kMostPlans; ++round) {
    const std::vector<VertexId> unfit = find_unfit(wall, plan);
    if (unfit.empty()) break;
    for (const VertexId v : unfit) directions.uncut(v);
    plan = directions.plan();
  }
  normals = directions.take_normals();
  sweeps = directions.sweeps();
  for (const VertexId v : wall.surface.points.ids()) {
    if (plan.cannot_leave[v]) field.lower(v, 0, mesh::LimitReason::Visibility);
  }
  return plan;
}

}  // namespace nearwall::layers

#include <algorithm>
#include <cmath>
#include <optional>

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
/// what still does not after so many trials is left to the certificate.
constexpr int kMostTrials = 4;

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

/// The normals of all groups of faces, for the cuts there are.
class Directions {
 public:
  Directions(const Wall& wall, const GrowOptions& options)
      : wall_(wall), options_(options), is_cut_(find_cuts(wall, options)) {
    find_normals();
  }

  bool has_cuts() const { return cut_->has_cuts(); }
  LinePlan plan() const { return plan_lines(wall_, *cut_, of_copies_, options_.max_turn); }
  IdVector<VertexId, surface::PointNormal> normals() const { return worst_of_groups(wall_, *cut_, of_copies_); }

  /// From now on the vertices have one line: the ridges that meet there end in a single line at the vertex before.
  void uncut(const std::vector<VertexId>& vertices) {
    for (const VertexId v : vertices) {
      for (const HalfedgeId h : wall_.topology.fan(v)) is_cut_[h] = is_cut_[wall_.topology.twin(h)] = 0;
    }
    shorten_cuts(wall_, options_, is_cut_);
    find_normals();
  }

  void smooth(int sweeps) {
    const auto held = has_cuts() ? cut_->held_copies() : IdVector<VertexId, char>();
    const surface::SmoothingOptions smoothing{.filter = options_.filter, .iterations = sweeps};
    surface::smooth_normals(cut_->surface(), cut_->topology(), cut_->features(), smoothing, of_copies_, held);
  }

 private:
  void find_normals() {
    cut_.emplace(wall_, is_cut_);
    of_copies_ =
        surface::point_normals(cut_->surface(), cut_->topology(), cut_->features(), {.method = options_.normals});
    surface::replace_blind_normals(cut_->surface(), cut_->topology(), cut_->features(), of_copies_);
  }

  const Wall& wall_;
  const GrowOptions& options_;
  IdVector<HalfedgeId, char> is_cut_;
  std::optional<CutWall> cut_;
  IdVector<VertexId, surface::PointNormal> of_copies_;
};

}  // namespace

LinePlan set_lines(const Wall& wall, const GrowOptions& options, VertexField& field,
                   IdVector<VertexId, surface::PointNormal>& normals, int& sweeps) {
  Directions directions(wall, options);
  // Smoothing holds the normals at cuts, so whether fans fit can be seen before it.
  for (int round = 0; round < kMostTrials && directions.has_cuts(); ++round) {
    const std::vector<VertexId> unfit = find_unfit(wall, directions.plan());
    if (unfit.empty()) break;
    directions.uncut(unfit);
  }
  normals = directions.normals();
  sweeps = 0;
  if (options.filter != surface::SmoothingFilter::None) {
    sweeps = options.smoothing_iterations.value_or(automatic_sweeps(wall, field));
    directions.smooth(sweeps);
  }
  LinePlan plan = directions.plan();
  for (const VertexId v : wall.surface.points.ids()) {
    if (plan.cannot_leave[v]) field.lower(v, 0, mesh::LimitReason::Visibility);
  }
  return plan;
}

}  // namespace nearwall::layers

#include <optional>
#include <utility>

#include "fan_trial.h"
#include "nearwall/surface/plane_normals.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

/// Sweeps of smoothing unless asked for others: they even out what a few triangles say. Leaning away from concave
/// ridges is solved for, lean.h; more sweeps bring nothing there and overshoot beside sharp ridges.
constexpr int kSweeps = 2;

/// Vertices whose fans do not fit get one line, and whether the ends of the fans beside them fit then has to be seen:
/// what still does not after so many trials is left to the certificate.
constexpr int kMostTrials = 4;

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
  Directions(const Wall& wall, const GrowOptions& options, IdVector<HalfedgeId, char> is_cut)
      : wall_(wall), options_(options), is_cut_(std::move(is_cut)) {
    find_normals();
  }

  bool has_cuts() const { return cut_->has_cuts(); }
  LinePlan plan() const { return plan_lines(wall_, *cut_, of_copies_, options_.max_turn); }
  IdVector<VertexId, surface::PointNormal> normals() const { return worst_of_groups(wall_, *cut_, of_copies_); }

  /// From now on the vertices have one line: the ridges that meet there end in a single line at the vertex before.
  void uncut(const std::vector<VertexId>& vertices) {
    for (const VertexId v : vertices) {
      for (const HalfedgeId h : wall_.topology.fan(v)) {
        if (is_cut_[h]) is_cut_[h] = is_cut_[wall_.topology.twin(h)] = 0;
      }
    }
    shorten_cuts(wall_, options_, is_cut_);
    find_normals();
  }

  void smooth(int sweeps) {
    const auto held = has_cuts() || wall_.has_planes() ? cut_->held_copies() : IdVector<VertexId, char>();
    const surface::SmoothingOptions smoothing{.filter = options_.filter, .iterations = sweeps};
    surface::smooth_normals(cut_->surface(), cut_->topology(), cut_->features(), smoothing, of_copies_, held);
  }

 private:
  void find_normals() {
    cut_.emplace(wall_, is_cut_);
    of_copies_ =
        surface::point_normals(cut_->surface(), cut_->topology(), cut_->features(), {.method = options_.normals});
    surface::replace_blind_normals(cut_->surface(), cut_->topology(), cut_->features(), of_copies_);
    if (wall_.has_planes()) {
      surface::hold_in_planes(cut_->surface(), cut_->topology(), cut_->features(), cut_->planes(), of_copies_);
    }
  }

  const Wall& wall_;
  const GrowOptions& options_;
  IdVector<HalfedgeId, char> is_cut_;
  std::optional<CutWall> cut_;
  IdVector<VertexId, surface::PointNormal> of_copies_;
};

}  // namespace

LinePlan set_lines(const Wall& wall, const GrowOptions& options, const IdVector<HalfedgeId, char>& is_cut,
                   VertexField& field, IdVector<VertexId, surface::PointNormal>& normals, int& sweeps) {
  Directions directions(wall, options, is_cut);
  // Smoothing holds the normals at cuts, so whether fans fit can be seen before it.
  for (int round = 0; round < kMostTrials && directions.has_cuts(); ++round) {
    const std::vector<VertexId> unfit = find_unfit(wall, directions.plan());
    if (unfit.empty()) break;
    directions.uncut(unfit);
  }
  normals = directions.normals();
  sweeps = 0;
  if (options.filter != surface::SmoothingFilter::None) {
    sweeps = options.smoothing_iterations.value_or(kSweeps);
    directions.smooth(sweeps);
  }
  LinePlan plan = directions.plan();
  for (const VertexId v : wall.surface.points.ids()) {
    if (plan.cannot_leave[v]) field.lower(v, 0, mesh::LimitReason::Visibility);
  }
  return plan;
}

}  // namespace nearwall::layers

#include "lean.h"

#include <algorithm>
#include <queue>

#include "lean_solver.h"
#include "merit.h"
#include "nearwall/core/parallel.h"
#include "stretch.h"
#include "swept_limit.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

/// Heights at which lines may bend, in thicknesses. Twice as many give the same and take twice the time.
constexpr std::array<double, 4> kHeights = {1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0};

/// Length over which directions are smoothed, in heights of their bend. Beside a square corner, lean l and height h,
/// the front would fold at l < h; on real surfaces 1 keeps 0.5 % less of the thickness, 2 as much less.
constexpr double kLength = 1.5;
/// Directions change within so many such lengths of a crossing.
constexpr double kReach = 3.0;

/// A line that would lean too far does so by half the angle, so many times, or not at all.
constexpr int kMostHalvings = 5;

/// What is made worse is held and the rest solved for again, so many times; then it goes back to what it was.
constexpr int kRounds = 3;
/// What goes back may harm its neighbours, which go back, too: that many times, then all of the height's changes do.
constexpr int kMostReturns = 50;

/// A face is worse off if it keeps less than this share of what it did, or of nearly all if it kept more.
constexpr double kWorse = 0.5;
constexpr double kNearlyAll = 0.97;

/// Vertices whose lines may bend.
struct Region {
  std::vector<VertexId> vertices;
  IdVector<VertexId, int> number;  ///< (n_vertices) place in `vertices`; negative outside
  std::vector<char> is_held;       ///< (n_region) 1: keeps its line
  std::vector<FaceId> faces;       ///< round them
};

class Leaning {
 public:
  Leaning(const Wall& wall, const VertexField& field, LinePlan& plan) : wall_(wall), field_(field), plan_(plan) {
    limit_.resize(wall.surface.faces.size());
    parallel_for(limit_.size(), [&](std::size_t i) { limit_[FaceId(i)] = limit_of(FaceId(i)); });
  }

  void run() {
    const auto crosses = [](double limit) { return kSweptShare * limit < 1 && limit > 0; };
    if (std::none_of(limit_.begin(), limit_.end(), crosses)) return;
    if (plan_.bends.empty()) plan_.bends.resize(plan_.direction.size());
    double below = 0;
    for (const double height : kHeights) {
      bend_at(below, height);
      below = height;
    }
  }

 private:
  /// Share of their thickness at which the lines of a face cross; infinity if they never do or it has none.
  double limit_of(FaceId f) const { return swept_limit(wall_.surface.triangle(f), tops_of(plan_, field_, wall_, f)); }

  bool is_free(VertexId v) const {
    const surface::PointKind kind = wall_.features.kind[v];
    return (kind == surface::PointKind::Smooth || kind == surface::PointKind::Ridge) && field_.thickness[v] > 0 &&
           plan_.front.n_lines(v) == 1 && plan_.start[v] == 0;
  }

  double least_cosine(VertexId v, const Vec3& direction) const {
    double least = 1;
    for (const HalfedgeId h : wall_.topology.fan(v)) {
      least = std::min(least, dot(direction, wall_.features.face_normal[Topology::face(h)]));
    }
    return least;
  }

  /// What lies near faces whose lines cross below a height, in order of distance from them.
  Region region_at(double height) const {
    struct Entry {
      double left;
      VertexId vertex;
      bool operator<(const Entry& o) const { return left != o.left ? left < o.left : vertex > o.vertex; }
    };
    const std::size_t n = wall_.surface.points.size();
    std::priority_queue<Entry> queue;
    IdVector<VertexId, double> left(n, 0.0);
    const auto reach = [&](VertexId v, double distance_left) {
      if (!(distance_left > left[v])) return;
      left[v] = distance_left;
      queue.push({distance_left, v});
    };
    for (const FaceId f : wall_.surface.faces.ids()) {
      if (!(kSweptShare * limit_[f] < height) || limit_[f] == 0) continue;
      const auto& corners = wall_.surface.faces[f];
      if (std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return is_free(v); })) continue;
      for (const VertexId v : corners) reach(v, kReach * kLength * height * field_.thickness[v]);
    }
    Region region;
    region.number.resize(n, -1);
    while (!queue.empty()) {
      const Entry entry = queue.top();
      queue.pop();
      const VertexId v = entry.vertex;
      if (entry.left < left[v]) continue;
      if (is_free(v)) {
        region.number[v] = static_cast<int>(region.vertices.size());
        region.vertices.push_back(v);
      }
      wall_.topology.for_each_neighbour(
          v, [&](VertexId u) { reach(u, entry.left - distance(wall_.surface.points[v], wall_.surface.points[u])); });
    }
    region.is_held.resize(region.vertices.size(), 0);
    for (const VertexId v : region.vertices) {
      for (const HalfedgeId h : wall_.topology.fan(v)) region.faces.push_back(Topology::face(h));
    }
    std::sort(region.faces.begin(), region.faces.end());
    region.faces.erase(std::unique(region.faces.begin(), region.faces.end()), region.faces.end());
    return region;
  }

  void bend_at(double below, double height) {
    Region region = region_at(height);
    if (region.vertices.empty()) return;
    std::vector<std::vector<Knot>> old;
    for (const VertexId v : region.vertices) old.push_back(plan_.bends[plan_.front.line_of(v)]);
    std::vector<double> before;
    for (const FaceId f : region.faces) before.push_back(merit(wall_, plan_, field_, field_.thickness, f, height));
    const auto restore = [&](std::size_t i) { plan_.bends[plan_.front.line_of(region.vertices[i])] = old[i]; };

    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t i = 0; i < old.size(); ++i) restore(i);
      bend_all(surface::PointKind::Ridge, region, below, height);
      bend_all(surface::PointKind::Smooth, region, below, height);
      if (hold_where_worse(before, height, region).empty()) break;
    }
    for (int round = 0; round <= kMostReturns; ++round) {
      const auto held = hold_where_worse(before, height, region, round == 0);
      if (held.empty()) break;
      for (std::size_t i = 0; i < old.size(); ++i) {
        if (region.is_held[i] || round == kMostReturns) restore(i);
      }
    }
    for (const FaceId f : region.faces) limit_[f] = limit_of(f);
  }

  /// Bends what is not held, of one kind.
  void bend_all(surface::PointKind kind, const Region& region, double below, double height) {
    std::vector<VertexId> vertices;
    IdVector<VertexId, int> number(region.number.size(), -1);
    for (std::size_t i = 0; i < region.vertices.size(); ++i) {
      const VertexId v = region.vertices[i];
      if (region.is_held[i] || wall_.features.kind[v] != kind) continue;
      number[v] = static_cast<int>(vertices.size());
      vertices.push_back(v);
    }
    const std::vector<Vec3> directions = solve_lean(wall_, field_, plan_, vertices, number, kLength * height);
    parallel_for(vertices.size(), [&](std::size_t i) { bend(vertices[i], directions[i], below, height); });
  }

  /// Lets the line of v pass a place at a height from where it goes on as it did below.
  void bend(VertexId v, Vec3 direction, double below, double height) {
    const LineId line = plan_.front.line_of(v);
    if (wall_.has_planes()) direction = wall_.planes->within(v, direction);
    const double thickness = field_.thickness[v], size = norm(direction);
    if (!(size > 0)) return;
    direction = direction / size;
    const Vec3 chord = plan_.offset(line, thickness), own = chord / norm(chord);
    const double least = std::min(kLeastCosine, least_cosine(v, own));
    for (int halvings = 0; least_cosine(v, direction) < least; ++halvings) {
      if (halvings == kMostHalvings) return;
      direction = direction + own;
      const double sum = norm(direction);
      if (!(sum > 0)) return;
      direction = direction / sum;
    }
    std::vector<Knot>& knots = plan_.bends[line];
    if (below > 0 && (knots.empty() || knots.back().at < below * thickness)) {
      const Vec3 start = plan_.offset(line, below * thickness);
      knots.push_back({below * thickness, start});
    }
    const double at = height * thickness;
    knots.push_back({at, direction * (stretch_of(wall_, v, direction) * at)});
  }

  /// \param again  vertices that are held already are named, too
  /// \returns places in the region that are held because faces round them keep less than before
  std::vector<std::size_t> hold_where_worse(const std::vector<double>& before, double height, Region& region,
                                            bool again = false) {
    std::vector<char> is_worse(region.faces.size());
    parallel_for(is_worse.size(), [&](std::size_t i) {
      const double now = merit(wall_, plan_, field_, field_.thickness, region.faces[i], height);
      is_worse[i] = now < kWorse * std::min(kNearlyAll, before[i]);
    });
    std::vector<std::size_t> held;
    for (std::size_t i = 0; i < is_worse.size(); ++i) {
      if (!is_worse[i]) continue;
      for (const VertexId v : wall_.surface.faces[region.faces[i]]) {
        if (region.number[v] < 0) continue;
        const auto k = static_cast<std::size_t>(region.number[v]);
        if (region.is_held[k] && !again) continue;
        region.is_held[k] = 1;
        held.push_back(k);
      }
    }
    return held;
  }

  const Wall& wall_;
  const VertexField& field_;
  LinePlan& plan_;
  IdVector<FaceId, double> limit_;
};

}  // namespace

void lean_lines(const Wall& wall, const VertexField& field, LinePlan& plan) { Leaning(wall, field, plan).run(); }

}  // namespace nearwall::layers

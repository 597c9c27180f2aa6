#include "line_search.h"

#include <algorithm>
#include <cmath>

#include "merit.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "stretch.h"
#include "swept_limit.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

/// Sweeps over all lines concerned. Six bring no more than two.
constexpr int kSweeps = 2;

/// Angles by which a line is turned, one after the other.
constexpr std::array<double, 3> kTurns = {geometry::to_radians(15), geometry::to_radians(7.5),
                                          geometry::to_radians(3.75)};

/// Ways to which it is turned, evenly round it.
constexpr int kWays = 8;

/// A turned line bends at this share of its thickness, or of the height at which lines cross, and not where that is
/// lower than the last: it would be no use to first heights.
constexpr double kKnee = 0.1;
constexpr double kKneeOfCrossing = 0.5;
constexpr double kLeastKnee = 1e-3;

/// A gain of less is rounding.
constexpr double kLeastGain = 1e-6;

class LineSearch {
 public:
  LineSearch(const Wall& wall, const VertexField& field, LinePlan& plan) : wall_(wall), field_(field), plan_(plan) {}

  void run() {
    const std::vector<VertexId> vertices = vertices_concerned();
    if (vertices.empty()) return;
    if (plan_.bends.empty()) plan_.bends.resize(plan_.direction.size());
    std::vector<double> knee;
    for (const VertexId v : vertices) knee.push_back(knee_of(v));
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (std::size_t i = 0; i < vertices.size(); ++i) improve(vertices[i], knee[i]);
    }
  }

 private:
  /// What makes a line what it is.
  struct Course {
    Vec3 direction;
    double stretch;
    std::vector<Knot> knots;
  };

  double limit_of(FaceId f) const {
    return kSweptShare * swept_limit(wall_.surface.triangle(f), tops_of(plan_, field_, wall_, f));
  }

  /// In increasing order.
  std::vector<VertexId> vertices_concerned() const {
    std::vector<VertexId> vertices;
    for (const FaceId f : wall_.surface.faces.ids()) {
      if (!(limit_of(f) < 1)) continue;
      for (const VertexId v : wall_.surface.faces[f]) {
        if (plan_.front.n_lines(v) == 1 && plan_.start[v] == 0 && field_.thickness[v] > 0) vertices.push_back(v);
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  /// Thickness at which the line of v may bend first; 0: it is turned as a whole.
  double knee_of(VertexId v) const {
    double crossing = 1;
    for (const HalfedgeId h : wall_.topology.fan(v)) crossing = std::min(crossing, limit_of(Topology::face(h)));
    const double share = std::min(kKnee, kKneeOfCrossing * crossing);
    return share < kLeastKnee ? 0 : share * field_.thickness[v];
  }

  /// Area that the faces round v keep.
  double kept_round(VertexId v) const {
    double kept = 0;
    for (const HalfedgeId h : wall_.topology.fan(v)) {
      const FaceId f = Topology::face(h);
      const auto [a, b, c] = wall_.surface.triangle(f);
      kept += geometry::triangle_area(a, b, c) * merit(wall_, plan_, field_, field_.thickness, f);
    }
    return kept;
  }

  bool sees(VertexId v, const Vec3& direction) const {
    const auto fan = wall_.topology.fan(v);
    return std::all_of(fan.begin(), fan.end(), [&](HalfedgeId h) {
      return dot(direction, wall_.features.face_normal[Topology::face(h)]) > kLeastCosine;
    });
  }

  void set(LineId line, const Course& course) {
    plan_.direction[line] = course.direction;
    plan_.stretch[line] = course.stretch;
    plan_.bends[line] = course.knots;
  }

  Course turned(const Course& from, VertexId v, const Vec3& direction, double knee) const {
    Course to = from;
    const double stretch = stretch_of(wall_, v, direction);
    if (!to.knots.empty()) {
      to.knots.back().offset = direction * (stretch * to.knots.back().at);
    } else if (knee > 0) {
      to.knots = {{knee, from.direction * (from.stretch * knee)},
                  {field_.thickness[v], direction * (stretch * field_.thickness[v])}};
    } else {
      to.direction = direction;
      to.stretch = stretch;
    }
    return to;
  }

  void improve(VertexId v, double knee) {
    const LineId line = plan_.front.line_of(v);
    double best = kept_round(v);
    for (const double turn : kTurns) {
      const Course start{plan_.direction[line], plan_.stretch[line], plan_.bends[line]};
      Course chosen = start;
      const Vec3 chord = plan_.offset(line, field_.thickness[v]), d = chord / norm(chord);
      const Vec3 edge =
          wall_.surface.points[wall_.topology.target(wall_.topology.fan(v).front())] - wall_.surface.points[v];
      Vec3 along = edge - d * dot(edge, d);
      const double size = norm(along);
      if (!(size > 0)) return;
      along = along / size;
      const Vec3 across = cross(d, along);
      for (int way = 0; way < kWays; ++way) {
        const double angle = 2 * geometry::kPi * way / kWays;
        const Vec3 aside = along * std::cos(angle) + across * std::sin(angle);
        Vec3 tried = d * std::cos(turn) + aside * std::sin(turn);
        if (wall_.has_planes()) tried = wall_.planes->within(v, tried);
        tried = tried / norm(tried);
        if (!sees(v, tried)) continue;
        const Course course = turned(start, v, tried, knee);
        set(line, course);
        const double kept = kept_round(v);
        if (!(kept > best * (1 + kLeastGain))) continue;
        best = kept;
        chosen = course;
      }
      set(line, chosen);
    }
  }

  const Wall& wall_;
  const VertexField& field_;
  LinePlan& plan_;
};

}  // namespace

void search_lines(const Wall& wall, const VertexField& field, LinePlan& plan) { LineSearch(wall, field, plan).run(); }

}  // namespace nearwall::layers

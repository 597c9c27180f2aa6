#include "line_plan.h"

#include <algorithm>

#include "corner_polygon.h"
#include "fans.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "stretch.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

struct Corner {
  std::vector<LineId> loop;  ///< the lines round it, then its centre line if it has one
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

class Planner {
 public:
  Planner(const Wall& wall, const CutWall& cut, const IdVector<VertexId, surface::PointNormal>& normal, double max_turn)
      : wall_(wall), cut_(cut), group_direction_(directions_of(normal)), fans_(wall, cut, group_direction_, max_turn) {
    const std::size_t n = wall.surface.points.size();
    plan_.start.resize(n, 0);
    plan_.cannot_leave.resize(n, 0);
    for (const VertexId v : fans_.twisted()) plan_.cannot_leave[v] = 1;
    for (const VertexId copy : normal.ids()) {
      if (!normal[copy].is_visible) plan_.cannot_leave[cut.original(copy)] = 1;
    }
  }

  LinePlan plan() {
    for (const VertexId v : wall_.surface.points.ids()) add_lines(v);
    plan_.front.first_line.push_back(static_cast<std::uint32_t>(plan_.direction.size()));
    add_wall_faces();
    if (cut_.has_cuts()) {
      add_fan_faces();
      add_fillings();
    }
    set_stretches();
    return std::move(plan_);
  }

 private:
  static IdVector<VertexId, Vec3> directions_of(const IdVector<VertexId, surface::PointNormal>& normal) {
    IdVector<VertexId, Vec3> directions;
    directions.reserve(normal.size());
    for (const auto& n : normal) directions.push_back(n.direction);
    return directions;
  }

  LineId add_line(VertexId v, const Vec3& direction) {
    plan_.front.line_vertex.push_back(v);
    return plan_.direction.push_back(direction);
  }

  LineId line_of(VertexId copy) const {
    const VertexId v = cut_.original(copy);
    return LineId(plan_.front.first_line[v.index()] + (copy.index() - cut_.first_copy(v).index()));
  }

  /// The lines of the groups of v, then those of its fans between them, then the centre line of its corner.
  void add_lines(VertexId v) {
    plan_.front.first_line.push_back(static_cast<std::uint32_t>(plan_.direction.size()));
    const std::size_t n_copies = cut_.n_copies(v);
    for (std::size_t k = 0; k < n_copies; ++k) {
      add_line(v, group_direction_[VertexId(cut_.first_copy(v).index() + k)]);
    }
    if (n_copies < 2) return;
    std::vector<HalfedgeId> cuts;
    for (const HalfedgeId h : wall_.topology.fan(v)) {
      if (cut_.is_cut(h)) cuts.push_back(h);
    }
    if (fan_line_.empty()) fan_line_.resize(3 * wall_.surface.faces.size());
    for (const HalfedgeId h : cuts) {
      const HalfedgeId other = fans_.onwards(h);
      if (other.is_valid() && other < h) continue;
      const Fan& fan = *fans_.at(h);
      fan_line_[h] = LineId(plan_.direction.size());
      for (std::size_t i = 1; i + 1 < fan.direction.size(); ++i) add_line(v, fan.direction[i]);
    }
    // On a plane the lines end at its first and its last line, with nothing between them.
    if (cuts.size() > 2 && !wall_.topology.is_boundary(v)) fill(v, cuts);
  }

  /// Line i of the fan at the beginning of h, counted from the left of h; the one line of the vertex without a fan.
  LineId fan_line(HalfedgeId h, std::size_t i) const {
    const Fan* fan = fans_.at(h);
    const std::size_t n = fan ? fan->direction.size() : 1;
    if (i == 0) return line_of(cut_.copy_at(h));
    if (i + 1 >= n) return line_of(cut_.copy_at(Topology::next(wall_.topology.twin(h))));
    if (fan_line_[h].is_valid()) return LineId(fan_line_[h].index() + i - 1);
    // The set of lines belongs to the other cut, on which left and right are exchanged.
    const HalfedgeId other = fans_.onwards(h);
    expect(other.is_valid(), "a fan without lines of its own to run through");
    return LineId(fan_line_[other].index() + (n - 1 - i) - 1);
  }

  /// The loop of lines round a corner, counterclockwise, and how it is filled.
  void fill(VertexId v, const std::vector<HalfedgeId>& cuts) {
    Corner corner;
    std::vector<Vec3> directions;
    for (const HalfedgeId h : cuts) {
      for (std::size_t i = fans_.at(h)->direction.size() - 1; i > 0; --i) {
        corner.loop.push_back(fan_line(h, i));
        directions.push_back(plan_.direction[corner.loop.back()]);
      }
    }
    const CornerFilling filling = fill_corner(directions);
    if (!filling.exists()) plan_.cannot_leave[v] = 1;
    if (filling.has_centre) corner.loop.push_back(add_line(v, filling.centre));
    corner.triangles = filling.triangles;
    fillings_.push_back(std::move(corner));
  }

  void add_wall_faces() {
    plan_.front.faces.reserve(wall_.surface.faces.size());
    for (const auto& face : cut_.surface().faces) {
      plan_.front.faces.push_back({{line_of(face[0]), line_of(face[1]), line_of(face[2]), LineId()}});
    }
    plan_.front.n_wall_faces = plan_.front.faces.size();
  }

  /// One virtual face for each two neighbouring lines over a cut edge: a quad, or a triangle where the fan ends at a
  /// vertex with one line, which therefore starts late.
  void add_fan_faces() {
    for (const HalfedgeId h : wall_.features.is_ridge.ids()) {
      const HalfedgeId twin = wall_.topology.twin(h);
      if (!cut_.is_cut(h) || twin < h) continue;
      const Fan *here = fans_.at(h), *there = fans_.at(twin);
      if (!here && !there) continue;
      if (!here) plan_.start[wall_.topology.origin(h)] = 1;
      if (!there) plan_.start[wall_.topology.target(h)] = 1;
      const std::size_t n = (here ? here : there)->direction.size();
      for (std::size_t i = 0; i + 1 < n; ++i) {
        std::vector<LineId> face;
        face.push_back(fan_line(h, here ? i : 0));
        if (here) face.push_back(fan_line(h, i + 1));
        if (there) face.push_back(fan_line(twin, n - 2 - i));
        face.push_back(fan_line(twin, there ? n - 1 - i : 0));
        plan_.front.faces.push_back({{face[0], face[1], face[2], face.size() == 4 ? face[3] : LineId()}});
      }
    }
  }

  void add_fillings() {
    for (const Corner& corner : fillings_) {
      for (const auto& [a, b, c] : corner.triangles) {
        plan_.front.faces.push_back({{corner.loop[a], corner.loop[b], corner.loop[c], LineId()}});
      }
    }
  }

  /// Only the lines of groups march from faces; those between them are as long as the layers are thick.
  void set_stretches() {
    plan_.stretch.resize(plan_.direction.size(), 1.0);
    const Wall cut_wall = cut_.wall();
    parallel_for(group_direction_.size(), [&](std::size_t i) {
      const LineId line = line_of(VertexId(i));
      plan_.stretch[line] = stretch_of(cut_wall, VertexId(i), plan_.direction[line]);
    });
  }

  const Wall& wall_;
  const CutWall& cut_;
  IdVector<VertexId, Vec3> group_direction_;
  Fans fans_;
  LinePlan plan_;
  IdVector<HalfedgeId, LineId> fan_line_;  // first line between the groups of the fan, (3 n_faces) or empty
  std::vector<Corner> fillings_;
};

}  // namespace

Vec3 LinePlan::offset(LineId line, double thickness) const {
  if (!is_bent(line)) return direction[line] * (stretch[line] * thickness);
  Knot below;
  for (const Knot& knot : bends[line]) {
    if (knot.at >= thickness) {
      return below.offset + (knot.offset - below.offset) * ((thickness - below.at) / (knot.at - below.at));
    }
    below = knot;
  }
  return below.offset * (thickness / below.at);
}

LinePlan plan_lines(const Wall& wall, const CutWall& cut, const IdVector<VertexId, surface::PointNormal>& normal,
                    double max_turn) {
  return Planner(wall, cut, normal, max_turn).plan();
}

}  // namespace nearwall::layers

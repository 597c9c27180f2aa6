#include "shrink.h"

#include <algorithm>

#include "crossing.h"
#include "nearwall/geometry/box.h"
#include "swept_limit.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;

/// How much of a line survives a failed cell: what lies below that cell, within these bounds.
constexpr double kLeastKept = 0.5;
constexpr double kMostKept = 0.85;

/// What survives an intersection of the front, where no height is known to be good.
constexpr double kKeptAtIntersection = 0.75;

/// A line this much shorter than the highest of its face is not what stands in the way.
constexpr double kTall = 0.5;

/// Times that a vertex is lowered without those beside it, at most: single corners are good guesses, no more.
constexpr int kMostAlone = 6;

}  // namespace

void Shrinker::mark(VertexId v, double factor) {
  if (!(field_.thickness[v] > 0)) return;
  if (factor_[v.index()] == 1.0) marked_.push_back(v);
  factor_[v.index()] = std::min(factor_[v.index()], factor);
}

void Shrinker::mark(FrontFaceId f, double factor) {
  const auto vertex = [&](int k) { return front_.line_vertex[front_.faces[f].lines[static_cast<std::size_t>(k)]]; };
  const int n = front_.faces[f].size();
  double tallest = 0;
  for (int k = 0; k < n; ++k) tallest = std::max(tallest, field_.thickness[vertex(k)]);
  for (int k = 0; k < n; ++k) {
    if (field_.thickness[vertex(k)] >= kTall * tallest) mark(vertex(k), factor);
  }
}

void Shrinker::mark(FrontFaceId f, const Corners& to_blame, double factor) {
  if (!front_.is_wall(f)) return mark(f, factor);
  const auto& corners = wall_.surface.faces[FaceId(f.index())];
  const bool is_worn =
      std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return strikes_[v.index()] >= kMostAlone; });
  bool can_lower = false;
  for (std::size_t k = 0; k < 3; ++k) can_lower |= to_blame[k] && field_.thickness[corners[k]] > 0;
  if (is_worn || !can_lower) return mark(f, factor);
  for (std::size_t k = 0; k < 3; ++k) {
    if (to_blame[k]) mark(corners[k], factor);
  }
}

Shrinker::Corners Shrinker::crossing_corners(FrontFaceId f) const {
  if (!front_.is_wall(f)) return {};
  const FaceId wall_face(f.index());
  std::array<Vec3, 3> tops;
  for (std::size_t k = 0; k < 3; ++k) {
    tops[k] = plan_.offset(front_.faces[f].lines[k], field_.reached[wall_.surface.faces[wall_face][k]]);
  }
  const auto triangle = wall_.surface.triangle(wall_face);
  const auto shares = shares_kept(triangle, tops, swept_limit(triangle, tops));
  Corners crossing{};
  for (std::size_t k = 0; k < 3; ++k) crossing[k] = shares[k] < 1;
  return crossing;
}

Shrinker::Corners Shrinker::bearing_corners_of(const certify::FrontSurface& front, FrontFaceId f,
                                               FrontFaceId other) const {
  if (!front_.is_wall(f) || !front_.is_wall(other)) return {};
  const auto triangle = [&](FrontFaceId face) {
    const auto& t = front.triangles[face.index()];
    return std::array<Vec3, 3>{front.points[t[0]], front.points[t[1]], front.points[t[2]]};
  };
  return bearing_corners(triangle(f), triangle(other));
}

std::vector<VertexId> Shrinker::lower_marked(LimitReason why) {
  std::sort(marked_.begin(), marked_.end());
  for (const VertexId v : marked_) {
    const bool is_blocked = ++strikes_[v.index()] > patience_;
    field_.lower(v, is_blocked ? 0.0 : factor_[v.index()] * field_.reached[v], why);
    factor_[v.index()] = 1.0;
  }
  return std::exchange(marked_, {});
}

std::vector<VertexId> Shrinker::shrink(const mesh::Lines& lines, const std::vector<certify::BadColumn>& bad) {
  for (const certify::BadColumn& column : bad) {
    double kept = 0;
    for (const LineId line : front_.faces[column.face].lines) {
      if (!line.is_valid() || !lines.windows[line].moves()) continue;
      kept = std::max(kept, lines.height(line, column.level) / lines.height(line, lines.windows[line].end));
    }
    mark(column.face, crossing_corners(column.face), std::clamp(kept, kLeastKept, kMostKept));
  }
  return lower_marked(LimitReason::Quality);
}

std::vector<VertexId> Shrinker::shrink(const certify::FrontSurface& front,
                                       const std::vector<std::pair<FrontFaceId, FrontFaceId>>& intersections) {
  for (const auto& [a, b] : intersections) {
    mark(a, bearing_corners_of(front, a, b), kKeptAtIntersection);
    mark(b, bearing_corners_of(front, b, a), kKeptAtIntersection);
  }
  return lower_marked(LimitReason::Intersection);
}

std::vector<VertexId> Shrinker::shrink_all() {
  for (const VertexId v : field_.thickness.ids()) mark(v, kLeastKept);
  return lower_marked(LimitReason::Intersection);
}

bool Shrinker::can_be_lowered(FrontFaceId f) const {
  const auto& lines = front_.faces[f].lines;
  return std::any_of(lines.begin(), lines.begin() + front_.faces[f].size(),
                     [&](LineId line) { return field_.thickness[front_.line_vertex[line]] > 0; });
}

ComponentId Shrinker::component_under(FrontFaceId f, const IdVector<FaceId, ComponentId>& face_component) const {
  const VertexId v = front_.line_vertex[front_.faces[f].lines[0]];
  return face_component[mesh::Topology::face(wall_.topology.fan(v).front())];
}

geometry::Box Shrinker::column_box(FrontFaceId f, const certify::FrontSurface& front) const {
  geometry::Box box;
  for (int k = 0; k < front_.faces[f].size(); ++k) {
    const LineId line = front_.faces[f].lines[static_cast<std::size_t>(k)];
    box.include(wall_.surface.points[front_.line_vertex[line]]);
    box.include(front.points[line.index()]);
  }
  return box;
}

std::vector<VertexId> Shrinker::shrink(const certify::FrontSurface& front,
                                       const std::vector<ComponentId>& covered_twice,
                                       const IdVector<FaceId, ComponentId>& face_component) {
  for (const ComponentId wrong : covered_twice) {
    geometry::Box body;
    for (const FaceId f : face_component.ids()) {
      if (face_component[f] != wrong) continue;
      for (const Vec3& p : wall_.surface.triangle(f)) body.include(p);
    }
    // Only columns that reach the body can have covered its neighbourhood, fans among them.
    bool is_named = false;
    for (const FrontFaceId f : front_.faces.ids()) {
      if (component_under(f, face_component) == wrong) continue;
      if (!column_box(f, front).intersects(body)) continue;
      mark(f, kLeastKept);
      is_named |= can_be_lowered(f);
    }
    if (is_named) continue;
    // Where not even that names a line, all of the others give way.
    for (const FrontFaceId f : front_.faces.ids()) {
      if (component_under(f, face_component) != wrong) mark(f, kLeastKept);
    }
  }
  return lower_marked(LimitReason::Gap);
}

}  // namespace nearwall::layers

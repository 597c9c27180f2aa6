#include "shrink.h"

#include <algorithm>

#include "nearwall/geometry/box.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;

/// How much of a line survives a failed cell: what lies below that cell, within these bounds.
constexpr double kLeastKept = 0.5;
constexpr double kMostKept = 0.85;

/// What survives an intersection of the front, where no height is known to be good.
constexpr double kKeptAtIntersection = 0.75;

}  // namespace

void Shrinker::mark(FrontFaceId f, double factor) {
  const mesh::FrontFace& face = front_.faces[f];
  for (int k = 0; k < face.size(); ++k) {
    const VertexId v = front_.line_vertex[face.lines[static_cast<std::size_t>(k)]];
    if (!(field_.thickness[v] > 0)) continue;
    if (factor_[v.index()] == 1.0) marked_.push_back(v);
    factor_[v.index()] = std::min(factor_[v.index()], factor);
  }
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
    mark(column.face, std::clamp(kept, kLeastKept, kMostKept));
  }
  return lower_marked(LimitReason::Quality);
}

std::vector<VertexId> Shrinker::shrink(const std::vector<std::pair<FrontFaceId, FrontFaceId>>& intersections) {
  for (const auto& [a, b] : intersections) {
    mark(a, kKeptAtIntersection);
    mark(b, kKeptAtIntersection);
  }
  return lower_marked(LimitReason::Intersection);
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
    // Only columns that reach the body can have covered its neighbourhood.
    for (const FrontFaceId f : front_.faces.ids()) {
      if (!front_.is_wall(f) || face_component[FaceId(f.index())] == wrong) continue;
      geometry::Box column;
      for (const Vec3& p : wall_.surface.triangle(FaceId(f.index()))) column.include(p);
      for (const std::uint32_t p : front.triangles[f.index()]) column.include(front.points[p]);
      if (column.intersects(body)) mark(f, kLeastKept);
    }
  }
  return lower_marked(LimitReason::Gap);
}

}  // namespace nearwall::layers

#include <algorithm>

#include "nearwall/core/parallel.h"
#include "nearwall/search/wall_tree.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;
using mesh::Topology;

/// Share of the way to the opposite wall: two fronts that grow towards each other keep a tenth of the gap between them.
constexpr double kGapShare = 0.45;

/// Keeps the thickness at v below its share of the way from v along `direction` to the next wall that faces v.
/// \param per_thickness  length along the direction for each thickness
void limit_along(const Wall& wall, const search::WallTree& tree, VertexId v, const Vec3& direction,
                 double per_thickness, VertexField& field) {
  const Vec3& from = wall.surface.points[v];
  const double reach = per_thickness * field.thickness[v] / kGapShare;
  const auto is_apart = [&](FaceId f) {
    const auto& corners = wall.surface.faces[f];
    return std::find(corners.begin(), corners.end(), v) == corners.end();
  };
  const auto faces_v = [&](FaceId f) { return dot(wall.features.face_normal[f], direction) < 0; };
  const auto nearest = tree.first_hit(from, from + direction * reach, is_apart);
  if (!nearest.face.is_valid()) return;
  if (!faces_v(nearest.face)) {
    // A wall met from behind or edge on is the far side of the corner that v stands in, unless the ray meets an edge or
    // a corner there, of which another face looks this way.
    const auto facing =
        tree.first_hit(from, from + direction * reach, [&](FaceId f) { return is_apart(f) && faces_v(f); });
    if (!facing.face.is_valid() || facing.distance > nearest.distance) return;
  }
  field.lower(v, kGapShare * nearest.distance / per_thickness, LimitReason::Gap);
}

}  // namespace

void limit_by_gaps(const Wall& wall, const LinePlan& plan, VertexField& field) {
  const search::WallTree tree(wall.surface);
  parallel_for(field.thickness.size(), [&](std::size_t i) {
    const VertexId v(i);
    if (!(field.thickness[v] > 0)) return;
    for (const LineId line : plan.front.lines_of(v)) {
      limit_along(wall, tree, v, plan.direction[line], plan.stretch[line], field);
    }
    if (wall.features.kind[v] == surface::PointKind::Smooth) return;
    // At a ridge or corner the line leaves between its faces and may pass by what each of them looks at.
    for (const HalfedgeId h : wall.topology.fan(v)) {
      limit_along(wall, tree, v, wall.features.face_normal[Topology::face(h)], 1.0, field);
    }
  });
}

}  // namespace nearwall::layers

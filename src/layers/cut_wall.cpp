#include "cut_wall.h"

#include <algorithm>
#include <cmath>

namespace nearwall::layers {

namespace {

using mesh::Topology;
using surface::PointKind;

std::size_t n_layers(const Wall& wall, const GrowOptions& options, FaceId f) {
  const PatchSchedule& schedule = options.schedules[wall.surface.face_patch[f]];
  return wall.is_wetted[f] && schedule.has_layers ? schedule.heights.size() : 0;
}

void uncut(const Wall& wall, HalfedgeId h, IdVector<HalfedgeId, char>& is_cut) {
  is_cut[h] = is_cut[wall.topology.twin(h)] = 0;
}

IdVector<VertexId, VertexId> find_originals(const surface::CornerGroups& groups) {
  IdVector<VertexId, VertexId> original(groups.offset.raw().back());
  for (std::size_t v = 0; v + 1 < groups.offset.size(); ++v) {
    for (std::uint32_t g = groups.offset[VertexId(v)]; g < groups.offset[VertexId(v + 1)]; ++g) {
      original[VertexId(g)] = VertexId(v);
    }
  }
  return original;
}

mesh::SurfaceMesh with_copies(const mesh::SurfaceMesh& wall, const surface::CornerGroups& groups,
                              const IdVector<VertexId, VertexId>& original) {
  mesh::SurfaceMesh cut;
  cut.patch_names = wall.patch_names;
  cut.face_patch = wall.face_patch;
  cut.points.reserve(original.size());
  for (const VertexId v : original) cut.points.push_back(wall.points[v]);
  cut.faces.resize(wall.faces.size());
  for (const FaceId f : cut.faces.ids()) {
    for (int k = 0; k < 3; ++k) {
      cut.faces[f][static_cast<std::size_t>(k)] = VertexId(groups.of_corner[Topology::halfedge(f, k)]);
    }
  }
  return cut;
}

}  // namespace

void shorten_cuts(const Wall& wall, const GrowOptions& options, IdVector<HalfedgeId, char>& is_cut) {
  const auto only_cut = [&](VertexId v) {
    HalfedgeId only;
    for (const HalfedgeId h : wall.topology.fan(v)) {
      if (!is_cut[h]) continue;
      if (only.is_valid()) return HalfedgeId();
      only = h;
    }
    return only;
  };
  const auto has_one_layer = [&](VertexId v) {
    const auto fan = wall.topology.fan(v);
    return std::any_of(fan.begin(), fan.end(),
                       [&](HalfedgeId h) { return n_layers(wall, options, Topology::face(h)) == 1; });
  };
  for (const VertexId end : wall.surface.points.ids()) {
    VertexId v = end;
    // At the edge of an open wall a ridge does not end: its fan lies in the plane there.
    for (HalfedgeId h = only_cut(v); h.is_valid() && !wall.topology.is_boundary(v); h = only_cut(v)) {
      const VertexId next = wall.topology.target(h);
      const bool is_whole_cut = only_cut(next) == wall.topology.twin(h) && !wall.topology.is_boundary(next);
      if (!has_one_layer(v) && !is_whole_cut) break;
      uncut(wall, h, is_cut);
      v = next;
    }
  }
}

IdVector<HalfedgeId, char> find_cuts(const Wall& wall, const GrowOptions& options) {
  IdVector<HalfedgeId, char> is_cut(wall.features.is_ridge.size(), 0);
  if (!options.several_lines) return is_cut;
  is_cut = surface::ridges_with_several_lines(wall.surface, wall.topology, wall.features,
                                              {.multi_angle = options.multi_angle, .steep_angle = options.steep_angle});
  const auto has_layers = [&](HalfedgeId h) { return n_layers(wall, options, Topology::face(h)) > 1; };
  for (const HalfedgeId h : is_cut.ids()) {
    if (is_cut[h] && !(has_layers(h) && has_layers(wall.topology.twin(h)))) uncut(wall, h, is_cut);
  }
  shorten_cuts(wall, options, is_cut);
  return is_cut;
}

std::size_t forecast_fan_faces(const Wall& wall, const GrowOptions& options) {
  const auto is_cut = find_cuts(wall, options);
  double faces = 0;
  for (const VertexId v : wall.surface.points.ids()) {
    double parts = 0;
    int n_cuts = 0;
    for (const HalfedgeId h : wall.topology.fan(v)) {
      if (!is_cut[h]) continue;
      ++n_cuts;
      // One more than the edge itself asks for: its ridge may turn more elsewhere.
      parts += std::ceil(wall.features.turn[h] / options.max_turn) + 1;
    }
    // Quads over edges, each seen from both ends, and the filling of corners.
    faces += 0.5 * parts + (n_cuts > 2 ? parts : 0.0);
  }
  return static_cast<std::size_t>(faces);
}

CutWall::Cut::Cut(const Wall& wall, const IdVector<HalfedgeId, char>& is_cut, surface::CornerGroups corner_groups)
    : groups(std::move(corner_groups)),
      original(find_originals(groups)),
      surface(with_copies(wall.surface, groups, original)),
      topology(surface),
      features(wall.features) {
  for (const HalfedgeId h : is_cut.ids()) {
    if (is_cut[h]) features.is_ridge[h] = 0, features.turn[h] = 0;
  }
  features.kind.resize(original.size());
  for (const VertexId copy : original.ids()) {
    const VertexId v = original[copy];
    features.kind[copy] = wall.features.kind[v];
    if (groups.offset[VertexId(v.index() + std::size_t{1})] - groups.offset[v] < 2) continue;
    const auto fan = topology.fan(copy);
    const bool has_ridge = std::any_of(fan.begin(), fan.end(), [&](HalfedgeId h) { return features.is_ridge[h] != 0; });
    features.kind[copy] = has_ridge ? PointKind::Corner : PointKind::Smooth;
  }
  if (!wall.has_planes()) return;
  planes.planes = wall.planes->planes;
  for (const VertexId v : original) planes.of_vertex.push_back(wall.planes->of_vertex[v]);
}

CutWall::CutWall(const Wall& wall, IdVector<HalfedgeId, char> is_cut) : wall_(wall), is_cut_(std::move(is_cut)) {
  if (std::find(is_cut_.begin(), is_cut_.end(), 1) == is_cut_.end()) return;
  surface::CornerGroups groups = surface::corner_groups(wall.topology, is_cut_);
  // Cuts that divide no vertex make no fan.
  if (groups.offset.raw().back() > wall.surface.points.size()) cut_.emplace(wall, is_cut_, std::move(groups));
}

std::size_t CutWall::n_copies(VertexId v) const {
  return cut_ ? cut_->groups.offset[VertexId(v.index() + std::size_t{1})] - cut_->groups.offset[v] : 1;
}

IdVector<VertexId, char> CutWall::held_copies() const {
  IdVector<VertexId, char> held(surface().points.size(), 0);
  for (const HalfedgeId h : is_cut_.ids()) {
    if (!cut_ || !is_cut_[h]) continue;
    const VertexId v = wall_.topology.origin(h);
    for (std::size_t k = 0; k < n_copies(v); ++k) held[VertexId(first_copy(v).index() + k)] = 1;
  }
  if (!wall_.has_planes()) return held;
  for (const VertexId copy : held.ids()) {
    if (wall_.planes->is_on_plane(original(copy))) held[copy] = 1;
  }
  return held;
}

}  // namespace nearwall::layers

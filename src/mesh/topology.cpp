#include "nearwall/mesh/topology.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"

namespace nearwall::mesh {

namespace {

/// Halfedges grouped by their origin and sorted by their target: group v is sorted[offset[v]] … sorted[offset[v + 1] −
/// 1].
struct ByOrigin {
  std::vector<std::uint32_t> offset;
  std::vector<HalfedgeId> sorted;

  std::span<const HalfedgeId> group(VertexId v) const {
    return {sorted.data() + offset[v.index()], sorted.data() + offset[v.index() + 1]};
  }
};

VertexId target_of(const std::vector<VertexId>& origin, HalfedgeId h) { return origin[Topology::next(h).index()]; }

ByOrigin group_by_origin(const std::vector<VertexId>& origin, std::size_t n_vertices) {
  ByOrigin groups;
  groups.offset.assign(n_vertices + 1, 0);
  for (const VertexId v : origin) ++groups.offset[v.index() + 1];
  std::partial_sum(groups.offset.begin(), groups.offset.end(), groups.offset.begin());
  groups.sorted.resize(origin.size());
  std::vector<std::uint32_t> next(groups.offset.begin(), groups.offset.end() - 1);
  for (std::size_t h = 0; h < origin.size(); ++h) groups.sorted[next[origin[h].index()]++] = HalfedgeId(h);
  for (std::size_t v = 0; v < n_vertices; ++v) {
    std::sort(groups.sorted.begin() + groups.offset[v], groups.sorted.begin() + groups.offset[v + 1],
              [&](HalfedgeId a, HalfedgeId b) {
                return std::pair(target_of(origin, a), a) < std::pair(target_of(origin, b), b);
              });
  }
  return groups;
}

/// The halfedges of the group that end at `to`.
std::span<const HalfedgeId> halfedges_to(const std::vector<VertexId>& origin, std::span<const HalfedgeId> group,
                                         VertexId to) {
  const auto begin =
      std::partition_point(group.begin(), group.end(), [&](HalfedgeId h) { return target_of(origin, h) < to; });
  auto end = begin;
  while (end != group.end() && target_of(origin, *end) == to) ++end;
  return {begin, end};
}

[[noreturn]] void reject_edge(VertexId a, VertexId b, FaceId f) {
  throw GeometryError(fmt::format(
      "edge between vertices {} and {} (triangle {}) is not that of an oriented manifold: it has more than two "
      "triangles, or two that run along it in the same direction",
      a.index(), b.index(), f.index()));
}

}  // namespace

Topology::Topology(const SurfaceMesh& mesh) {
  const std::size_t n_vertices = mesh.points.size();
  if (3 * mesh.faces.size() >= HalfedgeId().index() || n_vertices >= VertexId().index()) {
    throw GeometryError(fmt::format("{} triangles are more than can be numbered: at most {}", mesh.faces.size(),
                                    HalfedgeId().index() / 3 - 1));
  }
  origin_.reserve(3 * mesh.faces.size());
  for (const auto& face : mesh.faces) origin_.insert(origin_.end(), face.begin(), face.end());
  const ByOrigin groups = group_by_origin(origin_, n_vertices);

  twin_.assign(origin_.size(), HalfedgeId());
  for (std::size_t i = 0; i < origin_.size(); ++i) {
    const HalfedgeId h(i);
    const VertexId from = origin(h), to = target(h);
    const auto back = halfedges_to(origin_, groups.group(to), from);
    if (back.size() > 1 || halfedges_to(origin_, groups.group(from), to).size() > 1) reject_edge(from, to, face(h));
    if (back.empty()) {
      is_closed_ = false;
    } else {
      twin_[i] = back.front();
    }
  }

  fan_offset_ = groups.offset;
  fan_.reserve(origin_.size());
  for (std::size_t v = 0; v < n_vertices; ++v) {
    const std::size_t size = groups.offset[v + 1] - groups.offset[v];
    if (size == 0) continue;
    // Clockwise from any halfedge until the boundary, if there is one; then counterclockwise round.
    HalfedgeId first = groups.sorted[groups.offset[v]];
    const HalfedgeId start = first;
    while (twin(first).is_valid()) {
      first = next(twin(first));
      if (first == start) break;
    }
    HalfedgeId h = first;
    for (std::size_t k = 0; k < size; ++k) {
      fan_.push_back(h);
      h = twin(previous(h));
      if (k + 1 < size && (!h.is_valid() || h == first)) {
        throw GeometryError(fmt::format("vertex {} is not manifold: the triangles round it form more than one fan", v));
      }
    }
  }
}

bool Topology::is_boundary(VertexId v) const {
  const auto halfedges = fan(v);
  return !halfedges.empty() && !twin(halfedges.front()).is_valid();
}

IdVector<FaceId, ComponentId> connected_components(const Topology& topology) {
  IdVector<FaceId, ComponentId> component(topology.n_faces());
  std::vector<FaceId> stack;
  std::size_t n_components = 0;
  for (const FaceId seed : component.ids()) {
    if (component[seed].is_valid()) continue;
    const ComponentId id(n_components++);
    component[seed] = id;
    stack.push_back(seed);
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId twin = topology.twin(Topology::halfedge(f, k));
        if (!twin.is_valid() || component[Topology::face(twin)].is_valid()) continue;
        component[Topology::face(twin)] = id;
        stack.push_back(Topology::face(twin));
      }
    }
  }
  return component;
}

}  // namespace nearwall::mesh

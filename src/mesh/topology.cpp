#include "nearwall/mesh/topology.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"

namespace nearwall::mesh {

namespace {

/// Halfedges grouped by their origin: group v is sorted[offset[v]] … sorted[offset[v + 1] − 1], in increasing order.
struct ByOrigin {
  std::vector<std::uint32_t> offset;
  std::vector<HalfedgeId> sorted;
};

ByOrigin group_by_origin(const std::vector<VertexId>& origin, std::size_t n_vertices) {
  ByOrigin groups;
  groups.offset.assign(n_vertices + 1, 0);
  for (const VertexId v : origin) ++groups.offset[v.index() + 1];
  std::partial_sum(groups.offset.begin(), groups.offset.end(), groups.offset.begin());
  groups.sorted.resize(origin.size());
  std::vector<std::uint32_t> next(groups.offset.begin(), groups.offset.end() - 1);
  for (std::size_t h = 0; h < origin.size(); ++h) groups.sorted[next[origin[h].index()]++] = HalfedgeId(h);
  return groups;
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
  origin_.reserve(3 * mesh.faces.size());
  for (const auto& face : mesh.faces) origin_.insert(origin_.end(), face.begin(), face.end());
  const ByOrigin groups = group_by_origin(origin_, n_vertices);

  twin_.assign(origin_.size(), HalfedgeId());
  for (std::size_t i = 0; i < origin_.size(); ++i) {
    const HalfedgeId h(i);
    const VertexId from = origin(h), to = target(h);
    for (std::uint32_t k = groups.offset[to.index()]; k < groups.offset[to.index() + 1]; ++k) {
      const HalfedgeId candidate = groups.sorted[k];
      if (target(candidate) != from) continue;
      if (twin_[i].is_valid()) reject_edge(from, to, face(h));
      twin_[i] = candidate;
    }
    for (std::uint32_t k = groups.offset[from.index()]; k < groups.offset[from.index() + 1]; ++k) {
      if (groups.sorted[k] != h && target(groups.sorted[k]) == to) reject_edge(from, to, face(h));
    }
    if (!twin_[i].is_valid()) is_closed_ = false;
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

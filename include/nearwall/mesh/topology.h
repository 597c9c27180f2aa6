#pragma once

#include <span>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::mesh {

/// Adjacency of a manifold, consistently oriented surface, closed or with boundary.
///
/// Halfedge 3 f + k runs from corner k of face f to corner k + 1 and has f on its left. Cost: O(n_faces) time and
/// memory.
class Topology {
 public:
  /// \throws GeometryError if an edge has more than two faces or two faces that run along it in the same direction, or
  ///         if the faces round a vertex form more than one fan.
  explicit Topology(const SurfaceMesh& mesh);

  std::size_t n_vertices() const { return fan_offset_.size() - 1; }
  std::size_t n_faces() const { return twin_.size() / 3; }

  static HalfedgeId halfedge(FaceId f, int k) {
    return HalfedgeId(3 * std::size_t{f.index()} + static_cast<std::size_t>(k));
  }
  static FaceId face(HalfedgeId h) { return FaceId(h.index() / 3); }
  static int corner(HalfedgeId h) { return static_cast<int>(h.index() % 3); }
  static HalfedgeId next(HalfedgeId h) {
    return h.index() % 3 == 2 ? HalfedgeId(h.index() - 2) : HalfedgeId(h.index() + 1);
  }
  static HalfedgeId previous(HalfedgeId h) {
    return h.index() % 3 == 0 ? HalfedgeId(h.index() + 2) : HalfedgeId(h.index() - 1);
  }

  VertexId origin(HalfedgeId h) const { return origin_[h.index()]; }
  VertexId target(HalfedgeId h) const { return origin_[next(h).index()]; }
  /// The same edge seen from the face on the other side; invalid on a boundary.
  HalfedgeId twin(HalfedgeId h) const { return twin_[h.index()]; }

  /// Halfedges that leave v, counterclockwise seen from outside; their faces are the faces round v in that order. On a
  /// boundary vertex the first one is the boundary halfedge that leaves v.
  std::span<const HalfedgeId> fan(VertexId v) const {
    return {fan_.data() + fan_offset_[v.index()], fan_.data() + fan_offset_[v.index() + 1]};
  }
  /// Calls `body(w, f)` for each vertex w that an edge joins to v, counterclockwise, with a face f of that edge.
  template <class Body>
  void for_each_spoke(VertexId v, const Body& body) const {
    for (const HalfedgeId h : fan(v)) body(target(h), face(h));
    // The last edge of an open fan has a halfedge towards v only.
    if (!fan(v).empty() && is_boundary(v)) body(origin(previous(fan(v).back())), face(fan(v).back()));
  }
  /// Calls `body(w)` for each vertex w that an edge joins to v, counterclockwise.
  template <class Body>
  void for_each_neighbour(VertexId v, const Body& body) const {
    for_each_spoke(v, [&](VertexId w, FaceId) { body(w); });
  }
  bool is_boundary(VertexId v) const;
  bool is_closed() const { return is_closed_; }

 private:
  std::vector<VertexId> origin_;           // (3 n_faces)
  std::vector<HalfedgeId> twin_;           // (3 n_faces)
  std::vector<std::uint32_t> fan_offset_;  // (n_vertices + 1)
  std::vector<HalfedgeId> fan_;            // (3 n_faces)
  bool is_closed_ = true;
};

/// Component of each face: faces that share an edge have the same one. Components are numbered in the order of their
/// first face.
IdVector<FaceId, ComponentId> connected_components(const Topology& topology);

}  // namespace nearwall::mesh

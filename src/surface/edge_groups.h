#pragma once

#include <array>
#include <span>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::surface {

/// The halfedges of a triangle soup, grouped by the edge (pair of vertices) they run along. Works for any soup: an edge
/// may have one halfedge, two, or many, in any direction. Halfedge 3 f + k runs from corner k of face f to corner k
/// + 1.
class EdgeGroups {
 public:
  /// \param is_left_out  (n_faces) faces that do not count    Cost: O(n log n)
  EdgeGroups(const mesh::SurfaceMesh& surface, std::span<const char> is_left_out);

  std::size_t size() const { return offset_.size() - 1; }
  /// Halfedges of edge e in increasing order. Edges are ordered by their smaller, then by their larger vertex.
  std::span<const HalfedgeId> operator[](std::size_t e) const {
    return {halfedges_.data() + offset_[e], halfedges_.data() + offset_[e + 1]};
  }

 private:
  std::vector<HalfedgeId> halfedges_;
  std::vector<std::size_t> offset_;
};

inline bool has_repeated_corner(const std::array<VertexId, 3>& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

inline FaceId face_of(HalfedgeId h) { return FaceId(h.index() / 3); }
inline VertexId origin_of(const mesh::SurfaceMesh& surface, HalfedgeId h) {
  return surface.faces[face_of(h)][h.index() % 3];
}
inline VertexId target_of(const mesh::SurfaceMesh& surface, HalfedgeId h) {
  return surface.faces[face_of(h)][(h.index() + 1) % 3];
}

}  // namespace nearwall::surface

#pragma once

#include <optional>

#include "nearwall/layers/grow.h"
#include "nearwall/surface/patch_normals.h"

namespace nearwall::layers {

/// Edges of ridges that get several lines, with two layers or more on both sides: (3 n_faces), the same for both
/// halfedges. No edge is one whose ends both have one group, or ends where there is one layer only.
IdVector<HalfedgeId, char> find_cuts(const Wall& wall, const GrowOptions& options);

/// Takes cuts back where they end: an edge that is a whole cut divides no vertex, and the line at the end of a fan
/// skips a level, so where there is a single one it would have none.
void shorten_cuts(const Wall& wall, const GrowOptions& options, IdVector<HalfedgeId, char>& is_cut);

/// The wall cut open along the ridges that get several lines: each group of faces round a vertex has a copy of that
/// vertex for itself, and the ridge has become two boundaries. Normals and their smoothing know nothing of fans: they
/// work on this surface. Copy g is group g of `groups`; faces and halfedges keep their numbers. Without such ridges it
/// is the wall itself. The wall must outlive it.
class CutWall {
 public:
  /// \param is_cut  (3 n_faces) the same for both halfedges of an edge
  CutWall(const Wall& wall, IdVector<HalfedgeId, char> is_cut);

  const mesh::SurfaceMesh& surface() const { return cut_ ? cut_->surface : wall_.surface; }
  const mesh::Topology& topology() const { return cut_ ? cut_->topology : wall_.topology; }
  const surface::Features& features() const { return cut_ ? cut_->features : wall_.features; }
  Wall wall() const { return {surface(), topology(), features(), wall_.is_wetted, wall_.fluid_is_inside}; }

  bool is_cut(HalfedgeId h) const { return is_cut_[h] != 0; }
  bool has_cuts() const { return cut_.has_value(); }
  /// Vertex of the wall that a copy stands for.
  VertexId original(VertexId copy) const { return cut_ ? cut_->original[copy] : copy; }
  /// Copies of v: first_copy(v) to first_copy(v) + n_copies(v) - 1.
  VertexId first_copy(VertexId v) const { return cut_ ? VertexId(cut_->groups.offset[v]) : v; }
  std::size_t n_copies(VertexId v) const;
  /// The copy at the corner at which h begins.
  VertexId copy_at(HalfedgeId h) const { return surface().faces[mesh::Topology::face(h)][corner_index(h)]; }
  /// The planes that the copies lie on; edges are left out.
  const mesh::SidePlanes& planes() const { return cut_ && wall_.has_planes() ? cut_->planes : *wall_.planes; }
  /// Copies of vertices at which a cut passes or ends, or that lie on a plane: their normals stay what they are. For
  /// smoothing.
  IdVector<VertexId, char> held_copies() const;

 private:
  struct Cut {
    Cut(const Wall& wall, const IdVector<HalfedgeId, char>& is_cut, surface::CornerGroups corner_groups);

    surface::CornerGroups groups;
    IdVector<VertexId, VertexId> original;
    mesh::SurfaceMesh surface;
    mesh::Topology topology;
    surface::Features features;
    mesh::SidePlanes planes;
  };

  static std::size_t corner_index(HalfedgeId h) { return static_cast<std::size_t>(mesh::Topology::corner(h)); }

  Wall wall_;
  IdVector<HalfedgeId, char> is_cut_;
  std::optional<Cut> cut_;
};

}  // namespace nearwall::layers

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"

namespace nearwall::surface {

/// What divides the faces round a vertex into runs with a normal each.
enum class Separation {
  DiscretePatches,  ///< every ridge (Aubry & Loehner 2008, section 2)
  Groups,           ///< the convex ridges that get several lines; docs/normals.md, section 5
};

struct GroupOptions {
  /// Turn above which a convex ridge gets several lines [rad], (0, pi); default 100 degrees.
  double multi_angle = 1.745329251994329577;
  /// Angle to the worst face round a vertex from which its convex ridges get several lines [rad], (0, pi / 2]; default
  /// 62 degrees.
  double steep_angle = 1.082104136236484271;
};

/// Ridges that get several lines: the same answer all along a ridge, from one corner or ridge end to the next. A convex
/// ridge gets several if its largest turn exceeds `multi_angle` or if it passes or ends at a vertex that no direction
/// sees, or only under more than `steep_angle`: a single line there would lean so far that it hardly left the wall.
/// \returns (3 n_faces) the same for both halfedges of an edge
/// \throws  InputError if the angle is out of range.    Cost: O(n_faces).
IdVector<HalfedgeId, char> ridges_with_several_lines(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                                     const Features& features, const GroupOptions& options = {});

/// Normals of the groups of faces round each vertex.
struct PatchNormals {
  IdVector<VertexId, std::uint32_t> offset;  ///< (n_vertices + 1) groups of v: offset[v] to offset[v + 1] - 1
  std::vector<PointNormal> normal;           ///< (n_groups) held against the faces of the group
  IdVector<HalfedgeId, std::uint32_t> group_of_corner;  ///< (3 n_faces) group of the corner at which a halfedge begins

  /// 0 for a vertex without faces.
  std::size_t n_groups(VertexId v) const { return offset[VertexId(v.index() + 1)] - offset[v]; }
  std::span<const PointNormal> of(VertexId v) const { return {normal.data() + offset[v], n_groups(v)}; }
  /// Normal of the group to which the corner belongs at which h begins.
  const PointNormal& at(HalfedgeId h) const { return normal[group_of_corner[h]]; }
};

/// The runs into which separators divide the faces round each vertex, numbered through. A vertex that one separator
/// meets or none has one run, one without faces, too; on a boundary, which separates as well, each separator begins
/// another.
struct CornerGroups {
  IdVector<VertexId, std::uint32_t> offset;       ///< (n_vertices + 1) groups of v: offset[v] to offset[v + 1] - 1
  IdVector<HalfedgeId, std::uint32_t> of_corner;  ///< (3 n_faces) group of the corner at which a halfedge begins
};

/// \param is_separator  (3 n_faces) the same for both halfedges of an edge
CornerGroups corner_groups(const mesh::Topology& topology, const IdVector<HalfedgeId, char>& is_separator);

/// Where the groups of each vertex begin, if all groups are numbered through: (n_vertices + 1).
/// \throws InputError if the angle is out of range.    Cost: O(n_faces).
IdVector<VertexId, std::uint32_t> group_offsets(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                                const Features& features, Separation separation,
                                                const GroupOptions& groups = {});

/// Whether a method can be asked for the normal of some of the faces round a vertex: the weighted means, MostVisible,
/// Kallinderis, Pirzadeh and Iterative can.
bool is_for_runs(NormalMethod method);

/// One normal for each group of faces round each vertex, where two separators or more divide them; on a boundary, which
/// separates as well, one does. Otherwise there is one group. Groups are numbered as in `discrete_patches`.
/// \param groups  used for Separation::Groups only
/// \throws InputError if an option is out of range or the method is not for runs
/// Cost: O(n_faces) but for vertices with very many faces, mostly on all threads; the same bits at any number of them.
PatchNormals patch_normals(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, const Features& features,
                           Separation separation, const NormalOptions& options = {}, const GroupOptions& groups = {});

}  // namespace nearwall::surface

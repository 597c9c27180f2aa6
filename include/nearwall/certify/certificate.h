#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/core/progress.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/side_planes.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::certify {

/// Columns with a cell, or under a cap, that is not positive everywhere, decided exactly on the coordinates that are
/// written.
struct BadColumn {
  FrontFaceId face;
  Level level = 0;  ///< of the bottom of its first such cell; for the cap, the largest end of its lines
};

/// Point 1 of the certificate. \param columns  which to look at, in increasing order; empty: all
/// Cost: O(cells), on all threads; nothing is stored but the answer.
std::vector<BadColumn> bad_columns(const mesh::Front& front, const mesh::Lines& lines,
                                   std::span<const FrontFaceId> columns = {});

/// The outer front as triangles over the ends of lines and the apices of caps. Lines of one vertex that do not move
/// share a point. Triangle i < n_wall_faces lies over wall triangle i; those over virtual faces follow, one for a
/// triangle, four for a quad with a cap, none where the lines of the face do not part.
///
/// Where the wall ends at planes, the triangles of what is left of them follow (close_front): with them it is the
/// closed boundary of what the layers leave.
struct FrontSurface {
  std::vector<Vec3> points;                             ///< (n_lines + n_caps)
  std::vector<char> is_moved;                           ///< (n_lines + n_caps) 0: at the wall
  IdVector<LineId, std::uint32_t> point_of_line;        ///< (n_lines)
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< (n_triangles + n_rest)
  std::vector<FrontFaceId> face;                        ///< (n_triangles) front face below
  std::vector<mesh::PlaneIndex> rest_plane;             ///< (n_rest)
  bool is_closed = true;                                ///< false: the rest of some plane could not be told
  /// (n_rest) a front face at each corner; invalid at corners on a seam between two planes.
  std::vector<std::array<FrontFaceId, 3>> rest_beside;
};

FrontSurface front_surface(const mesh::Front& front, const mesh::Lines& lines);

/// An edge of the front on a plane, in the direction in which the rest of the plane lies to its left.
struct TraceEdge {
  std::array<std::uint32_t, 2> points{};  ///< of the front
  FrontFaceId face;                       ///< invalid for the edge between two planes
};

/// Edges of the front on each plane: (n_planes) lists, those between two planes left out.
std::vector<std::vector<TraceEdge>> plane_traces(const mesh::Front& front, const mesh::SidePlanes& planes,
                                                 const FrontSurface& surface);

/// Whether a face on a plane, given counterclockwise seen from outside of the domain, is anything but that and convex:
/// exact for the projection along the longest component of the plane's normal.
bool is_turned(std::span<const Vec3> corners, const mesh::SidePlane& plane);

/// Front faces over whose edges on planes a side of the layers is turned. Cost: O(edges on planes × levels).
std::vector<FrontFaceId> turned_sides(const mesh::Front& front, const mesh::Lines& lines,
                                      const mesh::SidePlanes& planes, const FrontSurface& surface);

/// Adds what the front leaves of the planes at which the wall ends, as constrained Delaunay triangulations without new
/// points; where two planes meet, straight from the end of one chain of edges to the next. Normals of these triangles
/// point into the domain, as those of the front. Exact in the plane, for planes along no axis in their projection along
/// the longest component of the normal. Source: docs/theory/planes.md.
/// \returns  front faces whose edges on a plane meet each other or go round nothing; none, too,
///           where only edges between planes are wrong: `is_closed` tells
/// Cost: O(n log n) for n edges on planes.
std::vector<FrontFaceId> close_front(const mesh::Front& front, const mesh::SidePlanes& planes, FrontSurface& surface);

/// Point 4: pairs of front faces whose triangles meet anywhere but in what they share. Exact.
/// Where a face meets the rest of a plane, it is paired with itself, and with faces beside that where it does not move;
/// where two planes meet each other, so are those beside them.
/// \param changed  (n_front_faces) marks faces to be looked at against all; empty: all
std::vector<std::pair<FrontFaceId, FrontFaceId>> front_intersections(const FrontSurface& front,
                                                                     std::span<const char> changed = {});

/// Point 5: components of the front about which the others wind the wrong number of times: there two bodies' layers
/// fill the same space, or one body's layers have swallowed the other body.
/// Parts that the rest of a plane joins count as one, and are named together.
/// \param face_component  (n_wall_faces) component of the wall, invalid where the fluid does not reach
std::vector<ComponentId> covered_twice(const mesh::Front& front, const FrontSurface& surface,
                                       const IdVector<FaceId, ComponentId>& face_component, bool fluid_is_inside);

/// What the certificate speaks about: the wall's triangles with their components.
struct CertifiedWall {
  const mesh::SurfaceMesh& surface;
  IdVector<FaceId, ComponentId> face_component;  ///< (n_faces) invalid where the fluid does not reach
  bool fluid_is_inside = false;
  const mesh::SidePlanes* planes = nullptr;  ///< at which the wall ends, if it does
};

/// The certificate of a layer mesh, point by point (docs/theory/certificate.md). Conformity (2) holds by construction
/// and the embedded wall (3) by admission.
struct Certificate {
  CellIndex n_cells = 0;
  std::uint64_t n_bad_columns = 0;          ///< (1) columns with a cell that is not positive everywhere
  std::uint64_t n_turned_sides = 0;         ///< front faces with a side of their layers on a plane that is turned
  std::uint64_t n_front_intersections = 0;  ///< (4) pairs of front triangles that meet
  std::uint64_t n_covered_twice = 0;        ///< (5) front components whose winding number is wrong; only if (4) holds
  double cells_volume = 0;                  ///< sum of the volumes of all cells
  double enclosed_volume = 0;               ///< between wall and front, from their triangles alone
  double front_volume = 0;                  ///< inside the front (outside it, for an internal flow), absolute
  /// Base times slant over 3 of the cones whose sum is the volume inside front or wall, the larger: their rounding.
  double summed_volume = 0;

  bool is_valid() const {
    return n_bad_columns == 0 && n_turned_sides == 0 && n_front_intersections == 0 && n_covered_twice == 0;
  }
  /// | cells − enclosed | relative to the volume that was summed up, which for a thin gap between two walls is far
  /// larger than the volume inside the front: a check of the program rather than of the mesh.
  double closure() const;
};

Certificate certify_layers(const mesh::LayerMesh& layers, const CertifiedWall& wall,
                           ProgressSink& progress = silent_progress());

}  // namespace nearwall::certify

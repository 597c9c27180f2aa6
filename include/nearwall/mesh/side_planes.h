#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/core/ids.h"
#include "nearwall/core/vec3.h"

namespace nearwall::mesh {

/// A plane on which layers land: a symmetry plane, an inlet or outlet.
struct SidePlane {
  Vec3 normal;        ///< unit vector into the domain
  double offset = 0;  ///< normal · x of its points [length]
  int axis = -1;      ///< 0, 1, 2: its points share that coordinate bit for bit; −1: they lie on it to rounding

  /// The part of a vector that lies in the plane: for an axis plane one coordinate becomes zero, the others stay.
  Vec3 within(const Vec3& d) const;
  /// Distance of a point, positive in the domain.
  double height(const Vec3& p) const;

  /// Coordinates of a point in the plane: its own two, without that along which the normal is longest, in the order in
  /// which a cycle that is counterclockwise seen from the domain stays so.
  std::array<double, 2> flat(const Vec3& p) const;
  /// The point of the plane with these coordinates.
  Vec3 lifted(double u, double v) const;

 private:
  int dropped_axis() const;
};

/// Number of a plane.
using PlaneIndex = std::uint16_t;
inline constexpr PlaneIndex kNoPlane = 0xffff;

/// A point in which planes meet.
struct PlaneCorner {
  Vec3 point;
  /// The edge between two planes, the first with the smaller number, ends here.
  struct Edge {
    std::array<PlaneIndex, 2> planes{};
    /// −1: with the rest of the first plane to its left it leaves the corner; 1: it arrives there; 0: unknown.
    int balance = 0;
  };
  std::vector<Edge> edges;
};

/// The planes at which an open wall ends, and which of its vertices and edges lie on them.
struct SidePlanes {
  std::vector<SidePlane> planes;
  /// (n_vertices) up to three planes of each vertex, in increasing order, then kNoPlane; empty if there is no plane.
  IdVector<VertexId, std::array<PlaneIndex, 3>> of_vertex;
  /// (3 n_faces) plane on which a boundary halfedge lies; kNoPlane for the others.
  IdVector<HalfedgeId, PlaneIndex> of_edge;
  /// (n_vertices) 1: the wall turns away from a plane there or runs on in it, so that no line can land; empty: none.
  IdVector<VertexId, char> is_held;
  std::vector<PlaneCorner> corners;  ///< of the domain, at which the wall has no vertex

  bool empty() const { return planes.empty(); }
  bool is_on_plane(VertexId v) const { return !empty() && of_vertex[v][0] != kNoPlane; }
  bool is_on(VertexId v, PlaneIndex plane) const;
  /// Planes of v.
  std::span<const PlaneIndex> of(VertexId v) const;
  /// The part of a vector that lies in all planes of v; zero where three planes meet.
  Vec3 within(VertexId v, const Vec3& d) const;
  /// `within` as a unit vector; zero where nothing is left.
  Vec3 direction_within(VertexId v, const Vec3& d) const;
};

}  // namespace nearwall::mesh

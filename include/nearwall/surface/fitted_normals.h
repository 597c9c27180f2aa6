#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/topology.h"

namespace nearwall::surface {

/// The function whose graph, over the plane square to an axis, is laid through a vertex and its neighbours. Planes are
/// reproduced by all but Shepard's. Source: Bohdal 2017, section 2.2, put right in docs/theory/fitted-normals.md.
enum class Fit {
  LinearLeastSquares,     ///< plane nearest to the point and its neighbours; Eq. (2)
  QuadraticLeastSquares,  ///< quadratic nearest to the point and its neighbours, unweighted; Eq. (3)
  RenkaCline,             ///< quadratic through the point, near ones of the neighbours weigh more; Eq. (4)
  Shepard,  ///< mean of the neighbours' heights, weighted 1 / d². The point itself is left out: with it the interpolant
            ///< has a flat spot there, whatever the heights; Eq. (6)
  Hardy,      ///< multiquadrics through all, with an affine part; Eq. (7), (9)
  ThinPlate,  ///< thin plate spline through all; Eq. (7), (8)
};

/// Neighbours that a fit looks at; of more, the nearest count.
inline constexpr std::size_t kMaxFittedNeighbours = 64;

/// Normal at `point` of the function fitted to the heights of the point and its neighbours over the plane square to
/// `axis`.
/// \param axis        any length; usually a weighted normal. z where the surface is a height field z(x, y)
/// \param neighbours  in any order, the point itself left out
/// \returns  unit vector on the side of the axis. nullopt where the fit says nothing: no axis; fewer neighbours than 2
///           (LinearLeastSquares, Hardy, ThinPlate), 3 (Shepard) or 5 (the quadratics); all on one line (but for
///           Shepard) or on a curve that leaves the quadratic open; seen along the axis, a neighbour at the point
///           itself (RenkaCline, Shepard, Hardy, ThinPlate) or two at one place (Hardy, ThinPlate); a graph steeper
///           than 2^26. Rank is decided to 2^-30 (planes, quadratics) and 2^-40 (Hardy, ThinPlate):
///           docs/theory/fitted-normals.md, section 4
/// The same bits on permuted axes and at scales by powers of two. Cost: O(n) for the first four, O(n³) for the others.
std::optional<Vec3> fitted_normal(Fit fit, const Vec3& point, const Vec3& axis, std::span<const Vec3> neighbours);

/// Vertices round a vertex, ring by ring, with memory that is used again: one for each thread.
class Neighbourhood {
 public:
  explicit Neighbourhood(const mesh::Topology& topology) : topology_(topology) {}

  /// Vertices that at most `n_rings` edges join to v, v left out, each once: the first ring counterclockwise, then what
  /// is new round each vertex of it, and so on. A vertex with more than `kMaxFan` faces is in a ring but passes on
  /// nothing, or the neighbourhoods of all vertices round a hub would be as large as its own.
  /// Valid until the next call. Cost: O(n) in the number of vertices found.
  std::span<const VertexId> of(VertexId v, int n_rings = 2);

  static constexpr std::size_t kMaxFan = 64;

 private:
  void add(VertexId v);
  void add_ring(VertexId v);
  void grow_table();

  const mesh::Topology& topology_;
  std::vector<VertexId> found_;
  std::vector<std::uint32_t> table_;  // hash table of those found; a power of two long
};

}  // namespace nearwall::surface

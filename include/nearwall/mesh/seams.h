#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/mesh/side_planes.h"

namespace nearwall::mesh {

/// Directed edges between points, of each plane: (n_planes) lists.
using PlaneEdges = std::vector<std::vector<std::array<std::uint32_t, 2>>>;

/// A straight edge in which two planes meet, from one point to another in the first of them, back in the second.
struct Seam {
  PlaneIndex first = kNoPlane;
  PlaneIndex second = kNoPlane;
  std::array<std::uint32_t, 2> ends{};
};

struct Seams {
  std::vector<Seam> seams;
  std::vector<Vec3> corners;         ///< points in which three planes meet: numbers n_points, n_points + 1, …
  std::vector<std::uint32_t> loose;  ///< points at which the edges of a plane end and no seam goes on
};

/// Where the edges of planes do not close to loops, they end at points that lie on another plane, too, and go on along
/// the edge between the two: the points along it are joined by twos, in their order. Where one is left over on each of
/// the edges between three planes, these end in the point that the three have in common.
/// \param corners  in which edges between planes end without any point there
/// Cost: O(n log n) for n edges.
Seams find_seams(std::span<const Vec3> points, std::span<const SidePlane> planes, const PlaneEdges& edges,
                 std::span<const PlaneCorner> corners = {});

}  // namespace nearwall::mesh

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/mesh/side_planes.h"
#include "nearwall/planar/point2.h"

namespace nearwall::certify {

/// Edges on a plane in its coordinates, their points numbered anew in the order in which the edges name them.
struct FlatEdges {
  std::vector<planar::Point2> points;
  std::vector<std::uint32_t> original;  ///< (n_points) number among the positions given
  std::vector<planar::Edge> edges;

  /// Cost: O(n_edges).
  FlatEdges(const mesh::SidePlane& plane, std::span<const std::array<std::uint32_t, 2>> edges_in_space,
            std::span<const Vec3> positions);
};

}  // namespace nearwall::certify

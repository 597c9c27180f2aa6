#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"

namespace nearwall::layers {

/// How the loop of lines round a corner is filled with virtual triangles.
struct CornerFilling {
  /// Counterclockwise seen from the fluid; indices into the loop, or the size of the loop for the centre line.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool has_centre = false;
  Vec3 centre;  ///< direction of the centre line, unit vector

  bool exists() const { return !triangles.empty(); }
};

/// Triangles over a loop of directions, each of which turns the right way round, exactly: so that the tetrahedra of the
/// first layer are positive. Of all triangulations of the loop, and of the one that joins each of its sides to the most
/// visible direction in the middle, the one whose smallest determinant is largest; of those that are alike the one
/// with the shortest diagonals.
/// None exists where the loop cannot be filled or has more than 256 lines.
/// \param loop  (n >= 3) unit vectors, counterclockwise seen from the fluid.    Cost: O(n³).
/// Source: docs/theory/fans.md.
CornerFilling fill_corner(std::span<const Vec3> loop);

}  // namespace nearwall::layers

#pragma once

#include <cstdint>
#include <vector>

#include "nearwall/volume/fill.h"

namespace nearwall::volume {

/// What every boundary must be before a mesher sees it: finite, closed, without crossings and triangles without area.
/// \throws InputError, FillFailed
void check_boundary(const FillBoundary& boundary);

/// Parts of the boundary that hang together by edges of two triangles.
struct BoundaryParts {
  std::vector<std::uint32_t> part;  ///< (n_triangles)
  std::uint32_t n_parts = 0;
};
BoundaryParts parts_of(const FillBoundary& boundary);

}  // namespace nearwall::volume

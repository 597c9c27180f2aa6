#pragma once

#include <span>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/cell.h"

namespace nearwall::quality {

/// Scaled Jacobian: the smallest determinant of the three unit edge vectors at a corner, over that of the ideal cell,
/// so that the regular tetrahedron, the equilateral pyramid and prism, and the cube have 1. Not positive for a cell
/// that is inverted at a corner; 0 where an edge has no length. Not a proof of validity: that is the certificate's.
/// \param p  corners in the order of predicates/cells.h, size_of(type) of them
/// Source: docs/theory/quality.md, Eqs. (1) to (4)
double scaled_jacobian(mesh::CellType type, std::span<const Vec3> p);

/// Longest edge over shortest edge, >= 1; infinite where an edge has no length. Source: docs/theory/quality.md, Eq. (5)
double aspect_ratio(mesh::CellType type, std::span<const Vec3> p);

}  // namespace nearwall::quality

#pragma once

#include <span>

#include "nearwall/core/vec3.h"

namespace nearwall::predicates {

/// Is det J > 0 at every point of the element? Decided exactly on the coordinates given.
/// Undecided comes from hexahedra only, when a bounded number of subdivisions did not settle it.
enum class Positivity { Positive, NotPositive, Undecided };

// Node order: bottom face counterclockwise seen from the top (or apex), then the top in the same order;
// tetrahedron: (p1 − p0) × (p2 − p0) · (p3 − p0) > 0. Files use VTK's own order, which only io knows.
// Source: docs/theory/predicates.md, Eqs. (7) to (13).

Positivity tetrahedron(std::span<const Vec3, 4> p);
Positivity pyramid(std::span<const Vec3, 5> p);
Positivity wedge(std::span<const Vec3, 6> p);
Positivity hexahedron(std::span<const Vec3, 8> p);

/// Three lines of points, as the certificate of a column reads them: arrays of `n_levels + 1` coordinates each.
struct WedgeColumn {
  const double* x[3];
  const double* y[3];
  const double* z[3];
};

/// First level j in [0, n_levels) whose wedge (levels j, j + 1 of the three lines) is not positive; n_levels if all
/// are. The same answers as `wedge`, many times as fast: doubles with a proven error bound, exact only where they leave
/// it open.
int first_bad_wedge(const WedgeColumn& column, int n_levels);

}  // namespace nearwall::predicates

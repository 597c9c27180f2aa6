#pragma once

#include "nearwall/volume/fill.h"

namespace nearwall::volume {

/// Holds a fill against its boundary, exactly: points bit for bit, tetrahedra positive, each inner face between two of
/// them that see it from either side, each outer one a triangle of the boundary, and all of these there.
/// \throws FillFailed  with the triangles that are missing, if any are
void check_fill(const FillBoundary& boundary, const Fill& fill);

}  // namespace nearwall::volume

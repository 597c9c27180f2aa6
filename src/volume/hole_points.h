#pragma once

#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/volume/fill.h"

namespace nearwall::volume {

/// A point strictly outside the region beside each part of the boundary: in the hole, or outside of everything, that
/// the part bounds. \throws FillFailed  where the boundary has the region on its outer side, on both, or on none
std::vector<Vec3> hole_points(const FillBoundary& boundary);

}  // namespace nearwall::volume

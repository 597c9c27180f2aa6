#pragma once

#include "vertex_field.h"

namespace nearwall::layers {

/// Keeps the ends of lines that do not lie on a plane before it: a line ends where it has come as near to the plane as
/// a tenth of the distance at which it begins. Source: docs/theory/planes.md, Eq. (2)
/// \returns vertices that were lowered, in increasing order
std::vector<VertexId> limit_by_planes(const Wall& wall, const LinePlan& plan, VertexField& field);

}  // namespace nearwall::layers

#pragma once

#include <vector>

#include "line_plan.h"

namespace nearwall::layers {

/// Vertices whose fans fit no layers, however thin: where two layers a thousandth of an edge thick have a cell or a cap
/// that is not positive, or meet those beside them. Only the faces round vertices with several lines are looked at.
/// Also those that cannot leave the wall with several lines. In increasing order.
std::vector<VertexId> find_unfit(const Wall& wall, const LinePlan& plan);

}  // namespace nearwall::layers

#pragma once

#include <vector>

#include "line_plan.h"

namespace nearwall::layers {

/// Vertices whose fans do not fit: where two layers, a thousandth of the shortest edge at each vertex thick, have a
/// cell or a cap that is not positive, or meet those beside them. Only the faces round vertices with several lines are
/// looked at. Also those whose several lines cannot leave the wall. In increasing order. Cost: O(n log n) in those
/// faces, and quadratic in those round one vertex.
std::vector<VertexId> find_unfit(const Wall& wall, const LinePlan& plan);

}  // namespace nearwall::layers

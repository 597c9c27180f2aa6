#pragma once

#include <span>

#include "nearwall/planar/point2.h"

namespace nearwall::planar {

/// \throws InputError  if an edge names a point that does not exist or one whose coordinates are not finite.
void check_edges(std::span<const Point2> points, std::span<const Edge> edges);

}  // namespace nearwall::planar

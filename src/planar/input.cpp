#include "planar/input.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::planar {

void check_edges(std::span<const Point2> points, std::span<const Edge> edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (const std::uint32_t p : edges[i]) {
      if (p >= points.size()) {
        throw InputError(fmt::format("edge {} in the plane: expected points below {}, found {}", i, points.size(), p));
      }
      if (!std::isfinite(points[p].u) || !std::isfinite(points[p].v)) {
        throw InputError(fmt::format("edge {} in the plane: expected finite coordinates, found ({}, {}) for point {}",
                                     i, points[p].u, points[p].v, p));
      }
    }
  }
}

}  // namespace nearwall::planar

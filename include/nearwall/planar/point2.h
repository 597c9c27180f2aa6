#pragma once

#include <array>
#include <cstdint>

namespace nearwall::planar {

/// A point of the plane [length].
struct Point2 {
  double u = 0;
  double v = 0;
  bool operator==(const Point2&) const = default;
};

/// Two numbers of points: a straight edge from the first to the second.
using Edge = std::array<std::uint32_t, 2>;
/// Three numbers of points, counterclockwise.
using Triangle = std::array<std::uint32_t, 3>;

}  // namespace nearwall::planar

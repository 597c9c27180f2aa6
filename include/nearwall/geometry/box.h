#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "nearwall/core/vec3.h"

namespace nearwall::geometry {

/// Axis-aligned box; empty when made.
struct Box {
  Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(low.x() <= high.x()); }

  void include(const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  void include(const Box& b) {
    include(b.low);
    include(b.high);
  }

  /// Closed boxes: touching counts.
  bool intersects(const Box& b) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (low[axis] > b.high[axis] || b.low[axis] > high[axis]) return false;
    }
    return true;
  }
  bool contains(const Vec3& p) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] < low[axis] || p[axis] > high[axis]) return false;
    }
    return true;
  }

  Vec3 centre() const { return (low + high) * 0.5; }
  double diagonal() const { return is_empty() ? 0.0 : norm(high - low); }
};

inline Box bounding_box(std::span<const Vec3> points) {
  Box box;
  for (const Vec3& p : points) box.include(p);
  return box;
}

}  // namespace nearwall::geometry

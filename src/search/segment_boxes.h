#pragma once

#include <cmath>
#include <limits>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/box.h"

namespace nearwall::search {

/// Where a straight line from a point meets boxes: intervals of its parameter t, 0 at `from` and 1 at `to`, never too
/// small by rounding, so that no box is missed (slabs, with the bounds of Ize 2013). A box within another gives an
/// interval within the other's.
class SegmentBoxes {
 public:
  SegmentBoxes(const Vec3& from, const Vec3& to, double t_max) : from_(from), t_max_(t_max) {
    const Vec3 d = to - from;
    for (int k = 0; k < 3; ++k) {
      inverse_[k] = 1.0 / d[k];
      is_parallel_[k] = d[k] == 0;
    }
  }

  /// Closed; empty if first > last.
  struct Interval {
    double first, last;
    bool is_empty() const { return !(first <= last); }
  };

  Interval interval(const geometry::Box& box) const {
    Interval i{0.0, t_max_};
    for (int k = 0; k < 3; ++k) {
      if (is_parallel_[k]) {
        if (from_[k] < box.low[k] || from_[k] > box.high[k]) return {1.0, 0.0};
        continue;
      }
      const double a = (box.low[k] - from_[k]) * inverse_[k], b = (box.high[k] - from_[k]) * inverse_[k];
      const double enter = a < b ? a : b, leave = a < b ? b : a;
      // Comparisons in this order leave the interval alone where an overflow has made something not a number.
      const double first = enter - std::abs(enter) * kRelative - kAbsolute;
      const double last = leave + std::abs(leave) * kRelative + kAbsolute;
      if (first > i.first) i.first = first;
      if (last < i.last) i.last = last;
    }
    return i;
  }

 private:
  /// Two differences, a quotient and a product, one rounding each; twice that for second order and for this bound
  /// itself.
  static constexpr double kRelative = 4.0 * std::numeric_limits<double>::epsilon();
  static constexpr double kAbsolute = 0x1p-1000;  ///< more than underflow can lose

  Vec3 from_;
  Vec3 inverse_;
  bool is_parallel_[3] = {};
  double t_max_;
};

}  // namespace nearwall::search

#include "nearwall/planar/graded_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::planar {
namespace {

/// The sizes that grow from one end up to `top`, seen from there.
struct Ramp {
  double first, growth, top;

  double length() const { return growth > 0 ? (top - first) / growth : 0; }
  /// Number of pieces on it: the integral of 1 / size.
  double pieces() const { return growth > 0 ? std::log(top / first) / growth : 0; }
  /// Place up to which the integral is c, also beyond the ramp, where the size is `top`.
  double place(double c) const {
    if (c > pieces()) return length() + (c - pieces()) * top;
    return growth > 0 ? first * std::expm1(growth * c) / growth : 0;
  }
};

}  // namespace

std::vector<double> graded_points(double length, double size_begin, double size_end, double growth, double largest) {
  if (!(length > 0 && std::isfinite(length) && size_begin > 0 && size_end > 0 && largest > 0 && growth >= 0)) {
    throw InputError(fmt::format(
        "graded points: expected positive lengths and a growth of at least 0, found length {}, sizes {} and {}, "
        "growth {}, largest {}",
        length, size_begin, size_end, growth, largest));
  }
  const double begin = std::min({size_begin, largest, size_end + growth * length});
  const double end = std::min({size_end, largest, size_begin + growth * length});
  const double top = growth > 0 ? std::min(largest, 0.5 * (begin + end + growth * length)) : std::min(begin, end);
  // Rounding may leave the top a trace below the larger end.
  const Ramp from_begin{growth > 0 ? std::min(begin, top) : top, growth, top};
  const Ramp from_end{growth > 0 ? std::min(end, top) : top, growth, top};
  const double flat = std::max(0.0, length - from_begin.length() - from_end.length());
  const double pieces = from_begin.pieces() + flat / top + from_end.pieces();
  const double n = std::max(1.0, std::round(pieces));
  if (!(n < std::numeric_limits<std::uint32_t>::max())) {
    throw InputError(fmt::format("graded points: sizes {} and {} ask for too many points on a length of {}", size_begin,
                                 size_end, length));
  }

  std::vector<double> places;
  for (double k = 1; k < n; ++k) {
    const double before = pieces * (k / n), after = pieces * ((n - k) / n);
    // From the end whose ramp it is on; on the flat between them from the nearer one.
    const bool is_nearer_begin = before - from_begin.pieces() <= after - from_end.pieces();
    places.push_back(is_nearer_begin ? from_begin.place(before) : length - from_end.place(after));
  }
  return places;
}

}  // namespace nearwall::planar

#include "nearwall/search/winding.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/intersection.h"
#include "search/ray_directions.h"
#include "search/segment_boxes.h"

namespace nearwall::search {

namespace {

using predicates::RayCrossing;

constexpr std::size_t kBlock = 4096;

/// Signed crossings of one ray, nothing if it is degenerate.
std::optional<int> count_crossings(const IndexedTriangles& soup, const Vec3& point, const Vec3& through,
                                   std::span<const char> include) {
  const SegmentBoxes ray(point, through, std::numeric_limits<double>::infinity());
  std::atomic<int> sum = 0;
  std::atomic<bool> is_degenerate = false;
  parallel_blocks(soup.triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    int block_sum = 0;
    for (std::size_t i = begin; i < end && !is_degenerate.load(std::memory_order_relaxed); ++i) {
      if (!include.empty() && !include[i]) continue;
      const auto& v = soup.triangles[i];
      const predicates::Triangle t{soup.points[v[0]], soup.points[v[1]], soup.points[v[2]]};
      if (ray.interval(geometry::bounding_box(t)).is_empty()) continue;
      const RayCrossing crossing = predicates::ray_crossing(point, through, t);
      if (crossing == RayCrossing::Degenerate) is_degenerate = true;
      if (crossing == RayCrossing::Along) ++block_sum;
      if (crossing == RayCrossing::Against) --block_sum;
    }
    sum += block_sum;
  });
  if (is_degenerate) return std::nullopt;
  return sum;
}

}  // namespace

int winding_number(const IndexedTriangles& soup, const Vec3& point, std::span<const char> include) {
  expect(include.empty() || include.size() == soup.triangles.size(), "one mark for each triangle");
  // A ray as long as its point is far from the origin has a direction that rounding hardly turns.
  double reach = max_norm(point);
  for (const Vec3& p : soup.points) reach = std::max(reach, max_norm(p));
  if (reach == 0) reach = 1.0;
  for (int k = 0; k < kMaxRays; ++k) {
    if (const auto crossings = count_crossings(soup, point, point + reach * ray_direction(k), include))
      return *crossings;
  }
  throw GeometryError(fmt::format("expected a point off the surface to count windings about, found ({}, {}, {}) on it",
                                  point.x(), point.y(), point.z()));
}

}  // namespace nearwall::search

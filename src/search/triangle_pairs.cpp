#include "search/triangle_pairs.h"

#include <algorithm>

#include "nearwall/predicates/intersection.h"

namespace nearwall::search {

namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Corners of two triangles that are one node: places in the first and in the second, and how many.
struct SharedCorners {
  std::array<int, 3> in_a{}, in_b{};
  int count = 0;
};

SharedCorners shared_corners(const Corners& a, const Corners& b) {
  SharedCorners shared;
  for (int i = 0; i < 3; ++i) {
    if (std::find(a.begin(), a.begin() + i, a[i]) != a.begin() + i) continue;  // a repeated corner counts once
    const auto at = std::find(b.begin(), b.end(), a[i]);
    if (at == b.end()) continue;
    shared.in_a[shared.count] = i;
    shared.in_b[shared.count++] = static_cast<int>(at - b.begin());
  }
  return shared;
}

predicates::Triangle corners(std::span<const Vec3> points, const Corners& t, int i, int j, int k) {
  return {points[t[i]], points[t[j]], points[t[k]]};
}

}  // namespace

bool triangles_meet(std::span<const Vec3> points, const Corners& a, const Corners& b) {
  const SharedCorners shared = shared_corners(a, b);
  const auto [a0, a1, a2] = shared.in_a;
  const auto [b0, b1, b2] = shared.in_b;
  switch (shared.count) {
    case 0:
      return predicates::triangles_intersect(corners(points, a, 0, 1, 2), corners(points, b, 0, 1, 2));
    case 1:
      return predicates::triangles_intersect_beyond_vertex(corners(points, a, a0, (a0 + 1) % 3, (a0 + 2) % 3),
                                                           corners(points, b, b0, (b0 + 1) % 3, (b0 + 2) % 3));
    case 2:
      return predicates::triangles_overlap_beyond_edge(corners(points, a, a0, a1, 3 - a0 - a1),
                                                       corners(points, b, b0, b1, 3 - b0 - b1));
    default:
      return true;
  }
}

}  // namespace nearwall::search

#include "studies/delaunay.h"

#include <algorithm>

namespace nearwall::studies {

std::vector<Triangle2> periodic_delaunay(std::span<const Point2> points, const Point2& period) {
  // The points themselves come first, so that a corner below n is one of the middle copy.
  const auto n = static_cast<std::uint32_t>(points.size());
  std::vector<Point2> copies(points.begin(), points.end());
  for (const int i : {-1, 0, 1}) {
    for (const int j : {-1, 0, 1}) {
      if (i == 0 && j == 0) continue;
      for (const Point2& p : points) copies.push_back({p.x + i * period.x, p.y + j * period.y});
    }
  }
  std::vector<Triangle2> triangles;
  for (const Triangle2& t : delaunay(copies)) {
    // Of the copies of a triangle, the one whose corner of smallest number is in the middle.
    const Triangle2 corners = {t[0] % n, t[1] % n, t[2] % n};
    const auto smallest = std::min_element(corners.begin(), corners.end()) - corners.begin();
    if (t[smallest] < n) triangles.push_back(corners);
  }
  return triangles;
}

}  // namespace nearwall::studies

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "nearwall/planar/crossing_edges.h"
#include "planar/input.h"

namespace nearwall::planar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;

/// A box as CGAL's box intersection wants it. (Its own boxes are numbered by a counter that all threads share.)
struct Box {
  using NT = double;
  using ID = std::size_t;

  std::uint32_t number;
  std::array<double, 2> low, high;

  static int dimension() { return 2; }
  ID id() const { return number; }
  NT min_coord(int axis) const { return low[static_cast<std::size_t>(axis)]; }
  NT max_coord(int axis) const { return high[static_cast<std::size_t>(axis)]; }
};

Point point_of(const Point2& p) { return Point(p.u, p.v); }

/// Whether two edges from the same point v, to a and b, meet anywhere else: one lies in the other.
bool meet_beyond(const Point& v, const Point& a, const Point& b) {
  if (CGAL::orientation(v, a, b) != CGAL::COLLINEAR) return false;
  // On a line, the lexicographic order tells the side. An edge without length lies in any other.
  const CGAL::Comparison_result side_a = CGAL::compare_xy(a, v), side_b = CGAL::compare_xy(b, v);
  return side_a == side_b || side_a == CGAL::EQUAL || side_b == CGAL::EQUAL;
}

bool meet(std::span<const Point2> points, const Edge& e, const Edge& f) {
  const auto at = [&](std::uint32_t i) { return point_of(points[i]); };
  if (e[0] == f[0] && e[1] == f[1]) return true;
  if (e[0] == f[1] && e[1] == f[0]) return false;
  for (const std::size_t i : {0, 1}) {
    for (const std::size_t j : {0, 1}) {
      if (e[i] == f[j]) return meet_beyond(at(e[i]), at(e[1 - i]), at(f[1 - j]));
    }
  }
  return CGAL::do_intersect(Segment(at(e[0]), at(e[1])), Segment(at(f[0]), at(f[1])));
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_edges(std::span<const Point2> points,
                                                                    std::span<const Edge> edges) {
  check_edges(points, edges);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const Point2 &a = points[edges[i][0]], &b = points[edges[i][1]];
    boxes.push_back({i, {std::min(a.u, b.u), std::min(a.v, b.v)}, {std::max(a.u, b.u), std::max(a.v, b.v)}});
    if (a == b) pairs.push_back({i, i});
  }
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const auto [i, j] = std::minmax(a.number, b.number);
    if (meet(points, edges[i], edges[j])) pairs.push_back({i, j});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace nearwall::planar

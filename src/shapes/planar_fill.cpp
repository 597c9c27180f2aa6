#include "shapes/planar_fill.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nearwall/planar/region.h"
#include "nearwall/planar/size_field.h"

namespace nearwall::shapes {
namespace {

/// Size may grow by this much per unit of distance from the boundary.
constexpr double kGrowth = 0.25;
/// Edges of the boundary that are not much shorter than the size, by this factor, do not make triangles inside smaller.
constexpr double kShort = 0.77;

double doubled_area(const std::vector<Point2>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &p = loop[i], &q = loop[(i + 1) % loop.size()];
    sum += p.u * q.v - q.u * p.v;
  }
  return sum;
}

/// Edges of the loops with the region to their left: the largest loop runs counterclockwise, the others clockwise.
std::vector<planar::Edge> directed_edges(const std::vector<std::vector<Point2>>& loops) {
  const auto outer = std::max_element(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
    return std::abs(doubled_area(a)) < std::abs(doubled_area(b));
  });
  std::vector<planar::Edge> edges;
  std::uint32_t first = 0;
  for (auto loop = loops.begin(); loop != loops.end(); ++loop) {
    const auto n = static_cast<std::uint32_t>(loop->size());
    const bool is_forward = (doubled_area(*loop) > 0) == (loop == outer);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = first + i, b = first + (i + 1) % n;
      edges.push_back(is_forward ? planar::Edge{a, b} : planar::Edge{b, a});
    }
    first += n;
  }
  return edges;
}

/// Triangles inside are no finer than the boundary asks for, and no coarser than asked.
planar::GradedSize sizes(const std::vector<Point2>& points, const std::vector<planar::Edge>& edges, double size) {
  std::vector<planar::SizeSource> sources;
  double longest = 0;
  for (const auto& [i, j] : edges) {
    const Point2 &a = points[i], &b = points[j];
    const double u = b.u - a.u, v = b.v - a.v;
    sources.push_back({{0.5 * (a.u + b.u), 0.5 * (a.v + b.v)}, std::sqrt(u * u + v * v)});
    longest = std::max(longest, sources.back().size);
  }
  const double largest = std::min(size, longest);
  std::erase_if(sources, [largest](const planar::SizeSource& s) { return s.size > kShort * largest; });
  return {points, {}, {kGrowth, largest}, sources};
}

}  // namespace

PlanarFill fill_region(const std::vector<std::vector<Point2>>& loops, double size) {
  std::vector<Point2> points;
  for (const auto& loop : loops) points.insert(points.end(), loop.begin(), loop.end());
  const std::vector<planar::Edge> edges = directed_edges(loops);
  planar::RefinedRegion filled = planar::refine_region(points, edges, sizes(points, edges, size));
  filled.points.erase(filled.points.begin(), filled.points.begin() + static_cast<std::ptrdiff_t>(points.size()));
  return {filled.points, filled.triangles};
}

}  // namespace nearwall::shapes

#include "studies/delaunay.h"

#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "studies/random.h"

namespace nearwall::studies {
namespace {

std::vector<Point2> random_points(std::size_t n, double width, double height) {
  RandomStream random(7, n);
  std::vector<Point2> points(n);
  for (Point2& p : points) p = {random.uniform(0, width), random.uniform(0, height)};
  return points;
}

double cross(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// > 0 if d is in the circle through a, b, c (counterclockwise).
double in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const auto square = [&](const Point2& p) { return (p.x - d.x) * (p.x - d.x) + (p.y - d.y) * (p.y - d.y); };
  return square(a) * cross(d, b, c) + square(b) * cross(d, c, a) + square(c) * cross(d, a, b);
}

TEST(Delaunay, CirclesOfTheTrianglesAreEmpty) {
  const auto points = random_points(60, 1, 1);
  const auto triangles = delaunay(points);
  ASSERT_GT(triangles.size(), points.size());
  for (const Triangle2& t : triangles) {
    EXPECT_GT(cross(points[t[0]], points[t[1]], points[t[2]]), 0);
    for (const Point2& p : points) EXPECT_LT(in_circle(points[t[0]], points[t[1]], points[t[2]], p), 1e-12);
  }
}

TEST(PeriodicDelaunay, ClosesUpToATorus) {
  const Point2 period = {1, 0.75};
  const auto points = random_points(200, period.x, period.y);
  const auto triangles = periodic_delaunay(points, period);
  EXPECT_EQ(triangles.size(), 2 * points.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle2& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  EXPECT_EQ(edges.size(), 6 * points.size());
  for (const auto& [edge, n] : edges) EXPECT_TRUE(edges.contains({edge.second, edge.first}));
}

}  // namespace
}  // namespace nearwall::studies

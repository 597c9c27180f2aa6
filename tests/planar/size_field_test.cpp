#include "nearwall/planar/size_field.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "tests/planar/regions.h"

namespace nearwall::planar {
namespace {

TEST(GradedSize, GrowsFromAnEdge) {
  const GradedSize size(std::vector<Point2>{{0, 0}, {2, 0}}, std::vector<Edge>{{0, 1}}, {0.5});
  EXPECT_DOUBLE_EQ(size({1, 0}), 2);
  EXPECT_DOUBLE_EQ(size({1, 4}), 2 + 0.5 * 4);
  EXPECT_DOUBLE_EQ(size({5, 4}), 2 + 0.5 * 5);
  EXPECT_DOUBLE_EQ(size({-3, -4}), 2 + 0.5 * 5);
}

TEST(GradedSize, IsBoundedByTheLargest) {
  const GradedSize size(std::vector<Point2>{{0, 0}, {2, 0}}, std::vector<Edge>{{0, 1}}, {0.5, 3});
  EXPECT_DOUBLE_EQ(size({1, 1}), 2.5);
  EXPECT_DOUBLE_EQ(size({1, 100}), 3);
  const GradedSize constant({}, {}, {0.3, 7});
  EXPECT_EQ(constant({1, 2}), 7);
}

TEST(GradedSize, TakesPlacesBesideEdges) {
  const std::vector<SizeSource> sources{{{10, 0}, 0.125}};
  const GradedSize size(std::vector<Point2>{{0, 0}, {2, 0}}, std::vector<Edge>{{0, 1}}, {0.5}, sources);
  EXPECT_DOUBLE_EQ(size({10, 0}), 0.125);
  EXPECT_DOUBLE_EQ(size({10, 2}), 1.125);
  EXPECT_DOUBLE_EQ(size({1, 0}), 2);
}

TEST(GradedSize, IsTheLeastOverAllEdges) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Point2> points;
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < 400; ++i) {
    const double reach = std::pow(10, 2 * uniform(random) - 2);
    points.push_back({uniform(random), uniform(random)});
    points.push_back({points.back().u + reach * uniform(random), points.back().v + reach * uniform(random)});
    edges.push_back({2 * i, 2 * i + 1});
  }
  const GradedSize size(points, edges, {0.3, 0.2});
  for (int trial = 0; trial < 1000; ++trial) {
    const Point2 p{2 * uniform(random), 2 * uniform(random)};
    double least = 0.2;
    for (const auto& [i, j] : edges) {
      const Point2 &a = points[i], &b = points[j];
      const double length = std::hypot(b.u - a.u, b.v - a.v);
      const double along = ((p.u - a.u) * (b.u - a.u) + (p.v - a.v) * (b.v - a.v)) / length;
      const double t = std::clamp(along / length, 0.0, 1.0);
      const double away = std::hypot(p.u - a.u - t * (b.u - a.u), p.v - a.v - t * (b.v - a.v));
      least = std::min(least, length + 0.3 * away);
    }
    EXPECT_NEAR(size(p), least, 1e-14);
  }
}

TEST(GradedSize, ScalesByPowersOfTwoExactly) {
  const Outline o = Outline().loop(ring(0.1, 0.2, 1, 100));
  std::vector<Point2> small = o.points;
  for (Point2& p : small) p = {0x1p-60 * p.u, 0x1p-60 * p.v};
  const GradedSize size(o.points, o.edges, {0.3}), small_size(small, o.edges, {0.3});
  for (const double u : {0.0, 0.3, 2.0, -7.0}) {
    EXPECT_EQ(small_size({0x1p-60 * u, 0x1p-61}), 0x1p-60 * size({u, 0.5}));
  }
}

TEST(GradedSize, RefusesWhatMakesNoSense) {
  const std::vector<Point2> points{{0, 0}, {0, 0}, {1, 0}};
  EXPECT_THROW(GradedSize(points, std::vector<Edge>{{0, 1}}, {0.3}), InputError);
  EXPECT_THROW(GradedSize(points, std::vector<Edge>{{0, 3}}, {0.3}), InputError);
  EXPECT_THROW(GradedSize(points, std::vector<Edge>{{0, 2}}, {-0.3}), InputError);
  EXPECT_THROW(GradedSize(points, std::vector<Edge>{{0, 2}}, {0.3, 0}), InputError);
  EXPECT_THROW(GradedSize({}, {}, {0.3}), InputError);
  EXPECT_THROW(GradedSize({}, {}, {0.3, 1}, std::vector<SizeSource>{{{0, 0}, 0}}), InputError);
}

}  // namespace
}  // namespace nearwall::planar

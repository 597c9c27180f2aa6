#include "nearwall/planar/crossing_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"

namespace nearwall::planar {
namespace {

using Points = std::vector<Point2>;
using Edges = std::vector<Edge>;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

TEST(CrossingEdges, FindsACross) {
  EXPECT_EQ(crossing_edges(Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}}, Edges{{0, 1}, {2, 3}}), (Pairs{{0, 1}}));
}

TEST(CrossingEdges, FindsAnEndPointOnAnotherEdge) {
  // 1/3 of the way: exact for this slope only.
  EXPECT_EQ(crossing_edges(Points{{0, 0}, {3, 6}, {1, 2}, {5, 0}}, Edges{{0, 1}, {2, 3}}), (Pairs{{0, 1}}));
  const double off = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(crossing_edges(Points{{0, 0}, {3, 6}, {off, 2}, {5, 0}}, Edges{{0, 1}, {2, 3}}).empty());
}

TEST(CrossingEdges, AllowsCommonEndPoints) {
  EXPECT_TRUE(crossing_edges(Points{{0, 0}, {1, 0}, {0, 1}}, Edges{{0, 1}, {1, 2}, {2, 0}}).empty());
  EXPECT_TRUE(crossing_edges(Points{{0, 0}, {1, 0}, {2, 0}}, Edges{{0, 1}, {1, 2}}).empty());
}

TEST(CrossingEdges, FindsEqualPointsOfDifferentNumbers) {
  EXPECT_EQ(crossing_edges(Points{{0, 0}, {1, 0}, {1, 0}, {2, 1}}, Edges{{0, 1}, {2, 3}}), (Pairs{{0, 1}}));
  EXPECT_EQ(crossing_edges(Points{{0, 0}, {1, 0}, {1, 0}}, Edges{{0, 1}, {0, 2}}), (Pairs{{0, 1}}));
}

TEST(CrossingEdges, FindsOverlapsFromACommonEndPoint) {
  const Points points{{0, 0}, {3, 6}, {1, 2}};
  for (const Edges& edges :
       {Edges{{0, 1}, {0, 2}}, Edges{{1, 0}, {0, 2}}, Edges{{0, 1}, {2, 0}}, Edges{{1, 0}, {2, 0}}}) {
    EXPECT_EQ(crossing_edges(points, edges), (Pairs{{0, 1}}));
  }
}

TEST(CrossingEdges, FindsOverlapsWithoutACommonEndPoint) {
  EXPECT_EQ(crossing_edges(Points{{0, 0}, {2, 0}, {1, 0}, {3, 0}}, Edges{{0, 1}, {2, 3}}), (Pairs{{0, 1}}));
  EXPECT_TRUE(crossing_edges(Points{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, Edges{{0, 1}, {2, 3}}).empty());
}

TEST(CrossingEdges, AllowsSlitsButNoEdgeTwice) {
  EXPECT_TRUE(crossing_edges(Points{{0, 0}, {1, 0}}, Edges{{0, 1}, {1, 0}}).empty());
  EXPECT_EQ(crossing_edges(Points{{0, 0}, {1, 0}}, Edges{{0, 1}, {0, 1}}), (Pairs{{0, 1}}));
}

TEST(CrossingEdges, FindsEdgesWithoutLength) {
  EXPECT_EQ(crossing_edges(Points{{0, 0}}, Edges{{0, 0}}), (Pairs{{0, 0}}));
  EXPECT_EQ(crossing_edges(Points{{0, 0}, {0, 0}}, Edges{{0, 1}}), (Pairs{{0, 0}}));
  EXPECT_EQ(crossing_edges(Points{{0, 0}, {1, 0}, {1, 0}, {2, 0}}, Edges{{0, 1}, {1, 2}, {2, 3}}),
            (Pairs{{0, 1}, {0, 2}, {1, 1}, {1, 2}}));
}

TEST(CrossingEdges, IgnoresUnusedPoints) {
  const double nan = std::nan("");
  EXPECT_TRUE(crossing_edges(Points{{0, 0}, {2, 0}, {1, 0}, {nan, nan}}, Edges{{0, 1}}).empty());
}

TEST(CrossingEdges, RefusesWhatIsNoEdge) {
  EXPECT_THROW(crossing_edges(Points{{0, 0}}, Edges{{0, 1}}), InputError);
  EXPECT_THROW(crossing_edges(Points{{0, 0}, {std::numeric_limits<double>::infinity(), 0}}, Edges{{0, 1}}), InputError);
}

/// On a grid of small integers, everything can be told in integers.
bool meet_in_integers(const Points& p, const Edge& e, const Edge& f) {
  const auto orient = [&](const Point2& a, const Point2& b, const Point2& c) {
    const double d = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    return d > 0 ? 1 : d < 0 ? -1 : 0;
  };
  const auto within = [&](const Point2& a, const Point2& b, const Point2& c) {
    return orient(a, b, c) == 0 && std::min(a.u, b.u) <= c.u && c.u <= std::max(a.u, b.u) &&
           std::min(a.v, b.v) <= c.v && c.v <= std::max(a.v, b.v);
  };
  if (e == f) return true;
  if (e[0] == f[1] && e[1] == f[0]) return false;
  const Point2 &a = p[e[0]], &b = p[e[1]], &c = p[f[0]], &d = p[f[1]];
  const auto shared = [](const Edge& x, std::uint32_t i) { return x[0] == i || x[1] == i; };
  if (shared(f, e[0]) || shared(f, e[1])) {
    return (!shared(f, e[0]) && within(c, d, a)) || (!shared(f, e[1]) && within(c, d, b)) ||
           (!shared(e, f[0]) && within(a, b, c)) || (!shared(e, f[1]) && within(a, b, d));
  }
  const bool cross = orient(a, b, c) * orient(a, b, d) < 0 && orient(c, d, a) * orient(c, d, b) < 0;
  return cross || within(a, b, c) || within(a, b, d) || within(c, d, a) || within(c, d, b);
}

TEST(CrossingEdges, AgreesWithIntegersOnAllPairsOfAGrid) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    Points points;
    for (int i = 0; i < 30; ++i)
      points.push_back({static_cast<double>(random() % 12), static_cast<double>(random() % 12)});
    Edges edges;
    while (edges.size() < 25) {
      const Edge e{static_cast<std::uint32_t>(random() % 30), static_cast<std::uint32_t>(random() % 30)};
      if (points[e[0]] != points[e[1]]) edges.push_back(e);
    }
    Pairs expected;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      for (std::uint32_t j = i + 1; j < edges.size(); ++j) {
        if (meet_in_integers(points, edges[i], edges[j])) expected.push_back({i, j});
      }
    }
    EXPECT_EQ(crossing_edges(points, edges), expected);
  }
}

TEST(CrossingEdges, TakesALargeLoopAndARuledLine) {
  const std::uint32_t n = 100000;
  Points circle, line;
  Edges loop, chain;
  for (std::uint32_t i = 0; i < n; ++i) {
    circle.push_back({std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n)});
    line.push_back({0, static_cast<double>(i)});
    loop.push_back({i, (i + 1) % n});
    if (i > 0) chain.push_back({i - 1, i});
  }
  EXPECT_TRUE(crossing_edges(circle, loop).empty());
  EXPECT_TRUE(crossing_edges(line, chain).empty());
  // A chord crosses the polygon only near its ends, where it shares points.
  loop.push_back({0, n / 2});
  EXPECT_TRUE(crossing_edges(circle, loop).empty());
  circle.push_back({0, 2});
  loop.push_back({n, 3 * n / 4 + 1});
  // Straight down the middle: one edge at the top, the chord, none at the bottom, where it ends in a point.
  EXPECT_EQ(crossing_edges(circle, loop).size(), 2u);
}

}  // namespace
}  // namespace nearwall::planar

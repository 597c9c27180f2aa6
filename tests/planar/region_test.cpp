#include "nearwall/planar/region.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "tests/planar/regions.h"

namespace nearwall::planar {
namespace {

using Numbers = std::vector<std::uint32_t>;

RegionTriangulation triangulated(const Outline& o) { return triangulate_region(o.points, o.edges); }

/// The triangulation fills the region and nothing else; its area is known.
void expect_fills(const Outline& o, double area) {
  const RegionTriangulation r = triangulated(o);
  EXPECT_TRUE(r.contradicting_edges.empty());
  EXPECT_STREQ(fault(o.points, o.edges, r.triangles), "");
  EXPECT_DOUBLE_EQ(doubled_area(o.points, r.triangles), 2 * area);
}

TEST(TriangulateRegion, FillsASquare) {
  expect_fills(Outline().loop(rectangle(0, 0, 1, 1)), 1);
  expect_fills(Outline().loop(rectangle(0, 0, 1, 1, 8)), 1);
}

TEST(TriangulateRegion, LeavesHolesOut) {
  expect_fills(Outline().loop(rectangle(0, 0, 4, 4)).hole(rectangle(1, 1, 2, 2)).hole(rectangle(2.5, 1, 3, 3)), 14);
}

TEST(TriangulateRegion, FillsComponentsAndLoopsInHoles) {
  expect_fills(Outline().loop(rectangle(0, 0, 1, 1)).loop(rectangle(3, 3, 5, 4)), 3);
  expect_fills(Outline()
                   .loop(rectangle(0, 0, 8, 8))
                   .hole(rectangle(1, 1, 7, 7))
                   .loop(rectangle(2, 2, 6, 6))
                   .hole(rectangle(3, 3, 5, 5)),
               64 - 36 + 16 - 4);
}

TEST(TriangulateRegion, FillsLoopsThatMeetInAPoint) {
  Outline o = Outline().loop({{0, 0}, {1, 0}, {1, 1}});
  o.points.push_back({-1, 0}), o.points.push_back({-1, -1});
  o.edges.insert(o.edges.end(), {{0, 3}, {3, 4}, {4, 0}});
  expect_fills(o, 1);
}

TEST(TriangulateRegion, KeepsSlits) {
  Outline o = Outline().loop(rectangle(0, 0, 4, 4));
  o.points.insert(o.points.end(), {{1, 1}, {2, 2}, {3, 2}});
  o.edges.insert(o.edges.end(), {{4, 5}, {5, 4}, {5, 6}, {6, 5}});
  expect_fills(o, 16);
  o.edges.insert(o.edges.end(), {{0, 4}, {4, 0}});
  expect_fills(o, 16);
}

TEST(TriangulateRegion, TakesCollinearPointsAlongEdges) {
  const Outline o = Outline().loop({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {1.5, 1}});
  expect_fills(o, 3);
}

TEST(TriangulateRegion, IgnoresPointsNoEdgeUses) {
  Outline o = Outline().loop(rectangle(0, 0, 1, 1));
  o.points.insert(o.points.end(), {{0.5, 0.5}, {0.5, 0}, {0, 0}, {std::nan(""), 1}});
  expect_fills(o, 1);
}

TEST(TriangulateRegion, NamesEdgesWithTheOutsideToTheirLeft) {
  EXPECT_EQ(triangulated(Outline().hole(rectangle(0, 0, 1, 1))).contradicting_edges, (Numbers{0, 1, 2, 3}));
  // A pocket of the hull is outside, too.
  const Outline arrow = Outline().hole({{0, 0}, {2, 0}, {1, 0.25}, {1, 2}});
  EXPECT_EQ(triangulated(arrow).contradicting_edges, (Numbers{0, 1, 2, 3}));
  // Only the loop that runs the wrong way.
  const Outline two = Outline().loop(rectangle(0, 0, 1, 1)).hole(rectangle(3, 3, 5, 4));
  EXPECT_EQ(triangulated(two).contradicting_edges, (Numbers{4, 5, 6, 7}));
}

TEST(TriangulateRegion, NamesEdgesWithTheRegionToTheirRight) {
  const Outline nested = Outline().loop(rectangle(0, 0, 4, 4)).loop(rectangle(1, 1, 2, 2));
  const RegionTriangulation r = triangulated(nested);
  EXPECT_EQ(r.contradicting_edges, (Numbers{4, 5, 6, 7}));
  EXPECT_TRUE(r.triangles.empty());
}

TEST(TriangulateRegion, NamesEdgesOfOpenChains) {
  Outline o = Outline().loop(rectangle(0, 0, 4, 4));
  o.points.insert(o.points.end(), {{1, 1}, {2, 2}});
  o.edges.push_back({4, 5});
  EXPECT_EQ(triangulated(o).contradicting_edges, (Numbers{4}));
  o = Outline().loop(rectangle(0, 0, 4, 4));
  o.edges.pop_back();
  EXPECT_EQ(triangulated(o).contradicting_edges, (Numbers{0, 1, 2}));
}

TEST(TriangulateRegion, NamesEdgesOfALine) {
  const Outline o{{{0, 0}, {1, 0}, {2, 0}}, {{0, 1}, {1, 2}, {2, 1}}};
  EXPECT_EQ(triangulated(o).contradicting_edges, (Numbers{0, 1, 2}));
}

TEST(TriangulateRegion, HasNothingToDoWithoutEdges) {
  EXPECT_TRUE(triangulate_region({}, {}).triangles.empty());
  EXPECT_TRUE(triangulate_region({}, {}).contradicting_edges.empty());
}

TEST(TriangulateRegion, RefusesEdgesThatCross) {
  EXPECT_THROW(triangulated(Outline().loop({{0, 0}, {1, 1}, {1, 0}, {0, 1}})), InputError);
  EXPECT_THROW(triangulated(Outline().loop({{0, 0}, {2, 0}, {2, 2}, {1, 0}})), InputError);
  EXPECT_THROW(triangulated(Outline().loop({{0, 0}, {2, 0}, {2, 2}, {2, 2}})), InputError);
  EXPECT_THROW(triangulate_region(std::vector<Point2>{{0, 0}}, std::vector<Edge>{{0, 1}}), InputError);
}

TEST(TriangulateRegion, FillsStarsOfAnyShape) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.05, 1);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Point2> outer = ring(0, 0, 1, 3 + trial), inner = ring(0, 0, 0.04, 3 + trial % 7);
    for (Point2& p : outer) {
      const double r = uniform(random);
      p = {r * p.u, r * p.v};
    }
    // A chord between radii of at least 0.05 may come nearer than that to the centre where there are few corners.
    const Outline o = trial < 10 ? Outline().loop(outer) : Outline().loop(outer).hole(inner);
    const RegionTriangulation r = triangulated(o);
    EXPECT_TRUE(r.contradicting_edges.empty());
    EXPECT_STREQ(fault(o.points, o.edges, r.triangles), "");
    EXPECT_NEAR(doubled_area(o.points, r.triangles), doubled_area(o.points, o.edges), 1e-13);
    // Euler: with h holes and n corners there are n + 2 h − 2 triangles.
    EXPECT_EQ(r.triangles.size(), o.points.size() + (trial < 10 ? 0 : 2) - 2);
  }
}

}  // namespace
}  // namespace nearwall::planar

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/planar/region.h"
#include "nearwall/planar/size_field.h"
#include "tests/planar/regions.h"

namespace nearwall::planar {
namespace {

/// Refines, and holds the result against what is promised of any.
RefinedRegion refined(const Outline& o, const SizeFunction& size) {
  const RefinedRegion r = refine_region(o.points, o.edges, size);
  EXPECT_TRUE(std::equal(o.points.begin(), o.points.end(), r.points.begin()));
  EXPECT_STREQ(fault(r.points, o.edges, r.triangles), "");
  const double area = doubled_area(o.points, o.edges);
  EXPECT_NEAR(doubled_area(r.points, r.triangles), area, 1e-12 * std::abs(area));
  return r;
}

RefinedRegion graded(const Outline& o, double largest) {
  return refined(o, GradedSize(o.points, o.edges, {0.3, largest}));
}

double smallest_angle(const RefinedRegion& r) {
  const std::vector<double> angles = smallest_angles(r.points, r.triangles);
  return *std::min_element(angles.begin(), angles.end());
}

/// Shares of triangles with angles below some degrees.
double share_below(const RefinedRegion& r, double degrees) {
  const std::vector<double> angles = smallest_angles(r.points, r.triangles);
  const auto n = std::count_if(angles.begin(), angles.end(), [&](double a) { return a < degrees; });
  return static_cast<double>(n) / static_cast<double>(angles.size());
}

TEST(RefineRegion, FillsASquareWithTrianglesOfTheSizeAsked) {
  const int n = 40;
  const double size = 1.0 / n;
  const RefinedRegion r = refined(Outline().loop(rectangle(0, 0, 1, 1, n)), [=](const Point2&) { return size; });
  EXPECT_GT(smallest_angle(r), 28);
  EXPECT_LT(share_below(r, 35), 0.01);
  // Equilateral triangles of this size would be 1 / (sqrt(3) / 4 size²); points may be as near as 0.65 of it.
  const double ideal = 4 / std::sqrt(3.0) / (size * size);
  EXPECT_GT(static_cast<double>(r.triangles.size()), 0.8 * ideal);
  EXPECT_LT(static_cast<double>(r.triangles.size()), 1.5 * ideal);
}

TEST(RefineRegion, LeavesHolesAndOtherComponents) {
  const Outline o = Outline()
                        .loop(rectangle(0, 0, 8, 8, 16))
                        .hole(rectangle(1, 1, 7, 7, 16))
                        .loop(rectangle(2, 2, 6, 6, 16))
                        .hole(ring(4, 4, 0.5, 20));
  EXPECT_GT(smallest_angle(graded(o, 1)), 25);
}

TEST(RefineRegion, GradesFromAVeryFineLoopToACoarseBox) {
  // Edges of 1e-4 of the box's.
  const Outline o = Outline().loop(rectangle(-5, -5, 5, 5, 4)).hole(ring(0.1, 0, 0.02, 500));
  const RefinedRegion r = graded(o, 2.5);
  EXPECT_GT(smallest_angle(r), 24);
  EXPECT_LT(share_below(r, 30), 0.01);
  // No edge is much longer or shorter than asked at its middle.
  const GradedSize size(o.points, o.edges, {0.3, 2.5});
  for (const auto& [edge, times] : directed_edges(r.triangles)) {
    if (std::max(edge[0], edge[1]) < o.points.size()) continue;
    const Point2 &a = r.points[edge[0]], &b = r.points[edge[1]];
    const double ratio = std::hypot(b.u - a.u, b.v - a.v) / size({0.5 * (a.u + b.u), 0.5 * (a.v + b.v)});
    EXPECT_GT(ratio, 0.4);
    EXPECT_LT(ratio, 2);
  }
}

TEST(RefineRegion, KeepsSlits) {
  Outline o = Outline().loop(rectangle(0, 0, 4, 4, 8));
  const auto first = static_cast<std::uint32_t>(o.points.size());
  for (std::uint32_t i = 0; i <= 10; ++i) o.points.push_back({1 + 0.2 * i, 1 + 0.1 * i});
  for (std::uint32_t i = first; i < first + 10; ++i) {
    o.edges.push_back({i, i + 1});
    o.edges.push_back({i + 1, i});
  }
  EXPECT_GT(smallest_angle(graded(o, 0.5)), 20);
}

TEST(RefineRegion, EndsAtAcuteCorners) {
  const double degree = M_PI / 180;
  const Outline o = Outline().loop({{0, 0}, {1, 0}, {std::cos(degree), std::sin(degree)}});
  for (const double size : {1.0, 0.01, 0.002}) refined(o, [=](const Point2&) { return size; });
  Outline fine;
  std::vector<Point2> corners;
  for (int i = 0; i < 100; ++i) corners.push_back({0.01 * i, 0});
  for (int i = 100; i > 0; --i) corners.push_back({0.01 * i * std::cos(degree), 0.01 * i * std::sin(degree)});
  graded(fine.loop(corners), 1);
}

TEST(RefineRegion, EndsWithSizesThatAreNotGraded) {
  const Outline o = Outline().loop(rectangle(0, 0, 1, 1)).hole(ring(0.5, 0.5, 0.1, 200));
  for (const double size : {1.0, 0.1, 0.01}) refined(o, [=](const Point2&) { return size; });
  refined(o, [](const Point2& p) { return p.u < 0.37 ? 0.5 : 0.01; });
}

TEST(RefineRegion, AddsNothingWhereSizesAskForNothing) {
  const Outline o = Outline().loop(rectangle(0, 0, 1, 1));
  EXPECT_EQ(refined(o, [](const Point2&) { return 10.0; }).points.size(), 4u);
}

TEST(RefineRegion, KeepsPointsNoEdgeUses) {
  Outline o = Outline().loop(rectangle(0, 0, 1, 1, 4));
  o.points.push_back({0.5, 0.5});
  const RefinedRegion r = graded(o, 1);
  for (const auto& [side, times] : directed_edges(r.triangles)) EXPECT_NE(side[0], 16u);
}

TEST(RefineRegion, GivesTheSameBytesAgainAndAtOtherScales) {
  const Outline o = Outline().loop(rectangle(-5, -5, 5, 5, 4)).hole(ring(0.1, 0, 0.5, 200));
  const RefinedRegion r = graded(o, 2.5), again = graded(o, 2.5);
  EXPECT_EQ(r.points, again.points);
  EXPECT_EQ(r.triangles, again.triangles);
  for (const double scale : {0x1p-70, 0x1p+50}) {
    Outline scaled = o;
    for (Point2& p : scaled.points) p = {scale * p.u, scale * p.v};
    const RefinedRegion s = graded(scaled, 2.5 * scale);
    EXPECT_EQ(s.triangles, r.triangles);
    for (std::size_t i = 0; i < r.points.size(); ++i) {
      EXPECT_EQ(s.points[i], (Point2{scale * r.points[i].u, scale * r.points[i].v}));
    }
  }
}

TEST(RefineRegion, FillsStarsOfAnyShape) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(0.1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Point2> outer = ring(0, 0, 1, 8 + trial);
    for (Point2& p : outer) {
      const double r = uniform(random);
      p = {r * p.u, r * p.v};
    }
    graded(Outline().loop(outer).hole(ring(0, 0, 0.03, 5 + trial % 9)), 0.2);
  }
}

TEST(RefineRegion, RefusesWhatMakesNoSense) {
  const auto one = [](const Point2&) { return 1.0; };
  const Outline crossing = Outline().loop({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  EXPECT_THROW(refine_region(crossing.points, crossing.edges, one), InputError);
  const Outline inverse = Outline().hole(rectangle(0, 0, 1, 1));
  EXPECT_THROW(refine_region(inverse.points, inverse.edges, one), InputError);
  const Outline square = Outline().loop(rectangle(0, 0, 1, 1));
  EXPECT_THROW(refine_region(square.points, square.edges, [](const Point2&) { return 0.0; }), InputError);
  EXPECT_THROW(refine_region(square.points, square.edges, [](const Point2&) { return std::nan(""); }), InputError);
}

}  // namespace
}  // namespace nearwall::planar

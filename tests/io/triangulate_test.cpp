#include "io/triangulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nearwall::io {
namespace {

using testing::ElementsAre;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles triangles_of(const std::vector<Vec3>& corners) {
  Triangles out;
  triangulate(corners, out);
  return out;
}

Vec3 area_of(const std::vector<Vec3>& p, const std::array<std::uint32_t, 3>& t) {
  return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]) * 0.5;
}

/// A star with n tips in the plane z = 0: reflex corners all round.
std::vector<Vec3> star(int n) {
  std::vector<Vec3> p;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = std::numbers::pi * i / n;
    const double r = i % 2 == 0 ? 1.0 : 0.2;
    p.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  return p;
}

TEST(Triangulate, CutsAQuadrilateralAlongTheShorterDiagonal) {
  EXPECT_THAT(triangles_of({{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {1, 1, 0}}),
              ElementsAre(ElementsAre(0, 1, 3), ElementsAre(1, 2, 3)));
  EXPECT_THAT(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}}),
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
}

TEST(Triangulate, KeepsADartUnfolded) {
  // The longer diagonal is the only one inside.
  const std::vector<Vec3> dart = {{0, 0, 0}, {2, -1, 0}, {6, 0, 0}, {2, 1, 0}};
  const std::vector<Vec3> reflex = {{0, 0, 0}, {4, 3, 0}, {1, 0, 0}, {4, -3, 0}};
  for (const auto& t : triangles_of(dart)) EXPECT_GT(area_of(dart, t).z(), 0);
  for (const auto& t : triangles_of(reflex)) EXPECT_LT(area_of(reflex, t).z(), 0);
}

TEST(Triangulate, FillsAStarWithTrianglesThatTurnItsWay) {
  for (const int n : {3, 5, 40}) {
    const auto p = star(n);
    const auto triangles = triangles_of(p);
    ASSERT_EQ(triangles.size(), p.size() - 2);
    double sum = 0;
    for (const auto& t : triangles) {
      EXPECT_GE(area_of(p, t).z(), 0);
      sum += area_of(p, t).z();
    }
    double shoelace = 0;
    for (std::size_t i = 0; i < p.size(); ++i) shoelace += cross(p[i], p[(i + 1) % p.size()]).z() / 2;
    EXPECT_NEAR(sum, shoelace, 1e-12);
  }
}

TEST(Triangulate, GivesTheSameCutsInEveryScaleAndOrderOfAxes) {
  auto p = star(6);
  for (std::size_t i = 0; i < p.size(); ++i) p[i][2] = 0.05 * static_cast<double>(i % 3);
  auto permuted = p;
  for (std::size_t i = 0; i < p.size(); ++i) permuted[i] = Vec3(p[i].z(), p[i].x(), p[i].y()) * 0x1p-40;
  EXPECT_EQ(triangles_of(p), triangles_of(permuted));
}

TEST(Triangulate, ReturnsAsManyTrianglesForPolygonsWithoutArea) {
  EXPECT_EQ(triangles_of(std::vector<Vec3>(7, Vec3(1, 2, 3))).size(), 5u);
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).size(), 3u);
}

}  // namespace
}  // namespace nearwall::io

#include "layers/corner_polygon.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "nearwall/geometry/angles.h"

namespace nearwall::layers {
namespace {

double determinant(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(cross(a, b), c); }

const Vec3& corner(const std::vector<Vec3>& loop, const CornerFilling& filling, std::uint32_t i) {
  return i < loop.size() ? loop[i] : filling.centre;
}

/// Area of the spherical triangle of three unit vectors (van Oosterom and Strackee 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 2 * std::atan2(determinant(a, b, c), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

double smallest(const std::vector<Vec3>& loop, const CornerFilling& filling) {
  double least = 2;
  for (const auto& [a, b, c] : filling.triangles) {
    least = std::min(least, determinant(corner(loop, filling, a), corner(loop, filling, b), corner(loop, filling, c)));
  }
  return least;
}

/// A loop of n directions at the angle `opening` from z, every second one at `inner`.
std::vector<Vec3> star(int n, double opening, double inner) {
  std::vector<Vec3> loop;
  for (int i = 0; i < n; ++i) {
    const double lean = i % 2 == 0 ? opening : inner, at = 2 * geometry::kPi * i / n;
    loop.push_back(normalized(Vec3(std::sin(lean) * std::cos(at), std::sin(lean) * std::sin(at), std::cos(lean))));
  }
  return loop;
}

TEST(FillCorner, TakesTheMiddlesOfTheEdgesOfACube) {
  const double s = std::sqrt(0.5);
  const std::vector<Vec3> loop = {{1, 0, 0}, {s, s, 0}, {0, 1, 0}, {0, s, s}, {0, 0, 1}, {s, 0, s}};
  const CornerFilling filling = fill_corner(loop);
  ASSERT_EQ(filling.triangles.size(), 4u);
  EXPECT_FALSE(filling.has_centre);
  EXPECT_NEAR(smallest(loop, filling), 0.5, 1e-12);
  // The triangle of the three middles; the others cut off a face each.
  EXPECT_TRUE(std::any_of(filling.triangles.begin(), filling.triangles.end(), [](auto t) {
    std::sort(t.begin(), t.end());
    return t == std::array<std::uint32_t, 3>{1, 3, 5};
  }));
}

TEST(FillCorner, CoversTheLoopOnce) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> lean(0.2, 1.2);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 3 + trial % 20;
    std::vector<Vec3> loop;
    for (int i = 0; i < n; ++i) {
      const double a = lean(random), at = 2 * geometry::kPi * i / n;
      loop.push_back(normalized(Vec3(std::sin(a) * std::cos(at), std::sin(a) * std::sin(at), std::cos(a))));
    }
    // Seen from the loop's middle every side turns left, so the sum over its sides is its area.
    double area = 0, filled = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) area += solid_angle(loop[i], loop[(i + 1) % loop.size()], {0, 0, 1});
    const CornerFilling filling = fill_corner(loop);
    ASSERT_TRUE(filling.exists());
    for (const auto& [a, b, c] : filling.triangles) {
      filled += solid_angle(corner(loop, filling, a), corner(loop, filling, b), corner(loop, filling, c));
    }
    EXPECT_NEAR(filled, area, 1e-9) << trial;
    EXPECT_GT(smallest(loop, filling), 0) << trial;
    EXPECT_EQ(filling.triangles.size(), filling.has_centre ? loop.size() : loop.size() - 2);
  }
}

TEST(FillCorner, PutsALineInTheMiddleWhereThatIsBetter) {
  const auto ring = star(12, 1.0, 1.0);
  const CornerFilling of_ring = fill_corner(ring);
  ASSERT_TRUE(of_ring.has_centre) << "triangles among twelve directions on a circle are flat";
  EXPECT_NEAR(of_ring.centre.z(), 1, 1e-12);
}

TEST(FillCorner, LeavesLoopsOfVeryManyLines) {
  EXPECT_EQ(fill_corner(star(256, 1.0, 1.0)).triangles.size(), 256u);
  EXPECT_FALSE(fill_corner(star(300, 1.0, 1.0)).exists());
}

TEST(FillCorner, FindsNoneForALoopThatGoesRoundTwice) {
  // Each side turns left about the middle: it is the crossings that tell.
  std::vector<Vec3> loop;
  for (int i = 0; i < 24; ++i) {
    const double lean = 0.6 + 0.02 * i, at = 4 * geometry::kPi * i / 24;
    loop.push_back(Vec3(std::sin(lean) * std::cos(at), std::sin(lean) * std::sin(at), std::cos(lean)));
  }
  EXPECT_FALSE(fill_corner(loop).exists());
}

TEST(FillCorner, FillsMoreThanAHemisphereWhereTheLoopSaysSo) {
  auto loop = star(6, 1.0, 1.0);
  std::reverse(loop.begin(), loop.end());
  const CornerFilling filling = fill_corner(loop);
  ASSERT_TRUE(filling.has_centre);
  EXPECT_NEAR(filling.centre.z(), -1, 1e-12);
  EXPECT_GT(smallest(loop, filling), 0);
}

TEST(FillCorner, FindsNoneWhereTheLoopCrossesItself) {
  std::vector<Vec3> loop = {{1, 0, 1}, {-1, 0.1, 1}, {0, 1, 1}, {0.1, -1, 1}};
  for (Vec3& d : loop) d = normalized(d);
  EXPECT_FALSE(fill_corner(loop).exists());
}

}  // namespace
}  // namespace nearwall::layers

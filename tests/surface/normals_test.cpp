#include "nearwall/surface/normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"

namespace nearwall::surface {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

TEST(MostVisibleNormal, LooksAlongTheDiagonalOfACubesCorner) {
  const auto normal = most_visible_normal(std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  ASSERT_TRUE(normal);
  EXPECT_NEAR(geometry::to_degrees(normal->max_angle), 54.735610317245346, 1e-13);
  EXPECT_NEAR(distance(normal->direction, Vec3(1, 1, 1) / std::sqrt(3.0)), 0, 1e-15);
}

TEST(MostVisibleNormal, IsNoneForARegularTetrahedron) {
  EXPECT_FALSE(most_visible_normal(std::vector<Vec3>{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}));
}

TEST(MostVisibleNormal, IsNoneWithoutNormals) {
  EXPECT_FALSE(most_visible_normal({}));
  EXPECT_FALSE(most_visible_normal(std::vector<Vec3>{{0, 0, 0}}));
}

}  // namespace
}  // namespace nearwall::surface

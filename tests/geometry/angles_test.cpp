#include "nearwall/geometry/angles.h"

#include <cmath>

#include <gtest/gtest.h>

namespace nearwall::geometry {
namespace {

TEST(AngleBetween, KeepsItsDigitsNearZeroAndPi) {
  const double tiny = 1e-9;
  EXPECT_NEAR(angle_between({1, 0, 0}, {std::cos(tiny), std::sin(tiny), 0}), tiny, 1e-24);
  EXPECT_NEAR(kPi - angle_between({1, 0, 0}, {-1, 1e-9, 0}), 1e-9, 1e-15);
}

TEST(AngleBetween, DoesNotDependOnLengths) { EXPECT_DOUBLE_EQ(angle_between({3, 0, 0}, {0, 0.001, 0}), kPi / 2); }

TEST(CornerAngle, OfEquilateralTriangleIsSixtyDegrees) {
  EXPECT_NEAR(corner_angle({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(3.0) / 2, 0}), kPi / 3, 1e-15);
}

TEST(EdgeTurn, IsPositiveOverAConvexEdge) {
  // Edge of a box along y, its left face on top (seen from outside), its right face on the side towards +x.
  EXPECT_NEAR(edge_turn({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), kPi / 2, 1e-15);
}

TEST(EdgeTurn, IsNegativeOverAConcaveEdge) {
  // Floor on the left, a wall that rises on the right and faces back over the floor.
  EXPECT_NEAR(edge_turn({0, 0, 1}, {-1, 0, 0}, {0, 1, 0}), -kPi / 2, 1e-15);
}

TEST(EdgeTurn, IsTheSameFromBothHalfedges) {
  const Vec3 left = normalized({0.3, 0.1, 1}), right = normalized({0.9, -0.1, 0.4});
  const Vec3 along = cross(left, right);
  EXPECT_DOUBLE_EQ(edge_turn(left, right, along), edge_turn(right, left, -along));
}

TEST(Slerp, MovesAtConstantAngle) {
  const Vec3 a{1, 0, 0}, b = normalized({1, 2, 3});
  const double whole = angle_between(a, b);
  for (const double t : {0.0, 0.25, 0.5, 1.0}) EXPECT_NEAR(angle_between(a, slerp(a, b, t)), t * whole, 1e-15);
}

}  // namespace
}  // namespace nearwall::geometry

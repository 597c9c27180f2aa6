#include "layers/crossing.h"

#include <gtest/gtest.h>

namespace nearwall::layers {
namespace {

using Triangle = std::array<Vec3, 3>;
using Corners = std::array<char, 3>;

const Triangle kLong = {Vec3{0, 0, 0}, Vec3{100, 0, 0}, Vec3{100, 10, 0}};

TEST(BearingCorners, AreThoseNearTheCrossing) {
  // A small triangle upright in the long one, near its first corner: λ = (0.9, …) there.
  const Triangle near = {Vec3{10, 0.4, -1}, Vec3{10, 0.6, -1}, Vec3{10, 0.5, 1}};
  EXPECT_EQ(bearing_corners(kLong, near), (Corners{1, 0, 0}));
  // In its middle all three bear.
  const Triangle middle = {Vec3{66, 3, -1}, Vec3{66, 4, -1}, Vec3{66, 3.5, 1}};
  EXPECT_EQ(bearing_corners(kLong, middle), (Corners{1, 1, 1}));
  // Half-way on the side between the last two.
  const Triangle side = {Vec3{99, 4, -1}, Vec3{99, 6, -1}, Vec3{99, 5, 1}};
  EXPECT_EQ(bearing_corners(kLong, side), (Corners{0, 1, 1}));
}

TEST(BearingCorners, SeeBothEndsOfACrossing) {
  // A wall across the long triangle: its edges cross it, none of its own.
  const Triangle wall = {Vec3{10, -50, -50}, Vec3{10, 50, -50}, Vec3{10, 0, 100}};
  EXPECT_EQ(bearing_corners(kLong, wall), (Corners{1, 0, 0}));
  // Seen from the wall, the crossing is in its middle.
  EXPECT_EQ(bearing_corners(wall, kLong), (Corners{1, 1, 1}));
}

TEST(BearingCorners, AreNoneWithoutACrossing) {
  const Triangle above = {Vec3{10, 0.4, 1}, Vec3{10, 0.6, 1}, Vec3{10, 0.5, 2}};
  EXPECT_EQ(bearing_corners(kLong, above), Corners{});
  const Triangle aside = {Vec3{10, 40, -1}, Vec3{10, 60, -1}, Vec3{10, 50, 1}};
  EXPECT_EQ(bearing_corners(kLong, aside), Corners{});
  EXPECT_EQ(bearing_corners(kLong, kLong), Corners{}) << "in one plane";
}

}  // namespace
}  // namespace nearwall::layers

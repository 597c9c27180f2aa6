#include "nearwall/geometry/box.h"

#include <vector>

#include <gtest/gtest.h>

namespace nearwall::geometry {
namespace {

TEST(Box, IsEmptyWhenMade) {
  EXPECT_TRUE(Box().is_empty());
  EXPECT_EQ(Box().diagonal(), 0);
}

TEST(Box, HoldsItsPointsAndTouchesItsNeighbours) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 2, 2}};
  const Box box = bounding_box(points);
  EXPECT_EQ(box.diagonal(), 3);
  EXPECT_EQ(box.centre(), Vec3(0.5, 1, 1));
  EXPECT_TRUE(box.contains({1, 0, 2}));
  EXPECT_FALSE(box.contains({1, 0, 2.5}));
  EXPECT_TRUE(box.intersects({{1, 2, 2}, {5, 5, 5}}));
  EXPECT_FALSE(box.intersects({{1.5, 0, 0}, {5, 5, 5}}));
}

}  // namespace
}  // namespace nearwall::geometry

#include "nearwall/search/point_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "nearwall/core/errors.h"

namespace nearwall::search {
namespace {

TEST(PointTree, FindsWhatASearchThroughAllFinds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(x, y, z);
    if (i % 5 == 0) points.push_back(points.back());  // equal points are found both
  }
  const PointTree tree(points);
  for (const double radius : {0.0, 0.01, 0.1, 0.5}) {
    for (std::uint32_t i = 0; i < points.size(); i += 31) {
      const Vec3 place = radius == 0 ? points[i] : points[i] + Vec3(0.003, -0.002, 0.001);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t k = 0; k < points.size(); ++k) {
        if (distance(points[k], place) <= radius) expected.push_back(k);
      }
      EXPECT_EQ(tree.within(place, radius), expected);
    }
  }
}

TEST(PointTree, MayBeEmpty) { EXPECT_TRUE(PointTree({}).within({0, 0, 0}, 1).empty()); }

TEST(PointTree, RefusesWhatIsNotFinite) {
  const std::vector<Vec3> points = {{0, std::numeric_limits<double>::quiet_NaN(), 0}};
  EXPECT_THROW(PointTree{points}, InputError);
}

}  // namespace
}  // namespace nearwall::search

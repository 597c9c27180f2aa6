#include "nearwall/core/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace nearwall {
namespace {

TEST(Sum3, IsTheSameInEveryOrder) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  std::uniform_int_distribution<int> exponent(-60, 60);
  for (int trial = 0; trial < 10000; ++trial) {
    std::array<double, 3> v{};
    for (double& x : v) x = std::ldexp(u(random), exponent(random));
    std::sort(v.begin(), v.end());
    const double sum = sum3(v[0], v[1], v[2]);
    do {
      EXPECT_EQ(sum3(v[0], v[1], v[2]), sum);
    } while (std::next_permutation(v.begin(), v.end()));
  }
}

TEST(Sum3, KeepsWhatIsNotANumber) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  for (const double a : {0.0, 1.0, -kInfinity, kInfinity}) {
    for (const double b : {0.0, -2.0, kInfinity}) {
      EXPECT_TRUE(std::isnan(sum3(kNan, a, b)));
      EXPECT_TRUE(std::isnan(sum3(a, kNan, b)));
      EXPECT_TRUE(std::isnan(sum3(a, b, kNan)));
    }
  }
  static_assert(sum3(3, -1, 2) == 4);
}

TEST(Normalized, HasLengthOneAtAnyScale) {
  for (const double scale : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    const Vec3 n = normalized(Vec3(1, 2, 2) * scale);
    EXPECT_NEAR(norm(n), 1.0, 1e-15);
    EXPECT_NEAR(n.x(), 1.0 / 3, 1e-15);
  }
}

TEST(Normalized, IsTheSameBitForBitAfterScalingByPowersOfTwo) {
  const Vec3 v(0.1, -0.7, 0.3);
  EXPECT_EQ(normalized(v), normalized(v * 1024));
  EXPECT_EQ(normalized(v), normalized(v / 4096));
}

TEST(Normalized, LeavesTheZeroVectorAlone) { EXPECT_EQ(normalized({0, 0, 0}), Vec3(0, 0, 0)); }

TEST(Cross, FollowsTheRightHandRule) { EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), Vec3(0, 0, 1)); }

TEST(MaxNorm, IsTheLargestComponentBySize) { EXPECT_EQ(max_norm({1, -5, 3}), 5); }

}  // namespace
}  // namespace nearwall

#include "nearwall/predicates/patch_side.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "nearwall/core/errors.h"

namespace nearwall::predicates {
namespace {

/// z = x y over the unit square.
const Vec3 kA(0, 0, 0), kB(1, 0, 0), kC(1, 1, 1), kD(0, 1, 0);

TEST(PatchSide, IsThatOfASaddleThatIsKnown) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    const double low = std::max(0.0, x + y - 1), high = std::min(x, y);
    const double z = low + (high - low) * coordinate(random);
    if (std::abs(z - x * y) < 1e-12) continue;
    // The edge a c runs above the saddle, b d below it.
    const Sign expected = z > x * y ? Sign::Positive : Sign::Negative;
    EXPECT_EQ(patch_side(kA, kB, kC, kD, {x, y, z}), expected);
    EXPECT_EQ(patch_side(kC, kB, kA, kD, {x, y, z}), expected) << "either cycle";
    EXPECT_NE(patch_side(kB, kC, kD, kA, {x, y, z}), expected) << "the other edge";
  }
}

TEST(PatchSide, IsExactOnTheSaddleAndNextToIt) {
  for (int i = 0; i <= 16; ++i) {
    for (int j = 1; j < 16; ++j) {
      const double x = i / 16.0, y = j / 16.0, z = x * y;  // exact
      EXPECT_EQ(patch_side(kA, kB, kC, kD, {x, y, z}), Sign::Zero);
      if (i == 0 || i == 16) continue;
      const double infinity = std::numeric_limits<double>::infinity();
      EXPECT_EQ(patch_side(kA, kB, kC, kD, {x, y, std::nextafter(z, infinity)}), Sign::Positive);
      EXPECT_EQ(patch_side(kA, kB, kC, kD, {x, y, std::nextafter(z, -infinity)}), Sign::Negative);
    }
  }
}

TEST(PatchSide, RefusesWhatIsNotFinite) {
  EXPECT_THROW(patch_side(kA, kB, kC, kD, {0, std::numeric_limits<double>::quiet_NaN(), 0}), InputError);
}

}  // namespace
}  // namespace nearwall::predicates

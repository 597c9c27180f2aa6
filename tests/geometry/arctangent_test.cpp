#include "nearwall/geometry/arctangent.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace nearwall::geometry {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(AngleFrom, IsTheArctangentToItsLastDigits) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 2'000'000; ++trial) {
    const double turn = kPi * static_cast<double>(random() >> 11) * 0x1p-53;
    const double shrunk = trial % 2 == 0 ? turn : turn * std::pow(2.0, -static_cast<int>(random() % 60));
    const double sine = std::sin(shrunk), cosine = std::cos(shrunk);
    const long double exact = std::atan2(static_cast<long double>(sine), static_cast<long double>(cosine));
    ASSERT_LE(std::abs(static_cast<long double>(angle_from(sine, cosine)) - exact), 4e-16L * exact) << shrunk;
  }
}

TEST(AngleFrom, KnowsItsEnds) {
  EXPECT_EQ(angle_from(0, 0), 0);
  EXPECT_EQ(angle_from(0, 2), 0);
  EXPECT_EQ(angle_from(0, -2), kPi);
  EXPECT_EQ(angle_from(3, 0), kPi / 2);
  EXPECT_EQ(angle_from(5, 5), kPi / 4);
  EXPECT_DOUBLE_EQ(angle_from(1e-300, 1), 1e-300);
  EXPECT_DOUBLE_EQ(angle_from(1, 1e-300), kPi / 2);
}

TEST(AngleFrom, KeepsWhatIsNotANumber) {
  const double nan = std::nan("");
  for (const double angle : {angle_from(nan, 1), angle_from(1, nan), angle_from(nan, nan), angle_of_chord(nan)}) {
    EXPECT_TRUE(std::isnan(angle));
  }
}

TEST(AngleFrom, GrowsWhereItsPiecesMeet) {
  for (const double tangent : {std::tan(kPi / 8), 1.0}) {
    double before = 0;
    for (int step = -1000; step <= 1000; ++step) {
      const double angle = angle_from(tangent * (1 + step * 0x1p-50), 1);
      EXPECT_GE(angle, before * (1 - 0x1p-52));
      before = angle;
    }
  }
}

TEST(AngleOfChord, IsTheAngleBetweenUnitVectors) {
  for (const double angle : {0.0, 1e-12, 0.3, kPi / 2, 3.0}) {
    const double squared_chord = 4 * std::sin(angle / 2) * std::sin(angle / 2);
    EXPECT_NEAR(angle_of_chord(squared_chord), angle, 1e-14 * angle);
  }
  EXPECT_EQ(angle_of_chord(4.0), kPi);
  EXPECT_EQ(angle_of_chord(4.0 + 0x1p-50), kPi);
}

}  // namespace
}  // namespace nearwall::geometry

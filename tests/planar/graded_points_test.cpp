#include "nearwall/planar/graded_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"

namespace nearwall::planar {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

std::vector<double> pieces(double length, const std::vector<double>& places) {
  std::vector<double> result;
  double last = 0;
  for (const double s : places) {
    result.push_back(s - last);
    last = s;
  }
  result.push_back(length - last);
  return result;
}

TEST(GradedPoints, CutsEvenlyWhereSizesAreTheSame) {
  const std::vector<double> places = graded_points(2, 0.25, 0.25, 0, kUnbounded);
  ASSERT_EQ(places.size(), 7u);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_DOUBLE_EQ(places[i], 0.25 * static_cast<double>(i + 1));
}

TEST(GradedPoints, AddsNoneWhereSizesExceedTheLength) { EXPECT_TRUE(graded_points(1, 3, 5, 0.3, kUnbounded).empty()); }

TEST(GradedPoints, BeginsAndEndsWithTheSizesAsked) {
  const double length = 10, first = 1e-4, last = 1e-2;
  const std::vector<double> p = pieces(length, graded_points(length, first, last, 0.3, 0.5));
  // A piece is the integral of a size that grows along it: no less than at its finer end, no more than e^growth of it;
  // half a piece more or less makes no difference among so many.
  EXPECT_GT(p.front(), 0.95 * first);
  EXPECT_LT(p.front(), std::exp(0.35) * first);
  EXPECT_GT(p.back(), 0.95 * last);
  EXPECT_LT(p.back(), std::exp(0.35) * last);
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    largest = std::max(largest, p[i]);
    if (i == 0) continue;
    EXPECT_LT(std::abs(std::log(p[i] / p[i - 1])), 0.33);
  }
  EXPECT_GT(largest, 0.45);
  EXPECT_LT(largest, 0.55);
}

TEST(GradedPoints, MirrorsWhenEndsAreExchanged) {
  for (const double end : {0.01, 0.02, 0.3, 7.0}) {
    const double length = 3;
    const std::vector<double> there = graded_points(length, 0.02, end, 0.25, 0.4);
    const std::vector<double> back = graded_points(length, end, 0.02, 0.25, 0.4);
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
      EXPECT_NEAR(there[i], length - back[back.size() - 1 - i], 1e-14 * length);
    }
  }
}

TEST(GradedPoints, ScalesByPowersOfTwoExactly) {
  const std::vector<double> ones = graded_points(3, 0.02, 0.1, 0.25, 0.4);
  const double scale = 0x1p-40;
  const std::vector<double> small = graded_points(3 * scale, 0.02 * scale, 0.1 * scale, 0.25, 0.4 * scale);
  ASSERT_EQ(ones.size(), small.size());
  for (std::size_t i = 0; i < ones.size(); ++i) EXPECT_EQ(small[i], scale * ones[i]);
}

TEST(GradedPoints, AreStrictlyAscendingInsideWhateverTheSizes) {
  for (const double begin : {1e-5, 1e-2, 1.0, 50.0}) {
    for (const double end : {1e-5, 1e-2, 1.0, 50.0}) {
      for (const double growth : {0.0, 1e-3, 0.3, 2.0}) {
        if (growth < 0.1 && std::min(begin, end) < 1e-3) continue;
        for (const double largest : {0.1, 2.0, kUnbounded}) {
          for (const double piece : pieces(1, graded_points(1, begin, end, growth, largest))) EXPECT_GT(piece, 0);
        }
      }
    }
  }
}

TEST(GradedPoints, RefusesWhatMakesNoSense) {
  EXPECT_THROW(graded_points(0, 1, 1, 0.3, 1), InputError);
  EXPECT_THROW(graded_points(1, 0, 1, 0.3, 1), InputError);
  EXPECT_THROW(graded_points(1, 1, -1, 0.3, 1), InputError);
  EXPECT_THROW(graded_points(1, 1, 1, -0.3, 1), InputError);
  EXPECT_THROW(graded_points(1, 1, 1, 0.3, 0), InputError);
  EXPECT_THROW(graded_points(kUnbounded, 1, 1, 0.3, 1), InputError);
  EXPECT_THROW(graded_points(1, 1e-300, 1e-300, 0, 1), InputError);
  EXPECT_THROW(graded_points(1, std::nan(""), 1, 0.3, 1), InputError);
}

}  // namespace
}  // namespace nearwall::planar

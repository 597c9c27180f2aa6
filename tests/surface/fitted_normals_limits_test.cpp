#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "nearwall/surface/fitted_normals.h"
#include "tests/surface/fits.h"

namespace nearwall::surface {
namespace {

using fans::Random;

TEST(FittedNormal, GivesNothingWhereTheFitIsOpen) {
  const Vec3 z(0, 0, 1);
  const std::vector<Vec3> line = {{1, 2, 0}, {2, 4, 1}, {-1, -2, 3}, {0.5, 1, 0}, {-3, -6, 0}, {4, 8, 2}, {5, 10, 0}};
  const std::vector<Vec3> cross_of_lines = {{1, 0, 0}, {2, 0, 1}, {-1, 0, 3}, {0, 1, 0}, {0, -3, 0}, {0, 4, 2}};
  const std::vector<Vec3> on_each_other = {{1, 0, 0}, {0, 1, 0}, {-1, 0.2, 0}, {-1, 0.2, 1}, {0.3, -1, 0}};
  for (const Fit fit : kFits) {
    const bool is_quadratic = fit == Fit::QuadraticLeastSquares || fit == Fit::RenkaCline;
    const bool interpolates = fit == Fit::Hardy || fit == Fit::ThinPlate;
    EXPECT_FALSE(fitted_normal(fit, {}, z, {})) << name(fit);
    EXPECT_FALSE(fitted_normal(fit, {}, z, std::vector<Vec3>{{1, 0, 0}})) << name(fit);
    EXPECT_EQ(fitted_normal(fit, {}, z, std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}).has_value(),
              !is_quadratic)
        << name(fit);
    EXPECT_EQ(fitted_normal(fit, {}, z, line).has_value(), fit == Fit::Shepard) << name(fit);
    EXPECT_EQ(fitted_normal(fit, {}, z, cross_of_lines).has_value(), !is_quadratic) << name(fit);
    EXPECT_EQ(fitted_normal(fit, {}, z, on_each_other).has_value(), !interpolates && !is_quadratic) << name(fit);
    EXPECT_FALSE(fitted_normal(fit, {}, {}, cross_of_lines)) << name(fit) << " without an axis";
    EXPECT_FALSE(fitted_normal(fit, {}, {0, 0, std::numeric_limits<double>::quiet_NaN()}, cross_of_lines));
    EXPECT_FALSE(fitted_normal(fit, {std::numeric_limits<double>::infinity(), 0, 0}, z, cross_of_lines));
    EXPECT_FALSE(fitted_normal(fit, {}, z, std::vector<Vec3>(8, Vec3{}))) << name(fit) << " in one point";
    EXPECT_FALSE(fitted_normal(fit, {}, z, std::vector<Vec3>(8, Vec3(0, 0, 1)))) << name(fit) << " along the axis";
  }
  for (const Fit fit : {Fit::RenkaCline, Fit::Shepard, Fit::Hardy, Fit::ThinPlate}) {
    const std::vector<Vec3> above = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 2, 0}, {2, 1, 0}};
    EXPECT_FALSE(fitted_normal(fit, {}, z, above)) << name(fit) << " with a neighbour above the point";
  }
}

TEST(FittedNormal, GivesNothingOnALineWhosePointsAreRounded) {
  // Slopes to the point of 2 but for the last bit: the line's width is rounding, and so is any slope across it.
  const Vec3 point(0.06819950140572642, -1.2356175815256973, -0.6785197133775542);
  const std::vector<Vec3> on_a_line = {{-0.6595460021601132, -2.6911085886573765, -0.9298531875180229},
                                       {1.1652332924046929, 0.9584500004722356, -0.29964919808028684},
                                       {-1.7147888540554157, -4.801594292447982, -1.2942908250289606}};
  Random random(14);
  for (const Fit fit : kFits) {
    if (fit == Fit::Shepard) continue;
    EXPECT_FALSE(fitted_normal(fit, point, {0, 0, 1}, on_a_line)) << name(fit);
    for (int trial = 0; trial < 200; ++trial) {
      const Vec3 start = random.direction(), along = random.direction(), axis = random.direction();
      std::vector<Vec3> neighbours;
      for (int k = 0; k < 7; ++k) neighbours.push_back(start + along * random.uniform(-3, 3));
      EXPECT_FALSE(fitted_normal(fit, start, axis, neighbours)) << name(fit) << " " << trial;
    }
  }
}

TEST(FittedNormal, GivesNothingWhereTheFitIsOpenButForRounding) {
  Random random(13);
  for (int trial = 0; trial < 50; ++trial) {
    Scattered scattered(random, 16);
    for (auto& [x, y] : scattered.at) y = 0.5 * x + random.uniform(-1e-11, 1e-11);
    scattered.lift(wave);
    for (const Fit fit : {Fit::LinearLeastSquares, Fit::QuadraticLeastSquares, Fit::RenkaCline}) {
      EXPECT_FALSE(fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours)) << name(fit);
    }
    Scattered folded(random, 12);
    folded.at.push_back({folded.at[3][0] + 1e-9, folded.at[3][1]});
    folded.lift([&](double, double) { return random.uniform(-1, 1); });
    for (const Fit fit : {Fit::Hardy, Fit::ThinPlate}) {
      EXPECT_FALSE(fitted_normal(fit, folded.point, folded.axis, folded.neighbours)) << name(fit);
    }
  }
}

TEST(FittedNormal, GrowsSteeperWithTheHeightsWithoutLossOfDigits) {
  Random random(14);
  const Vec3 z(0, 0, 1);
  for (int trial = 0; trial < 50; ++trial) {
    Scattered scattered(random, 14);
    std::vector<Vec3> flat, steep;
    for (const auto& [x, y] : scattered.at) {
      const double height = random.uniform(-1, 1);
      flat.emplace_back(x, y, height), steep.emplace_back(x, y, height * 0x1p16);
    }
    for (const Fit fit : kFits) {
      const auto low = fitted_normal(fit, {}, z, flat), high = fitted_normal(fit, {}, z, steep);
      ASSERT_TRUE(low && high) << name(fit);
      for (const int axis : {0, 1}) {
        const double slope = (*low)[axis] / low->z() * 0x1p16;
        EXPECT_NEAR((*high)[axis] / high->z(), slope, 1e-14 * std::abs(slope)) << name(fit);
      }
    }
  }
}

TEST(FittedNormal, IsAUnitVectorOnTheAxisSideOrNothingAsNeighboursMeet) {
  Random random(8);
  for (int exponent = 0; exponent < 80; ++exponent) {
    Scattered scattered(random, 12);
    const double gap = std::ldexp(0.2, -exponent);
    scattered.at.push_back({scattered.at[0][0] + gap, scattered.at[0][1]});
    scattered.at.push_back({0, gap});
    scattered.lift([&](double, double) { return random.uniform(-1, 1); });
    for (const Fit fit : kFits) {
      const auto normal = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      if (!normal) continue;
      EXPECT_NEAR(norm(*normal), 1, 1e-14) << name(fit);
      EXPECT_GT(dot(*normal, scattered.axis), 0) << name(fit);
    }
  }
}

TEST(FittedNormal, IsExactInNarrowNeighbourhoods) {
  Random random(9);
  for (const double width : {1e-2, 1e-4}) {
    Scattered scattered(random, 18);
    for (auto& at : scattered.at) at[1] *= width;
    scattered.lift([](double x, double y) { return 0.3 * x - 0.2 * y; });
    for (const Fit fit : kFits) {
      if (fit == Fit::Shepard) continue;
      const auto normal = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      ASSERT_TRUE(normal) << name(fit) << ' ' << width;
      EXPECT_LT(angle(*normal, scattered.normal(0.3, -0.2)), 1e-12 / (width * width)) << name(fit) << ' ' << width;
    }
  }
}

TEST(FittedNormal, LooksAtTheNearestOfVeryManyNeighbours) {
  Random random(10);
  Scattered scattered(random, 100, 0.05);
  scattered.lift(wave);
  std::vector<Vec3> nearest = scattered.neighbours;
  std::sort(nearest.begin(), nearest.end(),
            [&](const Vec3& a, const Vec3& b) { return distance(a, scattered.point) < distance(b, scattered.point); });
  nearest.resize(kMaxFittedNeighbours);
  std::vector<Vec3> in_order;
  for (const Vec3& p : scattered.neighbours) {
    if (std::find(nearest.begin(), nearest.end(), p) != nearest.end()) in_order.push_back(p);
  }
  for (const Fit fit : kFits) {
    EXPECT_EQ(fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours),
              fitted_normal(fit, scattered.point, scattered.axis, in_order))
        << name(fit);
  }
}

}  // namespace
}  // namespace nearwall::surface

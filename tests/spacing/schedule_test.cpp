#include "nearwall/spacing/schedule.h"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"

namespace nearwall::spacing {
namespace {

using testing::HasSubstr;

ScheduleRequest request(std::optional<double> first, std::optional<double> growth, std::optional<int> count,
                        std::optional<double> total, Law law = Law::Geometric) {
  ScheduleRequest r;
  r.law = law;
  r.first_height = first;
  r.growth = growth;
  r.count = count;
  r.total_thickness = total;
  return r;
}

std::string rejection(const ScheduleRequest& r) {
  try {
    solve_schedule(r);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(TotalThickness, IsTheSumOfTheSeries) {
  EXPECT_DOUBLE_EQ(total_thickness(1, 2, 10), 1023);
  EXPECT_NEAR(total_thickness(1, 1.5, 4), 1 + 1.5 + 2.25 + 3.375, 1e-14);
}

TEST(TotalThickness, TendsToUniformStackAsRatioTendsToOne) {
  EXPECT_DOUBLE_EQ(total_thickness(0.25, 1, 40), 10);
  // Series: n h (1 + (n - 1) e / 2 + ...): the closed form in powers would lose eleven digits at e = 1e-11.
  for (double e : {1e-15, 1e-13, 1e-11, 1e-9}) {
    const double r = 1 + e;
    EXPECT_NEAR(total_thickness(1, r, 100), 100 * (1 + 99 * (r - 1) / 2 + 99.0 * 98 * (r - 1) * (r - 1) / 6),
                2e-14 * 100)
        << e;
  }
}

TEST(TotalThickness, RejectsWhatHasNoMeaning) {
  EXPECT_THROW(total_thickness(0, 1.2, 3), InputError);
  EXPECT_THROW(total_thickness(1, 0.9, 3), InputError);
  EXPECT_THROW(total_thickness(1, 1.2, 0), InputError);
}

TEST(GrowthRatio, InvertsTheThickness) {
  for (double r : {1.0, 1 + 1e-12, 1.0001, 1.05, 1.2, 1.5, 1.999}) {
    for (int n : {2, 3, 10, 30, 200}) {
      const double found = growth_ratio(1e-5, n, total_thickness(1e-5, r, n));
      // The thickness of n layers knows r only as well as d(ln T)/dr = (n - 1) / 2 at r = 1 lets it.
      EXPECT_NEAR(found, r, 1e-15 * (2 + 20.0 / (n - 1))) << r << " " << n;
    }
  }
}

TEST(GrowthRatio, ThreeTimesTheFirstHeightInTwoLayersIsTwo) { EXPECT_DOUBLE_EQ(growth_ratio(1, 2, 3), 2); }

TEST(GrowthRatio, SaysWhatToChangeWhereLayersWouldShrink) {
  EXPECT_THAT(rejection(request(1e-3, {}, 30, 0.02)), HasSubstr("lower first_height to 0.000666667"));
}

TEST(GrowthRatio, SaysWhatToChangeWhereLayersWouldExplode) {
  EXPECT_THAT(rejection(request(1e-6, {}, 4, 1.0)), HasSubstr("raise count, raise first_height to 0.0666667"));
}

TEST(SolveSchedule, AnyThreeGiveTheFourth) {
  const double t = total_thickness(1e-4, 1.25, 20);
  for (const auto& r :
       {request(1e-4, 1.25, 20, {}), request(1e-4, 1.25, {}, t), request(1e-4, {}, 20, t), request({}, 1.25, 20, t)}) {
    const Schedule s = solve_schedule(r);
    EXPECT_NEAR(s.first_height, 1e-4, 1e-18);
    EXPECT_NEAR(s.growth, 1.25, 1e-14);
    EXPECT_EQ(s.count, 20);
    EXPECT_NEAR(s.total_thickness, t, 1e-14 * t);
    ASSERT_EQ(s.heights.size(), 20u);
    EXPECT_NEAR(s.heights[19], 1e-4 * std::pow(1.25, 19), 1e-15);
  }
}

TEST(SolveSchedule, TakesDefaultsForWhatIsMissing) {
  EXPECT_DOUBLE_EQ(solve_schedule(request(1, {}, 5, {})).growth, kDefaultGrowth);
  EXPECT_EQ(solve_schedule(request(1, 1.1, {}, {})).count, kDefaultCount);
  const Schedule s = solve_schedule(request({}, {}, {}, 1));
  EXPECT_EQ(s.count, kDefaultCount);
  EXPECT_DOUBLE_EQ(s.growth, kDefaultGrowth);
  EXPECT_NEAR(s.total_thickness, 1, 1e-14);
}

TEST(SolveSchedule, ReachesTheThicknessExactlyWhereTheCountIsSolvedFor) {
  for (double t : {1.0, 1.3, 1.9, 2.05, 7.7, 10.0, 123.4}) {
    const Schedule s = solve_schedule(request(1, 1.2, {}, t));
    EXPECT_NEAR(s.total_thickness, t, 2e-13 * t);
    EXPECT_LE(s.first_height, 1);
    EXPECT_LE(s.growth, 1.2 + 1e-4);
    if (s.count > 1) {
      EXPECT_LT(total_thickness(1, 1.2, s.count - 1), t) << "one layer less is enough";
    }
  }
}

TEST(SolveSchedule, ATypedThicknessDoesNotCostALayer) {
  const double t = total_thickness(1e-5, 1.2, 30);
  EXPECT_EQ(solve_schedule(request(1e-5, 1.2, {}, t * (1 + 5e-5))).count, 30);
}

TEST(SolveSchedule, RejectsTooLittleAndTooMuch) {
  EXPECT_THAT(rejection(request({}, 1.2, 10, {})), HasSubstr("first_height"));
  EXPECT_THAT(rejection(request(1, 1.2, 10, 20)), HasSubstr("leave out one"));
  EXPECT_THAT(rejection(request(1, 1.2, {}, 0.5)), HasSubstr("less than the first layer alone"));
  EXPECT_THAT(rejection(request(1, 1.0, {}, 1e6)), HasSubstr("more than 1000 layers"));
  EXPECT_THAT(rejection(request(-1, 1.2, 10, {})), HasSubstr("first_height: expected a length above 0, found -1"));
  EXPECT_THAT(rejection(request(std::nan(""), 1.2, 10, {})), HasSubstr("first_height"));
  EXPECT_THAT(rejection(request(1, 0.9, 10, {})), HasSubstr("never get thinner"));
  EXPECT_THAT(rejection(request(1, 2.5, 10, {})), HasSubstr("from 1 to 2"));
}

TEST(SolveSchedule, ScalesBitForBitWithPowersOfTwo) {
  for (Law law : {Law::Geometric, Law::Accelerating, Law::Tanh}) {
    const Schedule a = solve_schedule(request(1e-3, {}, 17, 0.37, law));
    const Schedule b = solve_schedule(request(std::ldexp(1e-3, -40), {}, 17, std::ldexp(0.37, -40), law));
    ASSERT_EQ(a.heights.size(), b.heights.size());
    for (std::size_t k = 0; k < a.heights.size(); ++k) EXPECT_EQ(std::ldexp(a.heights[k], -40), b.heights[k]);
    EXPECT_EQ(a.growth, b.growth);
  }
}

TEST(AcceleratingLaw, IsConstantThenRisesFivePercentALayerUpToTheCap) {
  const auto h = layer_heights(request(1, 1.2, 12, {}, Law::Accelerating));
  const std::vector<double> ratios = {1, 1, 1, 1, 1.2, 1.26, 1.323, 1.38915, 1.4586075, 1.5, 1.5};
  for (std::size_t k = 0; k < ratios.size(); ++k) EXPECT_NEAR(h[k + 1] / h[k], ratios[k], 1e-14) << k;
}

TEST(AcceleratingLaw, SolvesForItsGrowth) {
  const double t = solve_schedule(request(1, 1.13, 25, {}, Law::Accelerating)).total_thickness;
  EXPECT_NEAR(solve_schedule(request(1, {}, 25, t, Law::Accelerating)).growth, 1.13, 1e-13);
}

TEST(AcceleratingLaw, RejectsAGrowthAboveItsCap) {
  EXPECT_THAT(rejection(request(1, 1.6, 10, {}, Law::Accelerating)), HasSubstr("above largest_growth"));
}

TEST(TanhLaw, FollowsTheHyperbolicTangent) {
  const Schedule s = solve_schedule(request({}, 1.3, 16, 2.0, Law::Tanh));
  EXPECT_NEAR(s.heights[1] / s.heights[0], 1.3, 1e-13);
  // Vinokur's one-sided function with the stretching that these heights show: x_k = T (1 + tanh(d (k/n - 1)) / tanh d).
  double low = 0, high = 20;
  for (int i = 0; i < 200; ++i) {
    const double d = 0.5 * (low + high);
    (2.0 * (1 + std::tanh(d * (1.0 / 16 - 1)) / std::tanh(d)) > s.first_height ? low : high) = d;
  }
  double x = 0;
  for (int k = 1; k <= 16; ++k) {
    x += s.heights[static_cast<std::size_t>(k - 1)];
    EXPECT_NEAR(x, 2.0 * (1 + std::tanh(low * (k / 16.0 - 1)) / std::tanh(low)), 1e-12) << k;
  }
}

TEST(TanhLaw, IsUniformForGrowthOneAndHasAnyCount) {
  for (double h : layer_heights(request(0.5, 1, 7, {}, Law::Tanh))) EXPECT_DOUBLE_EQ(h, 0.5);
  EXPECT_EQ(layer_heights(request(0.5, 1.2, 1, {}, Law::Tanh)), std::vector<double>{0.5});
  const auto many = layer_heights(request(1e-6, 2, kMaxCount, {}, Law::Tanh));
  EXPECT_NEAR(many[1] / many[0], 2, 1e-12);
  EXPECT_TRUE(std::isfinite(many.back()));
}

TEST(TableLaw, TakesTheHeightsAsTheyAre) {
  ScheduleRequest r;
  r.law = Law::Table;
  r.heights = {1, 1, 3, 2};
  const Schedule s = solve_schedule(r);
  EXPECT_EQ(s.heights, r.heights);
  EXPECT_EQ(s.total_thickness, 7);
  EXPECT_EQ(s.growth, 3);
  EXPECT_EQ(s.count, 4);
}

TEST(TableLaw, TakesNothingElse) {
  ScheduleRequest r;
  r.law = Law::Table;
  EXPECT_THAT(rejection(r), HasSubstr("at least one height"));
  r.heights = {1, 0};
  EXPECT_THAT(rejection(r), HasSubstr("heights: expected a length above 0, found 0"));
  r.heights = {1};
  r.growth = 1.2;
  EXPECT_THAT(rejection(r), HasSubstr("takes heights alone"));
  r.law = Law::Geometric;
  EXPECT_THAT(rejection(r), HasSubstr("are for the law \"table\""));
}

}  // namespace
}  // namespace nearwall::spacing

#include "nearwall/studies/plot.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "studies/plot_axis.h"

namespace nearwall::studies {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Axis, SpansItsValuesBetweenRoundTicks) {
  const Axis axis({-0.3, 7.2}, false);
  EXPECT_EQ(axis.ticks(), (std::vector<double>{-2, 0, 2, 4, 6, 8}));
  EXPECT_DOUBLE_EQ(axis.place(-2), 0);
  EXPECT_DOUBLE_EQ(axis.place(3), 0.5);
  EXPECT_DOUBLE_EQ(axis.place(8), 1);
}

TEST(Axis, GivesEqualRatiosEqualLengthsIfLogarithmic) {
  const Axis axis({1e-5, 0, -1, 10}, true);
  EXPECT_FALSE(axis.can_show(0));
  EXPECT_NEAR(axis.place(1e-5), 0, 1e-12);
  EXPECT_NEAR(axis.place(1e-2), 0.5, 1e-12);
  EXPECT_NEAR(axis.place(10), 1, 1e-12);
}

TEST(Axis, HasTicksWithinDecadesIfTheyAreFew) {
  EXPECT_EQ(Axis({1.3, 16.9}, true).ticks(), (std::vector<double>{1, 2, 5, 10, 20}));
}

TEST(Axis, ShowsASingleValue) {
  const Axis axis({3}, false);
  EXPECT_GT(axis.place(3), 0);
  EXPECT_LT(axis.place(3), 1);
}

TEST(Axis, RefusesNothing) {
  EXPECT_THROW(Axis({}, false), InputError);
  EXPECT_THROW(Axis({-1, 0}, true), InputError);
}

TEST(LinePlot, LeavesOutWhatALogarithmCannotShow) {
  const LinePlot plot{.title = "t",
                      .x_label = "x",
                      .y_label = "y",
                      .is_log_y = true,
                      .series = {{"a", {{1, 0}, {2, 1}, {3, std::nan("")}, {4, 100}}}}};
  const std::string svg = to_svg(plot);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(LinePlot, RefusesPointsOfWhichOneAxisCanShowNone) {
  const double none = std::nan("");
  EXPECT_THROW(
      to_svg(LinePlot{.title = "t", .x_label = "x", .y_label = "y", .series = {{"a", {{1, none}, {none, 1}}}}}),
      InputError);
}

TEST(LinePlot, EscapesTextAndStandsOnWhite) {
  const std::string svg =
      to_svg(LinePlot{.title = "a < b", .x_label = "x", .y_label = "y", .series = {{"p & q", {{0, 0}}}}});
  EXPECT_THAT(svg, HasSubstr("a &lt; b"));
  EXPECT_THAT(svg, HasSubstr("p &amp; q"));
  EXPECT_THAT(svg, HasSubstr("fill='#fff'/>"));
}

TEST(BarPlot, DrawsABarOfEachSeriesInEachGroup) {
  const std::string svg =
      to_svg(BarPlot{.title = "t", .y_label = "y", .groups = {"g", "h"}, .series = {{"a", {1, 2}}, {"b", {4, 0.5}}}});
  std::size_t n = 0;
  for (std::size_t at = svg.find("<rect"); at != std::string::npos; at = svg.find("<rect", at + 1)) ++n;
  EXPECT_EQ(n, 4u + 2u + 2u) << "four bars, two keys, ground and frame";
}

TEST(BarPlot, RefusesNothing) {
  const double none = std::nan("");
  EXPECT_THROW(to_svg(BarPlot{}), InputError);
  EXPECT_THROW(to_svg(BarPlot{.title = "t", .y_label = "y", .series = {{"a", {}}}}), InputError);
  for (const bool is_log : {false, true}) {
    EXPECT_THROW(
        to_svg(BarPlot{.title = "t", .y_label = "y", .is_log_y = is_log, .groups = {"g"}, .series = {{"a", {none}}}}),
        InputError);
  }
}

TEST(BarPlot, RefusesBarsWithoutAGroupAndGroupsWithoutABar) {
  EXPECT_THROW(to_svg(BarPlot{.title = "t", .y_label = "y", .groups = {"g"}, .series = {{"a", {1, 2}}}}), InputError);
  EXPECT_THROW(to_svg(BarPlot{.title = "t", .y_label = "y", .groups = {"g", "h"}, .series = {{"a", {1}}}}), InputError);
}

}  // namespace
}  // namespace nearwall::studies

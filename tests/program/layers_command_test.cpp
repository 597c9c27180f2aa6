#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/program/workplace.h"

namespace nearwall::program {
namespace {

using nlohmann::json;

json calculate(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"layers", "--json"});
  const Outcome outcome = Workplace().run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(LayersCommand, FirstHeightAnswersToYPlusByDefinition) {
  const json result =
      calculate({"--y-plus", "2", "--velocity", "50", "--length", "1", "--kinematic-viscosity", "1e-5"});
  // y+ = y u_tau / nu and c_f = 2 (u_tau / U)^2
  const double friction_velocity = result["friction_velocity"];
  EXPECT_NEAR(result["first_height"].get<double>() * friction_velocity / 1e-5, 2, 1e-12);
  EXPECT_NEAR(result["skin_friction_coefficient"].get<double>(), 2 * std::pow(friction_velocity / 50, 2), 1e-15);
  EXPECT_NEAR(result["reynolds"].get<double>(), 5e6, 1e-6);
}

TEST(LayersCommand, CoversTheBoundaryLayerWhereNothingElseIsAsked) {
  const json result = calculate({"--velocity", "50", "--length", "1"});
  EXPECT_NEAR(result["total_thickness"].get<double>(), result["boundary_layer_thickness"].get<double>(), 1e-12);
}

TEST(LayersCommand, KeepsCountAndGrowth) {
  const json result = calculate({"--velocity", "50", "--length", "1", "--count", "25", "--growth", "1.15"});
  EXPECT_EQ(result["count"], 25);
  EXPECT_DOUBLE_EQ(result["growth"].get<double>(), 1.15);
  const double sum = result["first_height"].get<double>() * (std::pow(1.15, 25) - 1) / 0.15;
  EXPECT_NEAR(result["total_thickness"].get<double>(), sum, 1e-12 * sum);
}

TEST(LayersCommand, TakesViscosityFromDensityToo) {
  const json kinematic = calculate({"--velocity", "3", "--length", "2", "--kinematic-viscosity", "2e-6"});
  const json dynamic =
      calculate({"--velocity", "3", "--length", "2", "--density", "500", "--dynamic-viscosity", "1e-3"});
  EXPECT_DOUBLE_EQ(kinematic["first_height"].get<double>(), dynamic["first_height"].get<double>());
}

TEST(LayersCommand, WantsDensityAndDynamicViscosityTogether) {
  const Outcome outcome = Workplace().run({"layers", "--velocity", "3", "--length", "2", "--density", "998"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, testing::HasSubstr("--dynamic-viscosity"));
}

TEST(LayersCommand, RefusesAVelocityThatIsNotPositive) {
  EXPECT_EQ(Workplace().run({"layers", "--velocity", "-3", "--length", "2"}).exit_code, 2);
  EXPECT_EQ(Workplace().run({"layers", "--velocity", "nan", "--length", "2"}).exit_code, 2);
}

TEST(LayersCommand, PrintsLinesForACaseFile) {
  const Outcome outcome = Workplace().run({"layers", "--velocity", "50", "--length", "1", "--count", "20"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, testing::HasSubstr("first_height = "));
  EXPECT_THAT(outcome.out, testing::HasSubstr("count        = 20"));
}

}  // namespace
}  // namespace nearwall::program

#include "nearwall/spacing/wall_units.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"

namespace nearwall::spacing {
namespace {

TEST(ReynoldsNumber, IsVelocityTimesLengthOverViscosity) { EXPECT_DOUBLE_EQ(reynolds_number({50, 1.5e-5, 3}), 1e7); }

TEST(SkinFriction, AgreesWithTheTabulatedLaw) {
  // (2 * 7 - 0.65)^-2.3 and (2 * 6 - 0.65)^-2.3 by hand through logarithms.
  EXPECT_NEAR(skin_friction_coefficient(1e7), std::exp(-2.3 * std::log(13.35)), 1e-17);
  EXPECT_NEAR(skin_friction_coefficient(1e7), 0.0025787, 5e-8);
  EXPECT_NEAR(skin_friction_coefficient(1e6), 0.003745, 1e-6);
}

TEST(FirstCellHeight, HasTheAskedWallUnits) {
  const FlowConditions flow{50, 1.5e-5, 1};
  const double h = first_cell_height(flow, 1);
  EXPECT_NEAR(h * friction_velocity(flow) / flow.kinematic_viscosity, 1, 1e-15);
  EXPECT_NEAR(h, 7.672e-6, 1e-9);  // c_f = 12.3958^-2.3 = 0.003058, u_tau = 50 sqrt(0.001529) = 1.955
  EXPECT_DOUBLE_EQ(first_cell_height(flow, 30), 30 * h);
}

TEST(FirstCellHeight, IsTheSameFlowInMillimetres) {
  const FlowConditions metres{50, 1.5e-5, 1};
  const FlowConditions millimetres{50e3, 15, 1e3};
  EXPECT_NEAR(first_cell_height(millimetres, 1), 1e3 * first_cell_height(metres, 1), 1e-15);
}

TEST(FirstCellHeight, RejectsWhatIsNoFlow) {
  EXPECT_THROW(first_cell_height({50, 1.5e-5, 1}, 0), InputError);
  EXPECT_THROW(first_cell_height({50, 0, 1}, 1), InputError);
  EXPECT_THROW(first_cell_height({-50, 1.5e-5, 1}, 1), InputError);
  try {
    first_cell_height({1e-4, 1.5e-5, 1}, 1);
    FAIL() << "accepted a Reynolds number of 7";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("check the units"));
  }
}

TEST(BoundaryLayerThickness, FollowsTheOneSeventhPowerLaw) {
  EXPECT_NEAR(boundary_layer_thickness({1, 1e-5, 1}), 0.037, 1e-15);  // Re = 1e5: Re^(1/5) = 10
}

}  // namespace
}  // namespace nearwall::spacing

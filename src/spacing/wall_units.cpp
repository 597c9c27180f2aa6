#include "nearwall/spacing/wall_units.h"

#include <cmath>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::spacing {

namespace {

void expect_positive(double value, const char* name) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw InputError(fmt::format("{}: expected a number above 0, found {}", name, value));
  }
}

}  // namespace

double reynolds_number(const FlowConditions& flow) {
  expect_positive(flow.velocity, "velocity");
  expect_positive(flow.kinematic_viscosity, "kinematic viscosity");
  expect_positive(flow.reference_length, "reference length");
  return flow.velocity * flow.reference_length / flow.kinematic_viscosity;
}

double skin_friction_coefficient(double reynolds) {
  if (!(reynolds >= kLowestReynolds && reynolds <= kHighestReynolds)) {
    throw InputError(fmt::format(
        "Reynolds number: the friction law of a turbulent flat plate holds from {} to {}, found {:.4g}; check "
        "the units of velocity, length and viscosity, or give the first height itself",
        kLowestReynolds, kHighestReynolds, reynolds));
  }
  // Schlichting: c_f = (2 log10 Re - 0.65)^-2.3
  constexpr double kSlope = 2.0;
  constexpr double kOffset = 0.65;
  constexpr double kExponent = -2.3;
  return std::pow(kSlope * std::log10(reynolds) - kOffset, kExponent);
}

double friction_velocity(const FlowConditions& flow) {
  return flow.velocity * std::sqrt(0.5 * skin_friction_coefficient(reynolds_number(flow)));
}

double first_cell_height(const FlowConditions& flow, double y_plus) {
  expect_positive(y_plus, "y_plus");
  return y_plus * flow.kinematic_viscosity / friction_velocity(flow);
}

double boundary_layer_thickness(const FlowConditions& flow) {
  constexpr double kFactor = 0.37;
  constexpr double kExponent = -0.2;
  return kFactor * flow.reference_length * std::pow(reynolds_number(flow), kExponent);
}

}  // namespace nearwall::spacing

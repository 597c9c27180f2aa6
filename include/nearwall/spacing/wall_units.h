#pragma once

namespace nearwall::spacing {

/// The free stream, in any consistent set of units (length, time).
struct FlowConditions {
  double velocity = 0;             ///< [length / time], > 0
  double kinematic_viscosity = 0;  ///< [length² / time], > 0
  double reference_length = 0;     ///< run of the boundary layer [length], > 0
};

/// Velocity * length / viscosity [-]. \throws InputError if a quantity is not positive and finite.
double reynolds_number(const FlowConditions& flow);

/// Local skin friction coefficient of a turbulent boundary layer on a smooth flat plate at the end of the reference
/// length: Schlichting's interpolation, docs/theory/spacing.md, Eq. (8).
/// \throws InputError for Reynolds numbers outside kLowestReynolds … kHighestReynolds.
double skin_friction_coefficient(double reynolds);

inline constexpr double kLowestReynolds = 1e3;
inline constexpr double kHighestReynolds = 1e11;

/// sqrt(wall shear stress / density) [length / time]: U sqrt(c_f / 2). docs/theory/spacing.md, Eq. (9)
double friction_velocity(const FlowConditions& flow);

/// Height of the first layer [length] whose upper node lies at the given y⁺: y⁺ nu / u_tau. docs/theory/spacing.md, Eq.
/// (9) \throws InputError if y_plus or the flow is out of range.
double first_cell_height(const FlowConditions& flow, double y_plus);

/// Thickness of the turbulent boundary layer at the end of the reference length [length]: 0.37 L Re^(-1/5), the
/// one-seventh power law. docs/theory/spacing.md, Eq. (11)
double boundary_layer_thickness(const FlowConditions& flow);

}  // namespace nearwall::spacing

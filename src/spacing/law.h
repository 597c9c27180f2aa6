#pragma once

#include <vector>

#include "nearwall/spacing/schedule.h"

namespace nearwall::spacing {

/// Parameters of Law::Accelerating.
struct Acceleration {
  int constant_layers = 5;
  double rate = 0.05;
  double cap = 1.5;
};

/// Heights of `count` layers in units of the first, for one growth; each grows with `growth` or stays.
/// \returns (count)    Source: docs/theory/spacing.md
std::vector<double> relative_heights(Law law, double growth, int count, const Acceleration& acceleration);

/// Sum of `relative_heights`: thickness over first height.
double relative_thickness(Law law, double growth, int count, const Acceleration& acceleration);

/// The growth with which `count` layers are `ratio` first heights thick, between 1 and kMaxGrowth.
/// \pre relative_thickness at 1 <= ratio <= that at kMaxGrowth (or at the law's cap)
double solve_growth(Law law, int count, double ratio, const Acceleration& acceleration);

/// Largest growth that a law takes.
double largest_growth(Law law, const Acceleration& acceleration);

}  // namespace nearwall::spacing

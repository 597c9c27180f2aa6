#pragma once

#include "studies/jet.h"

namespace nearwall::studies {

inline constexpr int kTestFunctions = 9;

/// The test functions f1 to f9 of Bohdal 2017 on the unit square; where the print is damaged, as in
/// docs/theory/normal-studies.md.
/// \param number  1 to 9
Jet test_function(int number, double x, double y);

}  // namespace nearwall::studies

#pragma once

#include "nearwall/pipeline/case.h"

namespace nearwall::program {

/// Multiplies the lengths of [layers], of the patches' layers and of [volume] (coordinates, too) by the diagonal of the
/// surface's bounding box, in the case's unit: for one case file that suits surfaces of any size.
/// \throws what reading the surface throws
void make_lengths_absolute(Case& settings);

}  // namespace nearwall::program

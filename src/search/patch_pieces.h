#pragma once

#include <array>

#include "nearwall/core/vec3.h"

namespace nearwall::search {

/// Corners of a bilinear patch in the order of its cycle. A triangle has its last corner twice, a segment both ends
/// twice: a, b, b, a.
using PatchCorners = std::array<Vec3, 4>;

/// Whether two patches are proven to have no point in common: both are cut into pieces until planes part the hulls of
/// all pairs of pieces, by more than rounding can have moved them. False where that does not succeed within a bounded
/// number of cuts. Source: docs/theory/certificate.md.
bool are_surely_apart(const PatchCorners& a, const PatchCorners& b);

}  // namespace nearwall::search

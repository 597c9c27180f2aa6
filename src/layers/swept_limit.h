#pragma once

#include <array>

#include "nearwall/core/vec3.h"

namespace nearwall::layers {

/// Share of the closed-form limit that a line may use: the rest is room for the heights of single layers and for cells
/// that are still well shaped at the top.
inline constexpr double kSweptShare = 0.7;

/// Largest t, at most infinity, up to which the wedge swept from the triangle x by x_k + t v_k is positive everywhere;
/// 0 if it is not even at its start. Source: docs/theory/cells.md, thick wedge.
double swept_limit(const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& v);

/// Which share of each of its lines a triangle lets stand. Where two lines cross, the third one keeps its length if the
/// swept wedge stays positive with those two lowered: on a long triangle that ends at a narrow place, the far one.
/// \param limit  swept_limit(x, v)
std::array<double, 3> shares_kept(const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& v, double limit);

}  // namespace nearwall::layers

#pragma once

#include "vertex_field.h"

namespace nearwall::layers {

/// Rounds the bends of lines, so that steps along a line grow but little faster than its heights: from its foot f a
/// line passes through
///     f t + sum over knots k of (c_k - c_{k-1}) t g(t / t_k),   g(x) = (1 + b) x / (x + b) below 1, 1 above,
/// c_k the chord of knot k per thickness, c_0 = f. It ends where it did, at the thickness that the field allows.
/// Source: docs/theory/layers.md, section 3
void round_bends(const VertexField& field, LinePlan& plan);

}  // namespace nearwall::layers

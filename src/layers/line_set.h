#pragma once

#include <span>

#include "vertex_field.h"

namespace nearwall::layers {

/// Lines of a front as the field has them now: base, straight pieces, heights that fit the thickness, window.
mesh::Lines make_lines(const Wall& wall, const LinePlan& plan, const Stacks& stacks, VertexField& field);

/// Sets heights and windows of the lines of some vertices anew. Lines too thin for doubles are blocked, in the field,
/// too.
void update_lines(const LinePlan& plan, const Stacks& stacks, std::span<const VertexId> vertices, double resolution,
                  VertexField& field, mesh::Lines& lines);

/// Smallest height that coordinates of this size can resolve.
double resolution(const Wall& wall, const VertexField& field);

}  // namespace nearwall::layers

#pragma once

#include <vector>

#include "vertex_field.h"

namespace nearwall::layers {

/// Directions d that are smooth over lengths below `length` times the thickness and follow the present ones, d0, over
/// longer ones: the screened Poisson equation (d - d0) - l² Laplace(d) = 0, l that length at each vertex, with the
/// directions of all other vertices as values at the border. Vertices on ridges look along the ridge only.
/// \param vertices  all on ridges or none, each with one line
/// \param number    (n_vertices) place in `vertices`; negative: not among them
/// \returns  one for each of `vertices`, not normalised
/// Cost: conjugate gradients, some l / edge length iterations. Source: docs/theory/layers.md, section 3
std::vector<Vec3> solve_lean(const Wall& wall, const VertexField& field, const LinePlan& plan,
                             const std::vector<VertexId>& vertices, const IdVector<VertexId, int>& number,
                             double length);

}  // namespace nearwall::layers

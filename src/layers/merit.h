#pragma once

#include "vertex_field.h"

namespace nearwall::layers {

/// The lines of a wall face at their ends: the offsets of its corners at the thicknesses that they may have.
/// \param height  at this share of them
std::array<Vec3, 3> tops_of(const LinePlan& plan, const VertexField& field, const Wall& wall, FaceId f,
                            double height = 1);

/// What a wall face keeps of what it is asked for, 0 … 1: the share of its thickness, as far as lines do not cross,
/// times that of its first height, the smaller over the larger. By it directions and fans are chosen.
/// \param asked   (n_vertices) thickness to measure by [length]
/// \param height  the share of all thicknesses up to which lines are looked at
double merit(const Wall& wall, const LinePlan& plan, const VertexField& field, const IdVector<VertexId, double>& asked,
             FaceId f, double height = 1);

}  // namespace nearwall::layers

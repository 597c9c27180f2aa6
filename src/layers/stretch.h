#pragma once

#include "nearwall/layers/grow.h"

namespace nearwall::layers {

/// Length of a line for each thickness that it stands for: 1 / (mean cosine between it and the faces round v, weighted
/// by their angles at v), bounded.
double stretch_of(const Wall& wall, VertexId v, const Vec3& direction);

}  // namespace nearwall::layers

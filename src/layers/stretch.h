#pragma once

#include "nearwall/layers/grow.h"

namespace nearwall::layers {

/// A line is at most this much longer than the thickness it stands for: 2 is a lean of 60 degrees. Where a sharp edge
/// asks for more, the layers thin out towards it rather than stick out.
inline constexpr double kMaxStretch = 2.0;

/// Lines that lean away or are searched for do not meet a face of their vertex under a smaller cosine: by leaning more,
/// their steps would grow faster along them than 1.3 where heights grow by 1.2.
inline constexpr double kLeastCosine = 1 / kMaxStretch;

/// Length of a line for each thickness that it stands for: 1 / (mean cosine between it and the faces round v, weighted
/// by their angles at v), bounded.
double stretch_of(const Wall& wall, VertexId v, const Vec3& direction);

}  // namespace nearwall::layers

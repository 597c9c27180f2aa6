#pragma once

#include "vertex_field.h"

namespace nearwall::layers {

/// The lines of a wall and how long they may be, before anything is certified.
struct Layout {
  IdVector<HalfedgeId, char> is_cut;  ///< (3 n_faces) 1: a ridge that was to get several lines
  LinePlan plan;
  VertexField field;
  IdVector<VertexId, surface::PointNormal> normals;  ///< (n_vertices) before smoothing
  int sweeps = 0;                                    ///< of smoothing done
};

/// Directions for the ridges with several lines that are given, and the limits by gaps, crossings and neighbours.
/// \param asked  as `ask` gives it
Layout lay_out(const Wall& wall, const GrowOptions& options, const VertexField& asked,
               IdVector<HalfedgeId, char> is_cut);

/// The layout of all ridges that need several lines, and of those for which a trial shows that more is kept with them.
/// Source: docs/theory/fans.md, section 8
Layout best_layout(const Wall& wall, const GrowOptions& options, const VertexField& asked);

}  // namespace nearwall::layers

#pragma once

#include "vertex_field.h"

namespace nearwall::layers {

/// Bends lines where straight ones would cross below their thickness, as beside concave ridges and in hollows: away
/// from there over a distance that grows with the height, so that first heights stay what they are. Each height's
/// directions are solved for from those below; what would keep less than half of what a face kept before is taken back.
/// Source: docs/theory/layers.md, section 3. Cost: nothing but one look at each face where no lines cross; otherwise
/// proportional to the part of the wall concerned, times the ratio of thickness to edge length.
void lean_lines(const Wall& wall, const VertexField& field, LinePlan& plan);

}  // namespace nearwall::layers

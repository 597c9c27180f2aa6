#pragma once

#include "vertex_field.h"

namespace nearwall::layers {

/// Turns single lines of faces that keep less than they are asked for, where that lets the faces round them keep more:
/// coordinate search, each line in turn, a few times. Beside lines that cross, those of fans excepted, it bends them at
/// a height at which they do not cross yet, if that is not too low, so that first heights stay what they are.
/// Source: docs/theory/layers.md, section 3. Cost: proportional to the number of such lines.
void search_lines(const Wall& wall, const VertexField& field, LinePlan& plan);

}  // namespace nearwall::layers

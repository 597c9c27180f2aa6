#pragma once

#include <array>
#include <utility>

#include "nearwall/mesh/cell.h"
#include "nearwall/mesh/front.h"
#include "nearwall/mesh/lines.h"

namespace nearwall::mesh {

/// The face of a column over an edge of the front, between two lines and two levels.
struct SideFace {
  std::array<LineNode, 4> nodes;
  int size = 0;  ///< 4, 3; less: the face has no area
};

/// Bottom from a to b, then the top back, without nodes that repeat: the rule of columns (docs/theory/columns.md).
/// Where the front's face lies to the left of a → b, counterclockwise seen from outside of the column.
SideFace side_face(const Front& front, const Lines& lines, LineId a, LineId b, Level level);

/// Levels [first, last) between which at least one of two lines moves.
std::pair<Level, Level> level_range(const Lines& lines, LineId a, LineId b);

}  // namespace nearwall::mesh

#pragma once

#include <vector>

#include "cut_wall.h"

namespace nearwall::layers {

/// Which lines leave the wall, where to, and the front that they carry: topology and directions, no heights yet.
struct LinePlan {
  mesh::Front front;
  IdVector<LineId, Vec3> direction;       ///< unit vectors
  IdVector<LineId, double> stretch;       ///< length along the line per thickness, 1 … kMaxStretch
  IdVector<VertexId, Level> start;        ///< level at which the lines of a vertex leave the wall: 1 where a fan ends
  IdVector<VertexId, char> cannot_leave;  ///< no direction sees a group's faces, or no fan fits there
};

/// One line for each group of faces round each vertex, fans of lines between the groups, and virtual faces: a quad for
/// each two neighbouring lines over a ridge edge, a triangle where the fan ends, a filled loop at corners.
/// \param normal  (n_copies) what the groups march along, smoothed
/// Source: method of docs/theory/fans.md.
LinePlan plan_lines(const Wall& wall, const CutWall& cut, const IdVector<VertexId, surface::PointNormal>& normal,
                    double max_turn);

}  // namespace nearwall::layers

#pragma once

#include <vector>

#include "cut_wall.h"

namespace nearwall::layers {

/// A place that a bent line passes.
struct Knot {
  double at = 0;  ///< thickness [length]
  Vec3 offset;    ///< from the base of the line [length]
};

/// Which lines leave the wall, where to, and the front that they carry: topology and directions, no heights yet.
struct LinePlan {
  mesh::Front front;
  IdVector<LineId, Vec3> direction;       ///< unit vectors
  IdVector<LineId, double> stretch;       ///< length along the line per thickness, 1 … kMaxStretch
  IdVector<VertexId, Level> start;        ///< level at which the lines of a vertex leave the wall: 1 where a fan ends
  IdVector<VertexId, char> cannot_leave;  ///< no direction sees a group's faces, or no fan fits there
  /// Knots of bent lines in increasing order of thickness, none for straight ones; empty if all are straight. Beyond
  /// its last knot a line goes on straight from its base through it.
  IdVector<LineId, std::vector<Knot>> bends;

  bool is_bent(LineId line) const { return !bends.empty() && !bends[line].empty(); }
  /// The way a line goes first, per thickness.
  Vec3 foot(LineId line) const {
    return is_bent(line) ? bends[line].front().offset / bends[line].front().at : direction[line] * stretch[line];
  }
  /// Where the line is at a thickness, from its base [length].
  Vec3 offset(LineId line, double thickness) const;
};

/// One line for each group of faces round each vertex, fans of lines between the groups, and virtual faces: a quad for
/// each two neighbouring lines over a ridge edge, a triangle where the fan ends, a filled loop at corners.
/// \param normal  (n_copies) what the groups march along, smoothed
/// Source: method of docs/theory/fans.md.
LinePlan plan_lines(const Wall& wall, const CutWall& cut, const IdVector<VertexId, surface::PointNormal>& normal,
                    double max_turn);

}  // namespace nearwall::layers

#pragma once

#include <vector>

#include "line_plan.h"
#include "nearwall/layers/grow.h"
#include "stacks.h"

namespace nearwall::layers {

/// What the growth knows of each wall vertex; all its lines share it. Thicknesses are measured normal to the wall: a
/// line that leans is longer by its stretch.
struct VertexField {
  IdVector<VertexId, std::uint32_t> schedule;    ///< patch whose stack it has
  IdVector<VertexId, double> scale;              ///< of that stack's heights at this vertex
  IdVector<VertexId, double> asked;              ///< thickness asked for; 0 where there is no layer to be
  IdVector<VertexId, Level> levels;              ///< last level asked for
  IdVector<VertexId, char> ends_isotropic;       ///< 1: that is where its layer is as high as its triangles are wide
  IdVector<VertexId, double> thickness;          ///< allowed now, <= asked; 0: blocked
  IdVector<VertexId, Level> max_level;           ///< last level allowed now
  IdVector<VertexId, double> reached;            ///< thickness of the stack that is laid
  IdVector<VertexId, mesh::LimitReason> reason;  ///< of the last limit that bit

  StackRequest request(VertexId v) const { return {schedule[v], scale[v], asked[v], levels[v]}; }

  /// Lowers the thickness to `limit` if that is less; true if it was.
  bool lower(VertexId v, double limit, mesh::LimitReason why) {
    if (!(thickness[v] > limit)) return false;
    thickness[v] = limit > 0 ? limit : 0;
    reason[v] = why;
    return true;
  }
};

/// Asks each vertex for the schedule of its patch, between patches for the one with fewer layers, then the thinner one.
/// A patch may ask each vertex for its own first height, thickness or last level. Vertices at the edge of a patch
/// without layers are blocked; on patches without layers and on components that the
/// fluid cannot reach nothing is asked.
VertexField ask(const Wall& wall, const GrowOptions& options, const Stacks& stacks);

/// The lines that leave the wall: normals by the chosen method, smoothed, and fans where ridges get several lines.
/// Vertices that cannot be left are blocked.
/// \param is_cut   (3 n_faces) ridges with several lines
/// \param normals  (n_vertices) before smoothing: of the group of faces that is seen worst
/// \param sweeps   of smoothing done
LinePlan set_lines(const Wall& wall, const GrowOptions& options, const IdVector<HalfedgeId, char>& is_cut,
                   VertexField& field, IdVector<VertexId, surface::PointNormal>& normals, int& sweeps);

/// Closed form of the method, section 3: no thick wedge may lose its orientation on the way up.
/// \returns vertices that were lowered, in increasing order
std::vector<VertexId> limit_by_curvature(const Wall& wall, const LinePlan& plan, VertexField& field);

/// Keeps each line below its share of the gap to the next wall: half of it, and what the other side does not ask for.
/// By a ray along the line, and a ball round its end for walls that the ray misses or meets obliquely. Cost: a few tree
/// queries for each line. Source: docs/theory/layers.md, section 6.
void limit_by_gaps(const Wall& wall, const LinePlan& plan, VertexField& field);

/// Lowers neighbours so that thickness rises along the surface at a bounded rate, which depends on the reason for which
/// a line is thin.
/// \param seeds  vertices whose thickness may be too low for their neighbours; empty: all
/// \returns      vertices that were lowered
std::vector<VertexId> grade(const Wall& wall, VertexField& field, const std::vector<VertexId>& seeds);

/// Lowers the last levels of neighbours so that no line that moves ends above another by more than the step of its
/// patch. A line that stays at the wall may neighbour any: the cells round it are pyramids with it as their apex.
/// \param seeds  vertices that may end too low for their neighbours; empty: all
/// \returns      vertices whose last level was lowered, in increasing order
std::vector<VertexId> step_levels(const Wall& wall, const Stacks& stacks, VertexField& field,
                                  const std::vector<VertexId>& seeds);

}  // namespace nearwall::layers

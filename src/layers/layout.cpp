#include "layout.h"

#include <utility>

#include "bends.h"
#include "cut_wall.h"
#include "lean.h"
#include "line_search.h"
#include "plane_limit.h"

namespace nearwall::layers {

Layout lay_out(const Wall& wall, const GrowOptions& options, const VertexField& asked,
               IdVector<HalfedgeId, char> is_cut) {
  Layout layout;
  layout.is_cut = std::move(is_cut);
  layout.field = asked;
  layout.plan = set_lines(wall, options, layout.is_cut, layout.field, layout.normals, layout.sweeps);
  limit_by_gaps(wall, layout.plan, layout.field);
  grade(wall, layout.field, {});
  if (options.lean_lines) lean_lines(wall, layout.field, layout.plan);
  if (options.search_lines) search_lines(wall, layout.field, layout.plan);
  round_bends(layout.field, layout.plan);
  const auto at_planes = limit_by_planes(wall, layout.plan, layout.field);
  if (!at_planes.empty()) grade(wall, layout.field, at_planes);
  const auto curved = limit_by_curvature(wall, layout.plan, layout.field);
  if (!curved.empty()) grade(wall, layout.field, curved);
  return layout;
}

}  // namespace nearwall::layers

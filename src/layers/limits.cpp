#include <algorithm>
#include <array>

#include "merit.h"
#include "nearwall/core/parallel.h"
#include "swept_limit.h"
#include "vertex_field.h"

namespace nearwall::layers {

namespace {

using mesh::LimitReason;

/// Lowering one line changes the limits of its neighbours: a few sweeps settle nearly all; the certificate the rest.
constexpr int kCurvatureSweeps = 4;

}  // namespace

std::vector<VertexId> limit_by_curvature(const Wall& wall, const LinePlan& plan, VertexField& field) {
  const std::size_t n_faces = wall.surface.faces.size();
  std::vector<std::array<double, 3>> share(n_faces);
  std::vector<double> kept(field.thickness.size());
  std::vector<char> is_lowered(field.thickness.size(), 0);
  for (int sweep = 0; sweep < kCurvatureSweeps; ++sweep) {
    parallel_for(n_faces, [&](std::size_t i) {
      const FaceId f(i);
      const std::array<Vec3, 3> triangle = wall.surface.triangle(f), tops = tops_of(plan, field, wall, f);
      share[i] = shares_kept(triangle, tops, swept_limit(triangle, tops));
    });
    // The least share of the faces round a vertex, all of this sweep: shares must not multiply within one.
    std::fill(kept.begin(), kept.end(), 1.0);
    for (std::size_t i = 0; i < n_faces; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        double& least = kept[wall.surface.faces[FaceId(i)][k].index()];
        least = std::min(least, share[i][k]);
      }
    }
    bool any = false;
    for (const VertexId v : field.thickness.ids()) {
      if (kept[v.index()] == 1.0) continue;
      if (!field.lower(v, kept[v.index()] * field.thickness[v], LimitReason::Curvature)) continue;
      is_lowered[v.index()] = 1;
      any = true;
    }
    if (!any) break;
  }
  std::vector<VertexId> lowered;
  for (std::size_t v = 0; v < is_lowered.size(); ++v) {
    if (is_lowered[v]) lowered.push_back(VertexId(v));
  }
  return lowered;
}

}  // namespace nearwall::layers

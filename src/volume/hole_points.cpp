#include "volume/hole_points.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "nearwall/search/patch_tree.h"
#include "volume/boundary_check.h"

namespace nearwall::volume {

std::vector<Vec3> hole_points(const FillBoundary& boundary) {
  const auto& [points, triangles] = boundary;
  std::vector<std::array<std::uint32_t, 4>> patches;
  patches.reserve(triangles.size());
  for (const auto& t : triangles) patches.push_back({t[0], t[1], t[2], search::kNoCorner});
  const search::PatchTree tree({points, patches});
  const BoundaryParts parts = parts_of(boundary);

  std::vector<std::optional<Vec3>> holes(parts.n_parts);
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    auto& hole = holes[parts.part[f]];
    if (hole) continue;
    const auto gate = tree.gate(f);
    if (!gate) continue;
    const auto inside = tree.winding_number(gate->behind), outside = tree.winding_number(gate->before);
    if (!inside || !outside) continue;
    if (*inside != 1 || *outside != 0) {
      const Vec3& p = points[triangles[f][0]];
      throw FillFailed(
          fmt::format(
              "the part of the boundary at ({:.9g}, {:.9g}, {:.9g}) has the region to be filled {}: its normals "
              "must point out of the region",
              p.x(), p.y(), p.z(), *outside == 1 && *inside == 0 ? "on its outer side" : "on no or both sides"),
          {f});
    }
    hole = gate->before;
  }
  std::vector<Vec3> found;
  for (std::uint32_t k = 0; k < holes.size(); ++k) {
    if (holes[k]) {
      found.push_back(*holes[k]);
      continue;
    }
    std::vector<std::uint32_t> concerned;
    for (std::uint32_t f = 0; f < triangles.size(); ++f) {
      if (parts.part[f] == k) concerned.push_back(f);
    }
    throw FillFailed("no point could be found beside a part of the boundary: its triangles are too thin",
                     std::move(concerned));
  }
  return found;
}

}  // namespace nearwall::volume

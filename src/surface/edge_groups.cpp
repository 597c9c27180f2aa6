#include "surface/edge_groups.h"

#include <algorithm>
#include <utility>

namespace nearwall::surface {
namespace {

struct EdgeOfHalfedge {
  VertexId low, high;
  HalfedgeId halfedge;
  auto operator<=>(const EdgeOfHalfedge&) const = default;
};

}  // namespace

EdgeGroups::EdgeGroups(const mesh::SurfaceMesh& surface, std::span<const char> is_left_out) {
  std::vector<EdgeOfHalfedge> entries;
  entries.reserve(3 * surface.faces.size());
  for (const FaceId f : surface.faces.ids()) {
    if (is_left_out[f.index()]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(surface.faces[f][k], surface.faces[f][(k + 1) % 3]);
      entries.push_back({low, high, HalfedgeId(3 * std::size_t{f.index()} + k)});
    }
  }
  std::ranges::sort(entries);
  halfedges_.reserve(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const bool is_first =
        i == 0 || std::pair(entries[i].low, entries[i].high) != std::pair(entries[i - 1].low, entries[i - 1].high);
    if (is_first) offset_.push_back(i);
    halfedges_.push_back(entries[i].halfedge);
  }
  offset_.push_back(entries.size());
}

}  // namespace nearwall::surface

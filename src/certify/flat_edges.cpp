#include "nearwall/certify/flat_edges.h"

#include <unordered_map>

namespace nearwall::certify {

FlatEdges::FlatEdges(const mesh::SidePlane& plane, std::span<const std::array<std::uint32_t, 2>> edges_in_space,
                     std::span<const Vec3> positions) {
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  const auto local = [&](std::uint32_t p) {
    const auto [found, is_new] = number.emplace(p, static_cast<std::uint32_t>(points.size()));
    if (is_new) {
      const auto [u, v] = plane.flat(positions[p]);
      points.push_back({u, v});
      original.push_back(p);
    }
    return found->second;
  };
  for (const auto& edge : edges_in_space) {
    const std::uint32_t from = local(edge[0]), to = local(edge[1]);
    edges.push_back({from, to});
  }
}

}  // namespace nearwall::certify

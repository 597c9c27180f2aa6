#include "certify/mesh_boundary.h"

#include <algorithm>
#include <numeric>

#include <oneapi/tbb/parallel_sort.h>

#include "nearwall/core/parallel.h"

namespace nearwall::certify {

namespace {

using mesh::FaceNodes;
using mesh::size_of;

/// Faces of a part that are tried before it counts as undecided.
constexpr std::size_t kMaxTries = 32;
constexpr std::size_t kPartsInBlock = 16;

struct FaceEdge {
  std::uint32_t low, high, face;
  friend auto operator<=>(const FaceEdge&, const FaceEdge&) = default;
};

/// Edges of all faces, those between the same two nodes next to each other.
std::vector<FaceEdge> sorted_edges(std::span<const FaceNodes> faces) {
  std::vector<FaceEdge> edges;
  edges.reserve(4 * faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto n = static_cast<std::size_t>(size_of(faces[f]));
    for (std::size_t k = 0; k < n; ++k) {
      const auto [low, high] = std::minmax({faces[f][k], faces[f][(k + 1) % n]});
      edges.push_back({low, high, f});
    }
  }
  oneapi::tbb::parallel_sort(edges.begin(), edges.end());
  return edges;
}

/// Forest of faces; the root of a tree is its smallest face.
class Forest {
 public:
  explicit Forest(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::uint32_t{0}); }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    const auto [low, high] = std::minmax({root(i), root(j)});
    parent_[high] = low;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// How often points just behind the part with these faces are covered; nothing if none of them can be looked behind.
std::optional<int> cover_behind(const search::PatchTree& tree, std::span<const std::uint32_t> faces) {
  for (std::size_t i = 0; i < std::min(kMaxTries, faces.size()); ++i) {
    // From all over the part.
    const std::uint32_t face = faces[i * faces.size() / std::min(kMaxTries, faces.size())];
    const auto gate = tree.gate(face);
    const auto cover = gate ? tree.winding_number(gate->behind) : std::nullopt;
    if (cover) return cover;
  }
  return std::nullopt;
}

}  // namespace

std::vector<FaceNodes> boundary_corners(const mesh::VolumeMesh& mesh, const Conformity& faces) {
  std::vector<FaceNodes> corners(faces.boundary.size());
  parallel_for(corners.size(), [&](std::size_t i) { corners[i] = nodes_of(mesh, faces.boundary[i]); });
  return corners;
}

std::uint64_t count_coincident_points(std::span<const Vec3> points, std::span<const FaceNodes> faces) {
  std::vector<std::uint32_t> nodes;
  for (const FaceNodes& face : faces) nodes.insert(nodes.end(), face.begin(), face.begin() + size_of(face));
  oneapi::tbb::parallel_sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  oneapi::tbb::parallel_sort(nodes.begin(), nodes.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  std::uint64_t n = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) n += points[nodes[i]] == points[nodes[i - 1]] ? 1 : 0;
  return n;
}

std::vector<std::uint32_t> boundary_parts(std::span<const FaceNodes> faces) {
  Forest forest(faces.size());
  const std::vector<FaceEdge> edges = sorted_edges(faces);
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last].low == edges[first].low && edges[last].high == edges[first].high) ++last;
    if (last - first == 2) forest.join(edges[first].face, edges[first + 1].face);
    first = last;
  }
  std::vector<std::uint32_t> part(faces.size());
  std::uint32_t n_parts = 0;
  for (std::uint32_t f = 0; f < part.size(); ++f) {
    const std::uint32_t root = forest.root(f);
    part[f] = root == f ? n_parts++ : part[root];
  }
  return part;
}

Covers count_covers(const search::PatchTree& tree, std::span<const std::uint32_t> part) {
  if (part.empty()) return {};
  const std::size_t n_parts = *std::max_element(part.begin(), part.end()) + std::size_t{1};
  std::vector<std::vector<std::uint32_t>> members(n_parts);
  for (std::uint32_t f = 0; f < part.size(); ++f) members[part[f]].push_back(f);
  std::vector<std::optional<int>> cover(n_parts);
  parallel_blocks(n_parts, kPartsInBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) cover[p] = cover_behind(tree, members[p]);
  });
  Covers covers;
  for (std::size_t p = 0; p < n_parts; ++p) {
    if (!cover[p]) ++covers.n_undecided;
    if (cover[p] && *cover[p] > 1) covers.twice.push_back(members[p].front());
  }
  return covers;
}

}  // namespace nearwall::certify

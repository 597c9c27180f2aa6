#include <algorithm>

#include <oneapi/tbb/parallel_sort.h>

#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/core/parallel.h"

namespace nearwall::certify {

namespace {

using mesh::FaceKey;
using mesh::FaceName;
using mesh::FaceNodes;
using mesh::key_of;
using mesh::size_of;

constexpr std::size_t kNodesInBlock = 4096;

struct KeyedFace {
  FaceKey key;
  FaceName name;
};

bool has_repeated_node(const FaceNodes& face) {
  for (int i = 1; i < size_of(face); ++i) {
    for (int j = 0; j < i; ++j) {
      if (face[static_cast<std::size_t>(i)] == face[static_cast<std::size_t>(j)]) return true;
    }
  }
  return false;
}

/// Judges the faces [first, last), which are one: of the same nodes in the same cycle.
void judge(std::span<const KeyedFace> same, Conformity& out) {
  const bool are_opposite = same.size() == 2 && same[0].key.is_turned != same[1].key.is_turned;
  if (are_opposite) return;
  if (same.size() == 1) {
    out.boundary.push_back(same[0].name);
  } else {
    out.nonconforming.push_back({same[0].name, same.size() == 2 ? FaceFault::SameSide : FaceFault::ManyCells});
  }
}

/// The faces over one smallest node. `keyed` is room kept from node to node.
void judge_node(const mesh::VolumeMesh& mesh, std::span<const FaceName> faces, std::vector<KeyedFace>& keyed,
                Conformity& out) {
  keyed.clear();
  for (const FaceName name : faces) {
    const FaceNodes nodes = nodes_of(mesh, name);
    if (has_repeated_node(nodes)) {
      out.nonconforming.push_back({name, FaceFault::RepeatedNode});
    } else {
      keyed.push_back({key_of(nodes), name});
    }
  }
  std::sort(keyed.begin(), keyed.end(), [](const KeyedFace& a, const KeyedFace& b) {
    return a.key.nodes != b.key.nodes ? a.key.nodes < b.key.nodes : a.name < b.name;
  });
  for (std::size_t first = 0; first < keyed.size();) {
    std::size_t last = first + 1;
    while (last < keyed.size() && keyed[last].key.nodes == keyed[first].key.nodes) ++last;
    judge(std::span(keyed).subspan(first, last - first), out);
    first = last;
  }
}

/// Nodes in increasing order, kNoNode last, with the face they are of.
struct NodeSet {
  FaceNodes nodes{};
  FaceName name;

  friend auto operator<=>(const NodeSet&, const NodeSet&) = default;
};

/// Quads of the boundary that have the nodes of another face of it, or some of them, and yet do not match it.
void find_quads_that_do_not_match(const mesh::VolumeMesh& mesh, Conformity& out) {
  std::vector<NodeSet> triangles, quads;
  for (const FaceName name : out.boundary) {
    NodeSet set{nodes_of(mesh, name), name};
    std::sort(set.nodes.begin(), set.nodes.end());
    (set.nodes[3] == mesh::kNoNode ? triangles : quads).push_back(set);
  }
  oneapi::tbb::parallel_sort(triangles.begin(), triangles.end());
  oneapi::tbb::parallel_sort(quads.begin(), quads.end());
  const auto is_a_triangle = [&](FaceNodes nodes, std::size_t left_out) {
    std::copy(nodes.begin() + static_cast<std::ptrdiff_t>(left_out) + 1, nodes.end(),
              nodes.begin() + static_cast<std::ptrdiff_t>(left_out));
    nodes[3] = mesh::kNoNode;
    const auto at = std::lower_bound(triangles.begin(), triangles.end(), NodeSet{nodes, FaceName()});
    return at != triangles.end() && at->nodes == nodes;
  };
  std::vector<NonconformingFace> found(quads.size());
  std::vector<char> is_found(quads.size(), 0);
  parallel_for(quads.size(), [&](std::size_t i) {
    const bool is_other_order = i > 0 && quads[i].nodes == quads[i - 1].nodes;
    bool is_on_triangle = false;
    for (std::size_t k = 0; k < 4 && !is_on_triangle; ++k) is_on_triangle = is_a_triangle(quads[i].nodes, k);
    found[i] = {quads[i].name, is_other_order ? FaceFault::OtherOrder : FaceFault::QuadOnTriangles};
    is_found[i] = is_other_order || is_on_triangle;
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (is_found[i]) out.nonconforming.push_back(found[i]);
  }
}

}  // namespace

Conformity conformity(const mesh::VolumeMesh& mesh) {
  const mesh::FaceIndex index(mesh);
  std::vector<Conformity> by_block((index.n_nodes() + kNodesInBlock - 1) / kNodesInBlock);
  parallel_blocks(index.n_nodes(), kNodesInBlock, [&](std::size_t begin, std::size_t end) {
    Conformity part;
    std::vector<KeyedFace> keyed;
    for (std::size_t node = begin; node < end; ++node) judge_node(mesh, index.faces_at(node), keyed, part);
    by_block[begin / kNodesInBlock] = std::move(part);
  });
  Conformity all;
  for (const Conformity& part : by_block) {
    all.nonconforming.insert(all.nonconforming.end(), part.nonconforming.begin(), part.nonconforming.end());
    all.boundary.insert(all.boundary.end(), part.boundary.begin(), part.boundary.end());
  }
  oneapi::tbb::parallel_sort(all.boundary.begin(), all.boundary.end());
  find_quads_that_do_not_match(mesh, all);
  std::sort(all.nonconforming.begin(), all.nonconforming.end(),
            [](const NonconformingFace& a, const NonconformingFace& b) { return a.face < b.face; });
  return all;
}

}  // namespace nearwall::certify

#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "nearwall/mesh/layer_mesh.h"

namespace nearwall::mesh {

/// Faces of each cell type, counterclockwise seen from outside, in the node order of predicates/cells.h.
inline const std::vector<std::vector<int>>& faces_of(CellType type) {
  static const std::array<std::vector<std::vector<int>>, kNCellTypes> kFaces = {{
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
      {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
      {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
  }};
  return kFaces[static_cast<std::size_t>(type)];
}

using NodeCycle = std::vector<NodeIndex>;

/// The cycle rotated so that its smallest node comes first.
inline NodeCycle canonical(NodeCycle cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

inline NodeCycle reversed(NodeCycle cycle) {
  std::reverse(cycle.begin(), cycle.end());
  return canonical(std::move(cycle));
}

/// How often each oriented face occurs among all cells.
inline std::map<NodeCycle, int> oriented_faces(const LayerMesh& layers) {
  std::map<NodeCycle, int> count;
  for (std::size_t f = 0; f < layers.n_columns(); ++f) {
    layers.for_each_cell(FrontFaceId(f), [&](const LayerCell& cell, Level) {
      for (const auto& face : faces_of(cell.type)) {
        NodeCycle cycle;
        for (const int k : face) cycle.push_back(layers.node(cell.nodes[static_cast<std::size_t>(k)]));
        ++count[canonical(cycle)];
      }
    });
  }
  return count;
}

}  // namespace nearwall::mesh

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/core/ids.h"
#include "nearwall/core/vec3.h"
#include "nearwall/mesh/cell.h"

namespace nearwall::mesh {

/// A mesh of tetrahedra, pyramids, wedges and hexahedra with all its points and cells in memory, as read from a file.
struct VolumeMesh {
  std::vector<Vec3> points;
  std::vector<CellType> type;             ///< (n_cells)
  std::vector<std::uint64_t> first_node;  ///< (n_cells + 1) where the nodes of each cell begin
  std::vector<std::uint32_t> nodes;       ///< order of predicates/cells.h
  std::vector<std::uint64_t> file_cell;   ///< (n_cells) number in the file, which may hold cells of other kinds, too
  std::vector<std::int32_t> layer;        ///< (n_cells) 1 at the wall, 0 outside the layers; empty: not known

  std::size_t n_cells() const { return type.size(); }
  std::span<const std::uint32_t> nodes_of(std::size_t cell) const {
    return {nodes.data() + first_node[cell], static_cast<std::size_t>(size_of(type[cell]))};
  }
  /// Coordinates of the nodes of a cell; the first size_of(type) are set.
  std::array<Vec3, 8> corners_of(std::size_t cell) const {
    std::array<Vec3, 8> corners;
    std::size_t k = 0;
    for (const std::uint32_t node : nodes_of(cell)) corners[k++] = points[node];
    return corners;
  }
};

}  // namespace nearwall::mesh

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "nearwall/mesh/mesh_source.h"

namespace nearwall::io {

/// A mesh held in memory, handed out in batches of a given size.
class MeshForTests final : public mesh::MeshSource {
 public:
  std::size_t batch_size = 3;
  std::vector<Vec3> points;
  struct Cell {
    mesh::CellType type;
    std::array<NodeIndex, 8> nodes;
    std::int32_t layer;
    std::int64_t column;
    std::int32_t patch;
  };
  std::vector<Cell> cells;

  NodeIndex n_points() const override { return points.size(); }
  CellIndex n_cells() const override { return cells.size(); }
  std::array<CellIndex, mesh::kNCellTypes> n_cells_by_type() const override {
    std::array<CellIndex, mesh::kNCellTypes> n{};
    for (const Cell& cell : cells) ++n[static_cast<std::size_t>(cell.type)];
    return n;
  }
  std::size_t n_point_batches() const override { return (points.size() + batch_size - 1) / batch_size; }
  std::size_t n_cell_batches() const override { return (cells.size() + batch_size - 1) / batch_size; }

  void read_points(std::size_t batch, mesh::PointBatch& out) const override {
    out.clear();
    out.first = batch * batch_size;
    for (std::size_t i = out.first; i < std::min(points.size(), out.first + batch_size); ++i) {
      out.position.push_back(points[i]);
      out.line.push_back(static_cast<std::int64_t>(i) - 1);
      out.level.push_back(static_cast<std::int32_t>(i % 5));
    }
  }
  void read_cells(std::size_t batch, mesh::CellBatch& out) const override {
    out.clear();
    out.first = batch * batch_size;
    for (std::size_t i = out.first; i < std::min(cells.size(), out.first + batch_size); ++i) {
      const Cell& cell = cells[i];
      out.type.push_back(cell.type);
      out.nodes.push_back(cell.nodes);
      out.corners.emplace_back();
      for (int k = 0; k < mesh::size_of(cell.type); ++k) out.corners.back()[k] = points[cell.nodes[k]];
      out.layer.push_back(cell.layer);
      out.column.push_back(cell.column);
      out.patch.push_back(cell.patch);
    }
  }
};

/// A cube (hexahedron) with a pyramid on it, and a wedge with a tetrahedron on it: all positive in the order of
/// predicates/cells.h. Volumes 1, 1/3, 1/2 and 1/6.
inline MeshForTests one_of_each() {
  using enum mesh::CellType;
  MeshForTests mesh;
  mesh.points = {{0, 0, 0},     {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1},
                 {0.5, 0.5, 2}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}, {6, 0, 1}, {5, 1, 1}, {5, 0, 2}};
  mesh.cells = {{Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}, 1, 0, 0},
                {Pyramid, {4, 5, 6, 7, 8}, 0, -1, -1},
                {Wedge, {9, 10, 11, 12, 13, 14}, 1, 3000000000, 1},
                {Tetrahedron, {12, 13, 14, 15}, 2, 7, 1}};
  return mesh;
}

/// n × n columns of two wedges each on a unit square, n_layers high, over a wavy floor.
inline MeshForTests wedge_block(std::size_t n, std::size_t n_layers) {
  MeshForTests mesh;
  mesh.batch_size = 30000;
  const std::size_t row = n + 1, sheet = row * row;
  for (std::size_t k = 0; k <= n_layers; ++k) {
    for (std::size_t j = 0; j <= n; ++j) {
      for (std::size_t i = 0; i <= n; ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(n),
                     y = static_cast<double>(j) / static_cast<double>(n);
        mesh.points.emplace_back(x, y,
                                 std::sin(7 * x) * std::cos(5 * y) + 1e-4 * std::pow(1.2, static_cast<double>(k)));
      }
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      for (const int half : {0, 1}) {
        for (std::size_t k = 0; k < n_layers; ++k) {
          const NodeIndex a = k * sheet + j * row + i, b = a + 1, c = a + row + 1, d = a + row;
          const std::array<NodeIndex, 3> base = half == 0 ? std::array{a, b, c} : std::array{a, c, d};
          mesh.cells.push_back({mesh::CellType::Wedge,
                                {base[0], base[1], base[2], base[0] + sheet, base[1] + sheet, base[2] + sheet},
                                static_cast<std::int32_t>(k + 1),
                                static_cast<std::int64_t>(2 * (j * n + i)) + half,
                                0});
        }
      }
    }
  }
  return mesh;
}

}  // namespace nearwall::io

#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "nearwall/mesh/mesh_source.h"
#include "nearwall/mesh/volume_mesh.h"

/// Small volume meshes for tests.
namespace nearwall::volume_meshes_for_tests {

using mesh::CellType;
using mesh::VolumeMesh;

inline void add_cell(VolumeMesh& mesh, CellType type, const std::vector<std::uint32_t>& nodes) {
  if (mesh.first_node.empty()) mesh.first_node.push_back(0);
  mesh.file_cell.push_back(mesh.type.size());
  mesh.type.push_back(type);
  mesh.nodes.insert(mesh.nodes.end(), nodes.begin(), nodes.end());
  mesh.first_node.push_back(mesh.nodes.size());
}

/// Number of a corner of a block: x first, then y, then z.
inline std::uint32_t block_node(std::uint32_t n, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  return i + (n + 1) * (j + (n + 1) * k);
}

/// The eight corners of a small cube of a block, in the order of a hexahedron.
inline std::array<std::uint32_t, 8> cube_nodes(std::uint32_t n, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  const auto at = [&](std::uint32_t di, std::uint32_t dj, std::uint32_t dk) {
    return block_node(n, i + di, j + dj, k + dk);
  };
  return {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)};
}

/// How a small cube is cut into cells, by places of a hexahedron's nodes.
using Cells = std::vector<std::pair<CellType, std::vector<std::uint32_t>>>;

inline const Cells& as_hexahedron() {
  static const Cells cells = {{CellType::Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}}};
  return cells;
}

inline const Cells& as_wedges() {
  static const Cells cells = {{CellType::Wedge, {0, 1, 2, 4, 5, 6}}, {CellType::Wedge, {0, 2, 3, 4, 6, 7}}};
  return cells;
}

/// Kuhn's six tetrahedra round the diagonal from 0 to 6: neighbouring cubes match.
inline const Cells& as_tetrahedra() {
  static const Cells cells = [] {
    Cells six;
    for (const auto& path : std::vector<std::array<std::uint32_t, 2>>{{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}}) {
      six.push_back({CellType::Tetrahedron, {0, path[0], path[1], 6}});
    }
    return six;
  }();
  return cells;
}

/// [0, 1]³ as n³ small cubes, each cut alike.
inline VolumeMesh block(std::uint32_t n, const Cells& cells) {
  VolumeMesh mesh;
  for (std::uint32_t k = 0; k <= n; ++k) {
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        mesh.points.push_back(Vec3(i, j, k) / static_cast<double>(n));
      }
    }
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const auto cube = cube_nodes(n, i, j, k);
        for (const auto& [type, places] : cells) {
          std::vector<std::uint32_t> nodes;
          for (const std::uint32_t place : places) nodes.push_back(cube[place]);
          add_cell(mesh, type, nodes);
        }
      }
    }
  }
  return mesh;
}

/// The unit cube as six pyramids with their tips in its middle.
inline VolumeMesh six_pyramids() {
  VolumeMesh mesh = block(1, {});
  mesh.points.push_back(Vec3(0.5, 0.5, 0.5));
  const std::array<std::uint32_t, 8> c = cube_nodes(1, 0, 0, 0);
  for (const auto& q : std::vector<std::array<std::size_t, 4>>{
           {0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}) {
    add_cell(mesh, CellType::Pyramid, {c[q[0]], c[q[1]], c[q[2]], c[q[3]], 8});
  }
  return mesh;
}

/// The unit cube as five tetrahedra.
inline VolumeMesh five_tetrahedra() {
  return block(1, {{CellType::Tetrahedron, {0, 1, 2, 5}},
                   {CellType::Tetrahedron, {0, 2, 3, 7}},
                   {CellType::Tetrahedron, {0, 7, 5, 2}},
                   {CellType::Tetrahedron, {0, 5, 7, 4}},
                   {CellType::Tetrahedron, {2, 7, 5, 6}}});
}

template <class Map>
VolumeMesh mapped(VolumeMesh mesh, Map&& map) {
  for (Vec3& p : mesh.points) p = map(p);
  return mesh;
}

/// Both as one; nothing is shared.
inline VolumeMesh joined(VolumeMesh a, const VolumeMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (std::size_t c = 0; c < b.n_cells(); ++c) {
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t node : b.nodes_of(c)) nodes.push_back(node + first);
    add_cell(a, b.type[c], nodes);
  }
  return a;
}

/// Points that are equal bit for bit become the first of them.
inline VolumeMesh merged(VolumeMesh mesh) {
  for (std::uint32_t& node : mesh.nodes) {
    std::uint32_t first = 0;
    while (mesh.points[first] != mesh.points[node]) ++first;
    node = first;
  }
  return mesh;
}

inline VolumeMesh without_cell(const VolumeMesh& mesh, std::size_t left_out) {
  VolumeMesh rest;
  rest.points = mesh.points;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    if (c == left_out) continue;
    const auto nodes = mesh.nodes_of(c);
    add_cell(rest, mesh.type[c], {nodes.begin(), nodes.end()});
  }
  return rest;
}

/// All of a source in memory.
inline VolumeMesh read(const mesh::MeshSource& source) {
  VolumeMesh mesh;
  mesh::PointBatch points;
  for (std::size_t b = 0; b < source.n_point_batches(); ++b) {
    source.read_points(b, points);
    mesh.points.insert(mesh.points.end(), points.position.begin(), points.position.end());
  }
  mesh::CellBatch cells;
  for (std::size_t b = 0; b < source.n_cell_batches(); ++b) {
    source.read_cells(b, cells);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto n = static_cast<std::size_t>(mesh::size_of(cells.type[c]));
      std::vector<std::uint32_t> nodes;
      for (std::size_t k = 0; k < n; ++k) nodes.push_back(static_cast<std::uint32_t>(cells.nodes[c][k]));
      add_cell(mesh, cells.type[c], nodes);
    }
  }
  return mesh;
}

}  // namespace nearwall::volume_meshes_for_tests

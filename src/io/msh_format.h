#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "nearwall/mesh/cell.h"

/// Gmsh's numbers of element types. Its node order is that of predicates/cells.h for all cells, and faces of the
/// boundary are counterclockwise seen from outside: nothing is permuted.
namespace nearwall::io {

inline constexpr int kMshTriangle = 2;
inline constexpr int kMshQuad = 3;

/// By mesh::CellType.
inline constexpr std::array<int, mesh::kNCellTypes> kMshCells = {4, 7, 6, 5};

constexpr int msh_code(mesh::CellType type) { return kMshCells[static_cast<std::size_t>(type)]; }

/// An element type of first order.
struct MshElement {
  int dimension = 0;
  std::size_t n_nodes = 1;
  mesh::CellType cell = mesh::CellType::Tetrahedron;  ///< if the dimension is 3
};

/// None for types of higher order and unknown ones.
constexpr std::optional<MshElement> msh_element(std::int64_t code) {
  constexpr int kLine = 1, kPoint = 15;
  if (code == kPoint) return MshElement{0, 1};
  if (code == kLine) return MshElement{1, 2};
  if (code == kMshTriangle) return MshElement{2, 3};
  if (code == kMshQuad) return MshElement{2, 4};
  for (std::size_t type = 0; type < kMshCells.size(); ++type) {
    if (code == kMshCells[type]) {
      return MshElement{3, static_cast<std::size_t>(mesh::kCellSize[type]), static_cast<mesh::CellType>(type)};
    }
  }
  return std::nullopt;
}

}  // namespace nearwall::io

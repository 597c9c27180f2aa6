#pragma once

#include <array>
#include <cstdint>

#include "nearwall/mesh/cell.h"

/// VTK's numbers of cell types and its order of their nodes: the one place that knows them.
namespace nearwall::io {

/// How VTK numbers a cell, against the order of predicates/cells.h. Only the wedge differs: VTK's first triangle is
/// clockwise seen from the second (its right-hand normal points out of the cell), ours counterclockwise.
struct VtkCell {
  std::uint8_t code;                 ///< VTK's cell type
  std::array<std::uint8_t, 8> node;  ///< our index of VTK's node k
};

inline constexpr std::array<VtkCell, mesh::kNCellTypes> kVtkCells = {{
    {10, {0, 1, 2, 3, 0, 0, 0, 0}},  // VTK_TETRA
    {14, {0, 1, 2, 3, 4, 0, 0, 0}},  // VTK_PYRAMID
    {13, {0, 2, 1, 3, 5, 4, 0, 0}},  // VTK_WEDGE
    {12, {0, 1, 2, 3, 4, 5, 6, 7}},  // VTK_HEXAHEDRON
}};

/// A hexahedron that is never written: a box whose nodes are numbered row by row.
inline constexpr VtkCell kVtkVoxel = {11, {0, 1, 3, 2, 4, 5, 7, 6}};

/// Faces whose points do not go round them.
inline constexpr std::int64_t kVtkStrip = 6;
inline constexpr std::int64_t kVtkPixel = 8;

/// What a cell of a file means to us.
struct VtkCellMeaning {
  enum class Use : std::uint8_t { Refused, Cell, SkippedPoint, SkippedLine, SkippedFace };
  Use use = Use::Refused;
  std::uint8_t size = 0;  ///< number of nodes; 0: any
  mesh::CellType type = mesh::CellType::Tetrahedron;
  std::array<std::uint8_t, 8> node{};
};

inline constexpr std::size_t kNVtkCodes = 256;

/// By VTK's cell type.
inline constexpr std::array<VtkCellMeaning, kNVtkCodes> kVtkMeanings = [] {
  using Use = VtkCellMeaning::Use;
  std::array<VtkCellMeaning, kNVtkCodes> all{};
  const auto skip = [&](std::size_t code, Use use, std::uint8_t size) { all[code].use = use, all[code].size = size; };
  skip(0, Use::SkippedPoint, 0);         // VTK_EMPTY_CELL
  skip(1, Use::SkippedPoint, 1);         // VTK_VERTEX
  skip(2, Use::SkippedPoint, 0);         // VTK_POLY_VERTEX
  skip(3, Use::SkippedLine, 2);          // VTK_LINE
  skip(4, Use::SkippedLine, 0);          // VTK_POLY_LINE
  skip(5, Use::SkippedFace, 3);          // VTK_TRIANGLE
  skip(kVtkStrip, Use::SkippedFace, 0);  // VTK_TRIANGLE_STRIP
  skip(7, Use::SkippedFace, 0);          // VTK_POLYGON
  skip(kVtkPixel, Use::SkippedFace, 4);  // VTK_PIXEL
  skip(9, Use::SkippedFace, 4);          // VTK_QUAD
  const auto read = [&](const VtkCell& cell, mesh::CellType type) {
    all[cell.code] = {Use::Cell, static_cast<std::uint8_t>(mesh::size_of(type)), type, cell.node};
  };
  for (std::size_t i = 0; i < mesh::kNCellTypes; ++i) read(kVtkCells[i], static_cast<mesh::CellType>(i));
  read(kVtkVoxel, mesh::CellType::Hexahedron);
  return all;
}();

}  // namespace nearwall::io

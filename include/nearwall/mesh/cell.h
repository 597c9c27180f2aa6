#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "nearwall/core/ids.h"
#include "nearwall/core/vec3.h"

namespace nearwall::mesh {

enum class CellType : std::uint8_t { Tetrahedron, Pyramid, Wedge, Hexahedron };

inline constexpr std::size_t kNCellTypes = 4;
inline constexpr std::array<int, kNCellTypes> kCellSize = {4, 5, 6, 8};
inline constexpr std::array<std::string_view, kNCellTypes> kCellTypeNames = {"tetrahedron", "pyramid", "wedge",
                                                                             "hexahedron"};

constexpr int size_of(CellType type) { return kCellSize[static_cast<std::size_t>(type)]; }

/// Volume of the cell's map [length³]; see geometry/measures.h.
/// \param p  corners in the order of predicates/cells.h, size_of(type) of them or more
double cell_volume(CellType type, std::span<const Vec3> p);

/// A node of the layers, named by a line and a level. Nodes that coincide by the window rule have several names and one
/// node number (LayerMesh::node).
struct LineNode {
  LineId line;
  Level level = 0;
};

/// A cell of a column. Node order: bottom face counterclockwise seen from the top (or apex), then the top: the order of
/// predicates/cells.h. Files use VTK's order; only io knows it.
struct LayerCell {
  CellType type = CellType::Wedge;
  std::array<LineNode, 8> nodes;  ///< the first size_of(type) are used
};

}  // namespace nearwall::mesh

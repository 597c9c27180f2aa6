#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nearwall/mesh/cell.h"
#include "nearwall/mesh/cell_faces.h"

namespace nearwall::io {

/// A cell as its faces make it.
struct FacedCell {
  mesh::CellType type = mesh::CellType::Tetrahedron;
  std::array<std::uint32_t, 8> nodes{};  ///< order of predicates/cells.h; the first size_of(type) are used
};

/// The tetrahedron, pyramid, wedge or hexahedron with these faces; nothing if they are those of another polyhedron.
/// Wedges and hexahedra begin with their smallest node.
/// \param faces  triangles and quads, counterclockwise seen from outside the cell
/// \param is_closed  false: the faces are over the right nodes, but some are turned the wrong way round
std::optional<FacedCell> cell_of(std::span<const mesh::FaceNodes> faces, bool& is_closed);

}  // namespace nearwall::io

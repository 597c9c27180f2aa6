#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "nearwall/mesh/boundary.h"
#include "nearwall/mesh/cell.h"

/// What the writer and the reader of UGRID agree on. Numbers of points count from 1, faces of the boundary are
/// counterclockwise seen from inside the mesh.
namespace nearwall::io {

/// Numbers of the header: points, triangles, quads, tetrahedra, pyramids, wedges, hexahedra.
inline constexpr std::size_t kUgridHeader = 7;

/// Our index of UGRID's node k, for each type of cell in the file's order. Only the pyramid differs from the order of
/// predicates/cells.h: its apex is the third node, its base 0, 3, 4, 1.
inline constexpr std::array<std::array<std::uint8_t, 8>, mesh::kNCellTypes> kUgridNodes = {{
    {0, 1, 2, 3, 0, 0, 0, 0},
    {0, 3, 4, 1, 2, 0, 0, 0},
    {0, 1, 2, 3, 4, 5, 0, 0},
    {0, 1, 2, 3, 4, 5, 6, 7},
}};

/// FUN3D's numbers of boundary conditions.
inline constexpr int kFun3dViscousWall = 4000;
inline constexpr int kFun3dTangency = 3000;
inline constexpr int kFun3dSymmetryX = 6661;  ///< then y, z
inline constexpr int kFun3dFarField = 5000;
inline constexpr int kFun3dSubsonicInflow = 7011;
inline constexpr int kFun3dSubsonicOutflow = 7012;
inline constexpr int kFun3dNone = 0;  ///< no condition of FUN3D, which stops: to be filled in

/// NAME.mapbc for NAME.ugrid, NAME.b8.ugrid and NAME.lb8.ugrid (upper or lower case, and with .gz behind it).
std::filesystem::path mapbc_path(const std::filesystem::path& grid);

/// \param normal_axis  of a symmetry plane: 0 to 2 where it is normal to an axis
int fun3d_code(mesh::BoundaryType type, std::optional<int> normal_axis);
/// Other for codes that are neither of these nor of their families.
mesh::BoundaryType type_of_fun3d_code(std::int64_t code);

}  // namespace nearwall::io

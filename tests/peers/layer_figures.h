#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/volume_mesh.h"

namespace nearwall::peers {

/// What layers are like, told from the mesh alone, so that it does not matter which program made it.
struct LayerFigures {
  std::uint64_t n_cells = 0;
  double smallest_jacobian = std::numeric_limits<double>::infinity();       ///< scaled, of all cells
  double smallest_wall_jacobian = std::numeric_limits<double>::infinity();  ///< of the cells over wall triangles
  /// Of prisms that stand upright on the wall: no layers on this triangulation can have a larger smallest_wall_jacobian
  /// but by bending away from its normals.
  double upright_jacobian = std::numeric_limits<double>::infinity();
  double any_percent = 0;           ///< of the wall's area, with a cell on it
  double first_height_percent = 0;  ///< of the wall's area, with a first height within 1 % of the asked one
  double largest_height_error = 0;  ///< of the first height, over the asked one
  double largest_lean = 0;          ///< between a wall triangle's normal and a line at its corners [rad]
  std::uint32_t fewest_lines = std::numeric_limits<std::uint32_t>::max();  ///< at the nodes on the sharp edge
  double largest_turn = 0;  ///< between neighbouring lines at a node on the sharp edge [rad]
};

/// \param is_on_sharp_edge  tells the points of a wall at which lines are to be counted
/// Cost: O(n_cells).
LayerFigures layer_figures(const mesh::VolumeMesh& mesh, const mesh::SurfaceMesh& wall, double first_height,
                           const std::function<bool(const Vec3&)>& is_on_sharp_edge);

}  // namespace nearwall::peers

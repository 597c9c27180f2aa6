#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/cursor.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

/// Cells as one list of points and the end of each cell in it.
struct CellList {
  std::vector<std::int64_t> points;
  std::vector<std::int64_t> ends;  ///< (n_cells), ascending
};

/// What the readers of VTK's two file formats find in a file of polygons.
struct PolyDataInput {
  std::vector<Vec3> points;
  std::size_t n_vertices_and_lines = 0;  ///< cells that come before the polygons in cell arrays
  CellList polygons;
  CellList strips;

  struct IntegerArray {
    std::string name;
    std::vector<std::int64_t> values;
  };
  std::vector<IntegerArray> cell_arrays;  ///< those that may be patch numbers
  std::vector<std::string> patch_names;   ///< field data `PatchNames`
};

/// Could an array of this name hold patch numbers?
bool is_patch_array_name(std::string_view name);
inline constexpr std::string_view kPatchNames = "PatchNames";

/// The surface: polygons and strips cut into triangles, patches from the array `Patch` or one of its other usual names.
/// \throws GeometryError at `where` on points that do not exist, or without any triangle.
mesh::SurfaceMesh to_surface(const PolyDataInput& input, const FilePosition& where);

}  // namespace nearwall::io

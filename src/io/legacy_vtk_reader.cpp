#include <fmt/format.h>

#include "io/legacy_vtk_input.h"
#include "io/point_arrays.h"
#include "io/polydata_input.h"
#include "io/surface_formats.h"
#include "io/vtk_cells.h"

namespace nearwall::io {

namespace {

/// The triangles, quads and polygons of an unstructured grid, such as the boundary of a volume mesh.
PolyDataInput faces_of_grid(LegacyVtkInput& in) {
  LegacyGrid grid = in.read_grid();
  const std::vector<std::int64_t>& types = grid.types;
  const CellList& cells = grid.cells;
  PolyDataInput data;
  data.points = std::move(grid.points);
  if (types.size() != cells.ends.size()) {
    in.cursor().fail(fmt::format("there are {} types for {} cells", types.size(), cells.ends.size()));
  }
  data.cell_arrays = in.take_cell_arrays();
  std::erase_if(data.cell_arrays, [&](const auto& array) { return array.values.size() != types.size(); });
  std::size_t n_faces = 0;
  for (std::size_t c = 0; c < types.size(); ++c) {
    const bool is_known = types[c] >= 0 && static_cast<std::uint64_t>(types[c]) < kNVtkCodes;
    if (!is_known || kVtkMeanings[static_cast<std::size_t>(types[c])].use != VtkCellMeaning::Use::SkippedFace) continue;
    if (types[c] == kVtkStrip || types[c] == kVtkPixel) {
      in.cursor().fail("triangle strips and pixels are not read from unstructured grids; save triangles and quads");
    }
    const auto begin = static_cast<std::size_t>(c == 0 ? 0 : cells.ends[c - 1]);
    const auto end = static_cast<std::size_t>(cells.ends[c]);
    if (begin > end || end > cells.points.size()) in.cursor().fail(fmt::format("cell {}: the offsets are damaged", c));
    for (std::size_t k = begin; k < end; ++k) data.polygons.points.push_back(cells.points[k]);
    data.polygons.ends.push_back(static_cast<std::int64_t>(data.polygons.points.size()));
    for (auto& array : data.cell_arrays) array.values[n_faces] = array.values[c];
    ++n_faces;
  }
  for (auto& array : data.cell_arrays) array.values.resize(n_faces);
  if (n_faces == 0) {
    in.cursor().fail("the grid has no triangles, quads or polygons (in ParaView: Extract Surface, then save)");
  }
  return data;
}

PolyDataInput polygons_of_polydata(LegacyVtkInput& in) {
  PolyDataInput data;
  for (std::string_view keyword = in.next_section(); !keyword.empty(); keyword = in.next_section()) {
    if (same_word(keyword, "POINTS")) {
      data.points = in.read_points();
    } else if (same_word(keyword, "VERTICES") || same_word(keyword, "LINES")) {
      data.n_vertices_and_lines += in.read_cells().ends.size();
    } else if (same_word(keyword, "POLYGONS")) {
      data.polygons = in.read_cells();
    } else if (same_word(keyword, "TRIANGLE_STRIPS")) {
      data.strips = in.read_cells();
    } else {
      in.read_other(keyword);
    }
  }
  data.cell_arrays = in.take_cell_arrays();
  return data;
}

}  // namespace

mesh::SurfaceMesh parse_legacy_vtk(std::string_view bytes, const std::string& file, PointArrays& arrays) {
  LegacyVtkInput in(bytes, file);
  in.keep_point_arrays(arrays);
  const bool is_grid = same_word(in.dataset(), "UNSTRUCTURED_GRID");
  if (!is_grid && !same_word(in.dataset(), "POLYDATA")) {
    in.cursor().fail_expected(
        "'POLYDATA' or 'UNSTRUCTURED_GRID': other data sets are no surfaces (in ParaView: Extract Surface, then save)",
        in.dataset());
  }
  PolyDataInput data = is_grid ? faces_of_grid(in) : polygons_of_polydata(in);
  data.patch_names = in.take_patch_names();
  return to_surface(data, in.cursor().position());
}

mesh::SurfaceMesh parse_legacy_vtk(std::string_view bytes, const std::string& file) {
  PointArrays none;
  return parse_legacy_vtk(bytes, file, none);
}

}  // namespace nearwall::io

#include "io/legacy_vtk_input.h"
#include "io/point_arrays.h"
#include "io/polydata_input.h"
#include "io/surface_formats.h"

namespace nearwall::io {

mesh::SurfaceMesh parse_legacy_vtk(std::string_view bytes, const std::string& file, PointArrays& arrays) {
  LegacyVtkInput in(bytes, file);
  in.keep_point_arrays(arrays);
  if (!same_word(in.dataset(), "POLYDATA")) {
    in.cursor().fail_expected("'POLYDATA': other data sets are no surfaces (in ParaView: Extract Surface, then save)",
                              in.dataset());
  }
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
  data.patch_names = in.take_patch_names();
  return to_surface(data, in.cursor().position());
}

mesh::SurfaceMesh parse_legacy_vtk(std::string_view bytes, const std::string& file) {
  PointArrays none;
  return parse_legacy_vtk(bytes, file, none);
}

}  // namespace nearwall::io

#include <fmt/format.h>

#include "io/legacy_vtk_input.h"
#include "io/volume_builder.h"
#include "io/volume_formats.h"

namespace nearwall::io {
namespace {

/// Adds the arrays and lets go of each.
VolumeFile to_volume(std::vector<Vec3> points, std::vector<std::int64_t> types, CellList cells, LegacyVtkInput& in) {
  VolumeBuilder builder(in.cursor().file());
  builder.expect_points(points.size());
  for (const Vec3& p : points) builder.add_coordinates(std::array{p.x(), p.y(), p.z()});
  std::vector<Vec3>().swap(points);
  builder.expect_cells(types.size());
  builder.add_types(types);
  builder.add_ends(cells.ends);
  builder.expect_nodes(cells.points.size());
  builder.add_nodes(cells.points);
  builder.end_piece();
  return builder.finish(in.take_patch_names());
}

}  // namespace

VolumeFile parse_legacy_volume(std::string_view bytes, const std::string& file) {
  LegacyVtkInput in(bytes, file);
  if (!same_word(in.dataset(), "UNSTRUCTURED_GRID")) {
    in.cursor().fail_expected("'UNSTRUCTURED_GRID': other data sets are no meshes of cells", in.dataset());
  }
  std::vector<Vec3> points;
  std::vector<std::int64_t> types;
  CellList cells;
  for (std::string_view keyword = in.next_section(); !keyword.empty(); keyword = in.next_section()) {
    if (same_word(keyword, "POINTS")) {
      points = in.read_points();
    } else if (same_word(keyword, "CELLS")) {
      cells = in.read_cells();
    } else if (same_word(keyword, "CELL_TYPES")) {
      types = in.read_integers(in.cursor().integer("the number of cells"), ScalarType::Int32);
    } else {
      in.read_other(keyword);
    }
  }
  return to_volume(std::move(points), std::move(types), std::move(cells), in);
}

}  // namespace nearwall::io

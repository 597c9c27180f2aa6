#include <fmt/format.h>

#include "io/legacy_vtk_input.h"
#include "io/volume_builder.h"
#include "io/volume_formats.h"

namespace nearwall::io {
namespace {

/// Adds the arrays and lets go of each.
VolumeFile to_volume(LegacyGrid grid, LegacyVtkInput& in) {
  VolumeBuilder builder(in.cursor().file());
  builder.expect_points(grid.points.size());
  for (const Vec3& p : grid.points) builder.add_coordinates(std::array{p.x(), p.y(), p.z()});
  std::vector<Vec3>().swap(grid.points);
  builder.expect_cells(grid.types.size());
  builder.add_types(grid.types);
  builder.add_ends(grid.cells.ends);
  builder.expect_nodes(grid.cells.points.size());
  builder.add_nodes(grid.cells.points);
  builder.end_piece();
  return builder.finish(in.take_patch_names());
}

}  // namespace

VolumeFile parse_legacy_volume(std::string_view bytes, const std::string& file) {
  LegacyVtkInput in(bytes, file);
  if (!same_word(in.dataset(), "UNSTRUCTURED_GRID")) {
    in.cursor().fail_expected("'UNSTRUCTURED_GRID': other data sets are no meshes of cells", in.dataset());
  }
  return to_volume(in.read_grid(), in);
}

}  // namespace nearwall::io

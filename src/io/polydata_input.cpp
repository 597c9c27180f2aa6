#include "io/polydata_input.h"

#include <fmt/format.h>

#include <array>
#include <span>

#include "io/surface_builder.h"

namespace nearwall::io {
namespace {

/// In order of preference; upper and lower case count the same.
constexpr std::array<std::string_view, 6> kPatchArrays = {"Patch",  "PatchId",  "PatchIds",
                                                          "Region", "RegionId", "CellEntityIds"};

std::span<const std::int64_t> cell_points(const CellList& cells, std::size_t i, const FilePosition& where) {
  const std::int64_t begin = i == 0 ? 0 : cells.ends[i - 1];
  const std::int64_t end = cells.ends[i];
  if (begin > end || static_cast<std::uint64_t>(end) > cells.points.size()) {
    fail_at(where,
            fmt::format("cell {} ends at {} of {} entries: the offsets are damaged", i, end, cells.points.size()));
  }
  return std::span(cells.points).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
}

const PolyDataInput::IntegerArray* patch_array(const PolyDataInput& input) {
  const std::size_t n_cells = input.n_vertices_and_lines + input.polygons.ends.size() + input.strips.ends.size();
  for (const std::string_view wanted : kPatchArrays) {
    for (const auto& array : input.cell_arrays) {
      if (same_word(array.name, wanted) && array.values.size() == n_cells) return &array;
    }
  }
  return nullptr;
}

}  // namespace

bool is_patch_array_name(std::string_view name) {
  for (const std::string_view wanted : kPatchArrays) {
    if (same_word(name, wanted)) return true;
  }
  return false;
}

mesh::SurfaceMesh to_surface(const PolyDataInput& input, const FilePosition& where) {
  SurfaceBuilder surface;
  surface.reserve(input.points.size(), input.polygons.ends.size());
  for (const Vec3& point : input.points) surface.add_point(point, where);

  std::vector<std::size_t> cell_of_triangle;
  std::size_t cell = input.n_vertices_and_lines;
  for (std::size_t i = 0; i < input.polygons.ends.size(); ++i, ++cell) {
    surface.add_face(cell_points(input.polygons, i, where), where);
    cell_of_triangle.resize(surface.n_faces(), cell);
  }
  for (std::size_t i = 0; i < input.strips.ends.size(); ++i, ++cell) {
    const auto strip = cell_points(input.strips, i, where);
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {  // every other triangle of a strip is turned round
      const std::size_t odd = k % 2;
      surface.add_face(std::array{strip[k], strip[k + 1 + odd], strip[k + 2 - odd]}, where);
    }
    cell_of_triangle.resize(surface.n_faces(), cell);
  }
  if (const auto* array = patch_array(input)) {
    std::vector<std::int64_t> patch_of_triangle;
    for (const std::size_t c : cell_of_triangle) patch_of_triangle.push_back(array->values[c]);
    surface.assign_patches(patch_of_triangle, input.patch_names);
  }
  return surface.finish(where);
}

}  // namespace nearwall::io

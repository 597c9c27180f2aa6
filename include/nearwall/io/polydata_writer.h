#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

/// A named array over points, lines or triangles: one tuple of `components` values for each.
struct DataArray {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int32_t>> values;
  int components = 1;
};

struct StringArray {
  std::string name;
  std::vector<std::string> values;
};

/// What a .vtp file holds. Lines and polygons (triangles, then quads) carry their arrays apart; the writer puts them
/// into VTK's order of cells (lines first) and fills an array that only one of them has with −1 or NaN on the other.
struct PolyDataFile {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of points
  std::vector<std::array<std::uint32_t, 4>> quads;      ///< indices of points
  std::vector<std::array<std::uint32_t, 2>> lines;      ///< indices of points
  std::vector<DataArray> point_data;                    ///< (n_points, components)
  std::vector<DataArray> triangle_data;                 ///< (n_triangles + n_quads, components)
  std::vector<DataArray> line_data;                     ///< (n_lines, components)
  std::vector<StringArray> field_data;                  ///< e.g. PatchNames
};

/// The surface with its cell array `Patch` and field data `PatchNames`, which read_surface understands.
PolyDataFile polydata_of(const mesh::SurfaceMesh& surface);

/// Those triangles of a surface, in the order given and with just the points they use; further cell array `Triangle`:
/// their ids in the surface. For files of offending triangles.
PolyDataFile polydata_of(const mesh::SurfaceMesh& surface, const std::vector<FaceId>& triangles);

/// The bytes of the .vtp file: doubles, appended, compressed. Sizes of the arrays are checked (InternalError).
std::string format_polydata(const PolyDataFile& data);

/// Writes format_polydata(data) through a PendingFile. \throws IoError
void write_polydata(const std::filesystem::path& path, const PolyDataFile& data);

}  // namespace nearwall::io

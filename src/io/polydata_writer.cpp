#include "nearwall/io/polydata_writer.h"

#include <fmt/format.h>

#include <limits>
#include <map>

#include "io/vtk_xml_output.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/markup.h"
#include "nearwall/io/pending_file.h"

namespace nearwall::io {
namespace {

/// The part of an array that is missing, on lines or on triangles.
constexpr std::int32_t kNoInteger = -1;
constexpr double kNoReal = std::numeric_limits<double>::quiet_NaN();

template <class T>
T no_value() {
  if constexpr (std::is_integral_v<T>) {
    return kNoInteger;
  } else {
    return kNoReal;
  }
}

template <class T>
std::string_view type_name() {
  return std::is_integral_v<T> ? "Int32" : "Float64";
}

void check_size(const DataArray& array, std::size_t n) {
  const std::size_t size = std::visit([](const auto& values) { return values.size(); }, array.values);
  expect(array.components >= 1 && size == n * static_cast<std::size_t>(array.components),
         fmt::format("array '{}' has {} values of {} components, expected {} tuples", array.name, size,
                     array.components, n));
}

PackedArray packed(const DataArray& array) {
  return std::visit(
      [&]<class T>(const std::vector<T>& values) {
        PackedArray out(escaped_markup(array.name), std::string(type_name<T>()), array.components, {});
        out.append(std::span<const T>(values));
        return out;
      },
      array.values);
}

/// One array over all cells: its values on the lines, then those on the triangles; null: it has none there.
DataArray joined(const DataArray* on_lines, const DataArray* on_triangles, const PolyDataFile& data) {
  const DataArray& model = on_triangles ? *on_triangles : *on_lines;
  DataArray out{model.name, {}, model.components};
  std::visit(
      [&]<class T>(const std::vector<T>&) {
        std::vector<T> values;
        const auto append = [&](const DataArray* part, std::size_t n) {
          if (part) {
            const auto* same_type = std::get_if<std::vector<T>>(&part->values);
            expect(same_type && part->components == model.components, "an array has one type on lines and triangles");
            values.insert(values.end(), same_type->begin(), same_type->end());
          } else {
            values.insert(values.end(), n * static_cast<std::size_t>(model.components), no_value<T>());
          }
        };
        append(on_lines, data.lines.size());
        append(on_triangles, data.triangles.size() + data.quads.size());
        out.values = std::move(values);
      },
      model.values);
  return out;
}

const DataArray* find(const std::vector<DataArray>& arrays, std::string_view name) {
  for (const DataArray& array : arrays) {
    if (array.name == name) return &array;
  }
  return nullptr;
}

std::vector<DataArray> cell_data(const PolyDataFile& data) {
  std::vector<DataArray> out;
  for (const DataArray& array : data.triangle_data)
    out.push_back(joined(find(data.line_data, array.name), &array, data));
  for (const DataArray& array : data.line_data) {
    if (!find(data.triangle_data, array.name)) out.push_back(joined(&array, nullptr, data));
  }
  return out;
}

/// `connectivity` and `offsets` of lists of cells, one after the other.
template <class... Cells>
std::vector<PackedArray> packed_cells(std::size_t n_points, const Cells&... lists) {
  std::vector<std::int64_t> points, offsets;
  const auto add = [&](const auto& cells) {
    for (const auto& cell : cells) {
      for (const std::uint32_t point : cell) {
        expect(point < n_points, "cells use points that exist");
        points.push_back(point);
      }
      offsets.push_back(static_cast<std::int64_t>(points.size()));
    }
  };
  (add(lists), ...);
  std::vector<PackedArray> out;
  out.emplace_back("connectivity", "Int64", 1, "");
  out.back().append(std::span<const std::int64_t>(points));
  out.emplace_back("offsets", "Int64", 1, "");
  out.back().append(std::span<const std::int64_t>(offsets));
  return out;
}

DataArray points_of(const PolyDataFile& data) {
  std::vector<double> values;
  values.reserve(3 * data.points.size());
  for (const Vec3& p : data.points) values.insert(values.end(), {p.x(), p.y(), p.z()});
  return {"Points", std::move(values), 3};
}

/// The arrays of one element of the file, e.g. <CellData>, in a list that stays where it is.
struct Section {
  std::string name;
  std::vector<PackedArray> arrays;
};

Section section(std::string name, const std::vector<DataArray>& arrays) {
  Section out{std::move(name), {}};
  for (const DataArray& array : arrays) out.arrays.push_back(packed(array));
  return out;
}

}  // namespace

PolyDataFile polydata_of(const mesh::SurfaceMesh& surface) {
  PolyDataFile data;
  data.points = surface.points.raw();
  std::vector<std::int32_t> patch;
  for (const FaceId f : surface.faces.ids()) {
    const auto& v = surface.faces[f];
    data.triangles.push_back({v[0].index(), v[1].index(), v[2].index()});
    patch.push_back(static_cast<std::int32_t>(surface.face_patch[f].index()));
  }
  data.triangle_data.push_back({"Patch", std::move(patch), 1});
  data.field_data.push_back({"PatchNames", surface.patch_names.raw()});
  return data;
}

PolyDataFile polydata_of(const mesh::SurfaceMesh& surface, const std::vector<FaceId>& triangles) {
  PolyDataFile data;
  std::map<VertexId, std::uint32_t> point_of_vertex;
  std::vector<std::int32_t> patch, id;
  for (const FaceId f : triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = surface.faces[f][k];
      const auto [found, is_new] = point_of_vertex.emplace(v, static_cast<std::uint32_t>(data.points.size()));
      if (is_new) data.points.push_back(surface.points[v]);
      corners[k] = found->second;
    }
    data.triangles.push_back(corners);
    patch.push_back(static_cast<std::int32_t>(surface.face_patch[f].index()));
    id.push_back(static_cast<std::int32_t>(f.index()));
  }
  data.triangle_data.push_back({"Patch", std::move(patch), 1});
  data.triangle_data.push_back({"Triangle", std::move(id), 1});
  data.field_data.push_back({"PatchNames", surface.patch_names.raw()});
  return data;
}

std::string format_polydata(const PolyDataFile& data) {
  for (const DataArray& array : data.point_data) check_size(array, data.points.size());
  for (const DataArray& array : data.line_data) check_size(array, data.lines.size());
  for (const DataArray& array : data.triangle_data) check_size(array, data.triangles.size() + data.quads.size());

  std::vector<Section> sections;
  sections.push_back(section("PointData", data.point_data));
  sections.push_back(section("CellData", cell_data(data)));
  sections.push_back(section("Points", {points_of(data)}));
  sections.push_back({"Lines", packed_cells(data.points.size(), data.lines)});
  sections.push_back({"Polys", packed_cells(data.points.size(), data.triangles, data.quads)});

  VtkXmlOutput out("PolyData");
  out.open("FieldData");
  for (const StringArray& array : data.field_data) out.add_strings(array.name, array.values);
  out.close("FieldData");
  out.open(
      fmt::format("Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
                  "NumberOfPolys=\"{}\"",
                  data.points.size(), data.lines.size(), data.triangles.size() + data.quads.size()));
  for (Section& s : sections) {
    PackedArray::pack(s.arrays, true);
    out.open(s.name);
    for (PackedArray& array : s.arrays) out.add(array);
    out.close(s.name);
  }
  out.close("Piece");

  std::string bytes;
  out.write_to([&](std::string_view part) { bytes += part; });
  return bytes;
}

void write_polydata(const std::filesystem::path& path, const PolyDataFile& data) {
  write_text(path, format_polydata(data));
}

}  // namespace nearwall::io

#include "nearwall/io/polydata_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/vtk_xml_input.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/surface_reader.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using testing::ElementsAre;
using testing::IsNan;

/// Two triangles and one line, with arrays on both, on one, and on points.
PolyDataFile sample() {
  PolyDataFile data;
  data.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  data.lines = {{1, 2}};
  data.point_data = {{"Normals", std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3},
                     {"PointKind", std::vector<std::int32_t>{0, 1, 2, 3}, 1}};
  data.triangle_data = {{"Patch", std::vector<std::int32_t>{4, 5}, 1}, {"Both", std::vector<double>{0.5, 0.25}, 1}};
  data.line_data = {{"Both", std::vector<double>{8}, 1}, {"Turn", std::vector<double>{-90}, 1}};
  data.field_data = {{"PatchNames", {"a", "b"}}};
  return data;
}

const XmlArray& array(const VtkXmlInput& file, std::string_view section, std::string_view name) {
  for (const XmlArray& a : file.arrays()) {
    if (a.section == section && a.name() == name) return a;
  }
  throw std::out_of_range(std::string(name));
}

TEST(FormatPolyData, PutsLinesBeforeTrianglesInCellArrays) {
  const std::string bytes = format_polydata(sample());
  const VtkXmlInput file(bytes, "a.vtp");
  EXPECT_EQ(file.count_of(0, "NumberOfLines"), 1);
  EXPECT_EQ(file.count_of(0, "NumberOfPolys"), 2);
  EXPECT_THAT(file.integers(array(file, "CellData", "Patch")), ElementsAre(-1, 4, 5));
  EXPECT_THAT(file.reals(array(file, "CellData", "Both")), ElementsAre(8, 0.5, 0.25));
  EXPECT_THAT(file.reals(array(file, "CellData", "Turn")), ElementsAre(-90, IsNan(), IsNan()));
  EXPECT_THAT(file.integers(array(file, "Lines", "connectivity")), ElementsAre(1, 2));
  EXPECT_THAT(file.integers(array(file, "Polys", "connectivity")), ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(file.integers(array(file, "PointData", "PointKind")), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(array(file, "PointData", "Normals").tag.attribute("NumberOfComponents"), "3");
}

TEST(FormatPolyData, RefusesArraysOfTheWrongSize) {
  auto data = sample();
  data.point_data[1].values = std::vector<std::int32_t>{1, 2};
  EXPECT_THROW(format_polydata(data), InternalError);
  data = sample();
  data.triangles[0][2] = 4;
  EXPECT_THROW(format_polydata(data), InternalError);
}

TEST(FormatPolyData, WritesEmptyData) {
  const std::string bytes = format_polydata({});
  EXPECT_EQ(VtkXmlInput(bytes, "a.vtp").count_of(0, "NumberOfPoints"), 0);
}

TEST(WritePolyData, IsReadBackAsASurface) {
  const TemporaryFolder folder;
  auto data = sample();
  data.triangle_data[0].values = std::vector<std::int32_t>{1, 0};
  write_polydata(folder / "a.vtp", data);
  const auto mesh = read_surface(folder / "a.vtp");
  EXPECT_THAT(mesh.patch_names.raw(), ElementsAre("a", "b"));
  EXPECT_EQ(mesh.face_patch[FaceId(0)], PatchId(1));
  EXPECT_EQ(mesh.points.raw(), data.points);
}

TEST(PolyDataOf, TakesJustTheTrianglesAskedForAndTheirPoints) {
  mesh::SurfaceMesh surface;
  surface.points.raw() = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& f : {std::array{1, 2, 3}, std::array{1, 2, 4}, std::array{2, 3, 4}}) {
    surface.faces.push_back({VertexId(f[0]), VertexId(f[1]), VertexId(f[2])});
    surface.face_patch.push_back(PatchId(0));
  }
  surface.patch_names.push_back("wall");
  const auto data = polydata_of(surface, {FaceId(2), FaceId(0)});
  EXPECT_THAT(data.points, ElementsAre(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, 0)));
  EXPECT_THAT(data.triangles, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(3, 0, 1)));
  EXPECT_THAT(std::get<std::vector<std::int32_t>>(data.triangle_data[1].values), ElementsAre(2, 0));
}

}  // namespace
}  // namespace nearwall::io

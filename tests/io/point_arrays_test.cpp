#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "nearwall/core/errors.h"
#include "nearwall/io/polydata_writer.h"
#include "nearwall/io/surface_reader.h"
#include "tests/io/temporary_folder.h"

// Point arrays that come with a surface.

namespace nearwall::io {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

mesh::SurfaceMesh read(std::string_view name, std::string_view bytes, const std::vector<std::string>& arrays) {
  const TemporaryFolder folder;
  return read_surface(folder.file(name, bytes), arrays);
}

std::string big_endian(double value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if constexpr (std::endian::native == std::endian::little) std::reverse(std::begin(raw), std::end(raw));
  return {raw, sizeof raw};
}

std::string little_endian(double value) {
  std::string raw = big_endian(value);
  std::reverse(raw.begin(), raw.end());
  return raw;
}

const std::string kVtkHead =
    "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 "
    "2\n";
const std::string kVtkArrays =
    "CELL_DATA 1\nSCALARS Patch int 1\nLOOKUP_TABLE default\n0\nPOINT_DATA 3\nSCALARS First double 1\n"
    "LOOKUP_TABLE default\n0.5 0.25 1e-300\nVECTORS Wind double\n1 2 3 4 5 6 7 8 9\nFIELD f 2\nTotal 1 3 float\n4 5 "
    "6\nSteps 1 3 int\n7 8 9\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty double First\nproperty float y\nproperty list "
    "uchar int near\nproperty float z\nproperty int Total\nelement face 1\nproperty list uchar int "
    "vertex_indices\nend_header\n0 0.5 0 1 1 0 4\n1 0.25 0 2 0 2 0 5\n0 1e-300 1 0 0 6\n3 0 1 2\n";

std::string vtp() {
  PolyDataFile file;
  file.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  file.triangles = {{0, 1, 2}};
  file.point_data.push_back({"First", std::vector<double>{0.5, 0.25, 1e-300}});
  file.point_data.push_back({"Wind", std::vector<double>(9, 1.0), 3});
  file.point_data.push_back({"Total", std::vector<std::int32_t>{4, 5, 6}});
  file.triangle_data.push_back({"Area", std::vector<double>{0.5}});
  return format_polydata(file);
}

const std::string kVtpAscii =
    "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\">"
    "<PointData><DataArray type=\"Float32\" Name=\"First\" format=\"ascii\">0.5 0.25 1e-300</DataArray>"
    "<DataArray type=\"Int64\" Name=\"Total\" NumberOfComponents=\"1\" format=\"ascii\">4 5 6</DataArray></PointData>"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray>"
    "</Points><Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>";

struct File {
  std::string name;
  std::string bytes;
};

std::vector<File> files() {
  return {{"a.vtk", kVtkHead + kVtkArrays}, {"a.ply", kPly}, {"a.vtp", vtp()}, {"b.vtp", kVtpAscii}};
}

TEST(PointArrays, AreThoseAskedForInTheOrderAskedFor) {
  for (const File& file : files()) {
    const auto mesh = read(file.name, file.bytes, {"Total", "First"});
    ASSERT_EQ(mesh.point_arrays.size(), 2u) << file.name;
    EXPECT_EQ(mesh.point_arrays[0].name, "Total");
    EXPECT_THAT(mesh.point_arrays[0].values.raw(), ElementsAre(4, 5, 6)) << file.name;
    EXPECT_THAT(mesh.point_arrays[1].values.raw(), ElementsAre(0.5, 0.25, 1e-300)) << file.name;
    EXPECT_TRUE(read(file.name, file.bytes, {}).point_arrays.empty()) << "none is kept that nobody wants";
  }
}

TEST(PointArrays, OfBinaryFilesAreBitForBit) {
  const double values[] = {0.1, -0.0, 5e-324};
  std::string points, array;
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0.}) points += big_endian(x);
  for (const double x : values) array += big_endian(x);
  const std::string polygon("\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2", 16);
  const auto vtk =
      read("a.vtk",
           "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\nPOINTS 3 double\n" + points + "\nPOLYGONS 1 4\n" +
               polygon + "\nPOINT_DATA 3\nSCALARS h double\nLOOKUP_TABLE default\n" + array + "\n",
           {"h"});
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double "
      "z\nproperty double h\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) ply += little_endian(corners[i][axis]);
    ply += little_endian(values[i]);
  }
  ply += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  for (const auto& mesh : {vtk, read("a.ply", ply, {"h"})}) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(mesh.point_arrays[0].values[VertexId(i)]),
                std::bit_cast<std::uint64_t>(values[i]));
    }
  }
}

TEST(PointArrays, ThatAreMissingNameTheNearestAndThoseThereAre) {
  for (const File& file : files()) {
    EXPECT_THAT([&] { read(file.name, file.bytes, {"Frist"}); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("no point array \"Frist\""), HasSubstr("nearest: \"First\""),
                                                HasSubstr("\"Total\""))))
        << file.name;
  }
  EXPECT_THAT([] { read("a.vtk", kVtkHead, {"First"}); },
              ThrowsMessage<InputError>(HasSubstr("the file has none at all")));
}

TEST(PointArrays, ThatAreOfAnotherKindAreSaidToBe) {
  const std::string vectors = "\"Wind\" is a point array of 3 components; make it one number for each point first";
  EXPECT_THAT([] { read("a.vtk", kVtkHead + kVtkArrays, {"Wind"}); },
              ThrowsMessage<PointArrayMissing>(HasSubstr(vectors)));
  EXPECT_THAT([] { read("a.vtp", vtp(), {"Wind"}); }, ThrowsMessage<PointArrayMissing>(HasSubstr(vectors)));
  EXPECT_THAT([] { read("a.vtk", kVtkHead + kVtkArrays, {"Patch"}); },
              ThrowsMessage<PointArrayMissing>(HasSubstr("\"Patch\" is a cell array")));
  EXPECT_THAT([] { read("a.vtp", vtp(), {"Area"}); },
              ThrowsMessage<PointArrayMissing>(HasSubstr("\"Area\" is a cell")));
  EXPECT_THAT([] { read("a.ply", kPly, {"vertex_indices"}); },
              ThrowsMessage<PointArrayMissing>(HasSubstr("is a property of the faces")));
}

TEST(PointArrays, AreListed) {
  const TemporaryFolder folder;
  EXPECT_THAT(point_array_names(folder.file("a.vtp", vtp())), ElementsAre("First", "Total"));
  EXPECT_THAT(point_array_names(folder.file("a.vtk", kVtkHead + kVtkArrays)), ElementsAre("First", "Total", "Steps"));
  EXPECT_THAT(point_array_names(folder.file("a.ply", kPly)), ElementsAre("First", "Total"));
  EXPECT_TRUE(point_array_names("no-file-is-read.stl").empty());
}

TEST(PointArrays, OfFormatsWithoutThemSayWhichHaveThem) {
  for (const char* name : {"a.stl", "a.obj", "a.off", "a.OBJ.gz"}) {
    EXPECT_THAT([&] { read(name, "", {"First"}); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("\"First\""), HasSubstr(".ply, .vtp, .vtk"))))
        << name;
  }
}

TEST(PointArrays, NeedAValueForEachPoint) {
  const std::string short_array = "POINT_DATA 2\nSCALARS First double 1\nLOOKUP_TABLE default\n1 2\n";
  EXPECT_THAT([&] { read("a.vtk", kVtkHead + short_array, {"First"}); },
              ThrowsMessage<GeometryError>(HasSubstr("2 values for 3 points")));
  std::string vtp = kVtpAscii;
  vtp.replace(vtp.find("0.25 "), 5, "");
  EXPECT_THAT([&] { read("a.vtp", vtp, {"First"}); },
              ThrowsMessage<GeometryError>(HasSubstr("\"First\" has 2 values for 3 points")));
}

TEST(PointArrays, OfOneNameAreTheFirst) {
  const std::string again = "POINT_DATA 3\nSCALARS First double 1\nLOOKUP_TABLE default\n7 8 9\n";
  const auto mesh = read("a.vtk", kVtkHead + kVtkArrays + again, {"First"});
  EXPECT_EQ(mesh.point_arrays[0].values[VertexId(0)], 0.5);
}

TEST(PointArrays, OfDamagedFilesAreReadOrRefused) {
  for (const File& file : files()) {
    const TemporaryFolder folder;
    int n_refused = 0;
    for (std::size_t i = 0; i < file.bytes.size(); i += 3) {
      std::string cut = file.bytes.substr(0, i), changed = file.bytes;
      changed[i] = static_cast<char>(changed[i] ^ 0x15);
      for (const std::string& bytes : {cut, changed}) {
        const auto path = folder.file(file.name, bytes);
        try {
          const std::string wanted[] = {"Total", "First"};
          for (const auto& array : read_surface(path, wanted).point_arrays) ASSERT_EQ(array.values.size(), 3u);
        } catch (const Error&) {
          ++n_refused;
        }
      }
    }
    EXPECT_GT(n_refused, 0) << file.name;
  }
}

}  // namespace
}  // namespace nearwall::io

#include "nearwall/io/boundary_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "nearwall/core/errors.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/surface_writer.h"
#include "nearwall/io/vtu_writer.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/shapes.h"
#include "tests/support/whole_meshes.h"

namespace nearwall::io {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;
using whole_meshes_for_tests::blocks_of_all_types;
using whole_meshes_for_tests::Stored;

PolyDataFile polydata_of(const Stored& mesh) {
  return boundary_polydata(mesh.boundary(), [&](NodeIndex node) { return mesh.mesh().points[node]; });
}

TEST(BoundaryFileOf, StandsBesideTheMesh) {
  EXPECT_EQ(boundary_file_of("out/wing.vtu"), "out/wing-boundary.vtp");
  EXPECT_EQ(boundary_file_of("wing.vtkhdf"), "wing-boundary.vtp");
  EXPECT_EQ(boundary_file_of("a.b/wing.v2.VTU.GZ"), "a.b/wing.v2-boundary.vtp");
}

TEST(BoundaryFile, GivesBackFacesAndPatchesWithTheirTypes) {
  const Stored mesh = blocks_of_all_types(2);
  const TemporaryFolder folder;
  write_polydata(folder / "b.vtp", polydata_of(mesh));
  const mesh::Boundary found = read_boundary(folder / "b.vtp", mesh.mesh().points.size());
  EXPECT_TRUE(std::ranges::equal(found.patches, mesh.boundary().patches)) << "also those without faces";
  std::size_t next = 0;
  for (const int size : {3, 4}) {
    for (std::size_t f = 0; f < mesh.boundary().faces.size(); ++f) {
      if (mesh::size_of(mesh.boundary().faces[f]) != size) continue;
      ASSERT_LT(next, found.faces.size());
      EXPECT_EQ(found.faces[next], mesh.boundary().faces[f]) << "triangles first, each in the boundary's order";
      EXPECT_EQ(found.patch[next++], mesh.boundary().patch[f]);
    }
  }
  EXPECT_EQ(next, found.faces.size());
}

/// Four blocks, each of the size 1/3 × 1/7 × 1e-5/11.
TEST(BoundaryFile, IsASurfaceThatLooksOutOfTheMesh) {
  const Stored mesh = blocks_of_all_types(2);
  const TemporaryFolder folder;
  write_polydata(folder / "b.vtp", polydata_of(mesh));
  const mesh::SurfaceMesh surface = read_surface(folder / "b.vtp");
  double volume = 0;
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    volume += dot(a, cross(b, c)) / 6;
  }
  const double expected = 4 * 1e-5 / 231;
  EXPECT_NEAR(volume, expected, 1e-12 * expected);
}

TEST(BoundaryFile, KnowsNumbersOfNodesBeyond32Bits) {
  constexpr NodeIndex kFar = NodeIndex{1} << 40;
  mesh::Boundary boundary;
  boundary.patches.push_back({"wall", mesh::BoundaryType::Wall});
  boundary.faces = {{kFar, kFar + 1, kFar + 2, mesh::kNoFourthNode}};
  boundary.patch = {PatchId(0)};
  const TemporaryFolder folder;
  write_polydata(folder / "b.vtp", boundary_polydata(boundary, [](NodeIndex node) {
                   return Vec3(static_cast<double>(node - kFar), node == kFar + 2 ? 1 : 0, 0);
                 }));
  EXPECT_EQ(read_boundary(folder / "b.vtp", kFar + 3).faces, boundary.faces);
  EXPECT_THROW(read_boundary(folder / "b.vtp", kFar + 2), GeometryError) << "one point fewer";
}

TEST(BoundaryFile, TakesTypesThatAreNotThereForOther) {
  const Stored mesh = blocks_of_all_types(1);
  PolyDataFile file = polydata_of(mesh);
  std::erase_if(file.field_data, [](const StringArray& array) { return array.name == "PatchTypes"; });
  const TemporaryFolder folder;
  write_polydata(folder / "b.vtp", file);
  for (const mesh::BoundaryPatch& patch : read_boundary(folder / "b.vtp", mesh.mesh().points.size()).patches) {
    EXPECT_EQ(patch.type, mesh::BoundaryType::Other);
  }
}

/// Two faces as text. \param more  in place of what a good file has
std::string text(std::string_view node = "5 6 7 9 8", std::string_view offsets = "3 7",
                 std::string_view corners = "0 1 2 0 1 3 4", std::string_view patch = "0 1") {
  return fmt::format(
      "<VTKFile type='PolyData'><PolyData><FieldData>"
      "<DataArray type='String' Name='PatchNames' NumberOfTuples='2' format='ascii'>97 0 98 0</DataArray></FieldData>"
      "<Piece NumberOfPoints='5' NumberOfPolys='2'><Points><DataArray type='Float64' NumberOfComponents='3' "
      "format='ascii'>0 0 0 1 0 0 0 1 0 1 1 0 0 0 1</DataArray></Points><PointData>"
      "<DataArray type='Float64' Name='Node' format='ascii'>{}</DataArray></PointData><CellData>"
      "<DataArray type='Int32' Name='Patch' format='ascii'>{}</DataArray></CellData><Polys>"
      "<DataArray type='Int32' Name='connectivity' format='ascii'>{}</DataArray>"
      "<DataArray type='Int32' Name='offsets' format='ascii'>{}</DataArray></Polys></Piece></PolyData></VTKFile>",
      node, patch, corners, offsets);
}

void expect_refused(const std::string& bytes, const std::string& why, NodeIndex n_points = 10) {
  const TemporaryFolder folder;
  const auto path = folder.file("b.vtp", bytes);
  EXPECT_THAT([&] { read_boundary(path, n_points); },
              ThrowsMessage<GeometryError>(AllOf(HasSubstr("b.vtp"), HasSubstr(why))));
}

TEST(BoundaryFile, NamesWhatIsDamaged) {
  const TemporaryFolder folder;
  const mesh::Boundary good = read_boundary(folder.file("good.vtp", text()), 10);
  EXPECT_EQ(good.faces, (std::vector<mesh::BoundaryFace>{{5, 6, 7, mesh::kNoFourthNode}, {5, 6, 9, 8}}));
  EXPECT_EQ(good.patches[PatchId(1)].name, "b");
  expect_refused(text(), "the mesh has 9 points", 9);
  expect_refused(text("5 6 7 9 -1"), "of node -1");
  expect_refused(text("5 6 7 9 8.5"), "of node 8.5");
  expect_refused(text("5 6 7 9 nan"), "found 'nan'");
  expect_refused(text("5 6 7 9"), "uses point 4");
  expect_refused(text("5 6 7 9 8", "3 7", "0 1 2 0 1 3 5"), "uses point 5");
  expect_refused(text("5 6 7 9 8", "3 7", "0 1 2 0 1 3"), "face 1: expected a triangle or a quad");
  expect_refused(text("5 6 7 9 8", "2 7"), "face 0: expected a triangle or a quad");
  expect_refused(text("5 6 7 9 8", "3 -7"), "face 1: expected a triangle or a quad");
  expect_refused(text("5 6 7 9 8", "4 3"), "face 1: expected a triangle or a quad");
  expect_refused(text("5 6 7 9 8", "3 7", "0 1 2 0 1 3 4", "0 2"), "face 1 is of patch 2, but there are 2 names");
  expect_refused(text("5 6 7 9 8", "3 7", "0 1 2 0 1 3 4", "0 -1"), "face 1 is of patch -1");
  expect_refused(text("5 6 7 9 8", "3 7", "0 1 2 0 1 3 4", "0"), "2 faces, but 1 numbers of patches");
}

/// The bytes of a file that `write` makes under this name.
template <class Write>
std::string bytes_written(const char* name, const Write& write) {
  const TemporaryFolder folder;
  write(folder / name);
  return bytes_of(folder / name);
}

TEST(BoundaryFile, RefusesOtherFilesOfVtk) {
  expect_refused(bytes_written("s.vtp", [](const auto& path) { write_surface(path, shapes_for_tests::cube()); }),
                 "expected an array Node in PointData");
  expect_refused(bytes_written("m.vtu", [](const auto& path) { write_vtu(path, one_of_each(), {}, {}); }),
                 "expected one piece of polygons");
  expect_refused("", "VTK XML");
  EXPECT_THROW(read_boundary("no/such/file.vtp", 1), InputError);
}

TEST(BoundaryFile, IsReadOrRefusedWhereverItIsCutOff) {
  const TemporaryFolder folder;
  write_polydata(folder / "b.vtp", polydata_of(blocks_of_all_types(1)));
  const std::string bytes = bytes_of(folder / "b.vtp");
  for (std::size_t n = 0; n + 64 < bytes.size(); n += 7) {
    const auto path = folder.file("cut.vtp", std::string_view(bytes).substr(0, n));
    EXPECT_THROW(read_boundary(path, 1000), GeometryError) << n;
  }
}

}  // namespace
}  // namespace nearwall::io

// Surfaces from files of solvers' formats: the boundaries of meshes, and surfaces alone.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/file_bytes.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/mesh_formats.h"
#include "nearwall/io/surface_reader.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/surface_by_library.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/shapes.h"
#include "tests/support/surface_files.h"
#include "tests/support/whole_meshes.h"

namespace nearwall::io {
namespace {

namespace files = surface_files_for_tests;
using mesh::SurfaceMesh;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;
using testing::UnorderedElementsAre;

double enclosed_volume(const SurfaceMesh& surface) {
  double volume = 0;
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    volume += dot(a, cross(b, c)) / 6;
  }
  return volume;
}

/// Sides of triangles that no neighbour runs through the other way.
std::size_t n_open_sides(const SurfaceMesh& surface) {
  std::multiset<std::pair<VertexId, VertexId>> sides;
  for (const auto& f : surface.faces) {
    for (std::size_t k = 0; k < 3; ++k) sides.emplace(f[k], f[(k + 1) % 3]);
  }
  return static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(), [&](const auto& side) {
    return sides.count({side.second, side.first}) != 1;
  }));
}

std::map<std::string, int> triangles_of_patches(const SurfaceMesh& surface) {
  std::map<std::string, int> n;
  for (const PatchId p : surface.face_patch) ++n[surface.patch_names[p]];
  return n;
}

// A block of 3³ small cubes as hexahedra, as two wedges or six tetrahedra each, and a cube of six pyramids.

class SurfaceOfMesh : public testing::TestWithParam<MeshFormat> {};

TEST_P(SurfaceOfMesh, IsItsBoundarySeenFromOutside) {
  const auto mesh = whole_meshes_for_tests::blocks_of_all_types(3);
  const TemporaryFolder folder;
  const auto path = folder / mesh_file_names("m", GetParam()).front();
  std::filesystem::create_directories(path.parent_path());
  write_mesh(path, GetParam(), mesh.whole(), {});
  const SurfaceMesh surface = read_surface(path);
  // 4³ − 2³ points of each block lie on its sides, 8 of the pyramids' 9.
  EXPECT_EQ(surface.points.size(), 3u * (64 - 8) + 8);
  EXPECT_EQ(surface.faces.size(), 3u * 6 * 9 * 2 + 6 * 2);
  EXPECT_EQ(n_open_sides(surface), 0u);
  const double volume = 4 * 1e-5 / 231;
  EXPECT_NEAR(enclosed_volume(surface), volume, 1e-12 * volume);
  std::vector<int> n;
  for (const auto& [name, count] : triangles_of_patches(surface)) n.push_back(count);
  EXPECT_THAT(n, UnorderedElementsAre(3 * 18 + 2, 3 * 18 + 2, 4 * (3 * 18 + 2)));
  EXPECT_THAT(surface.patch_names, testing::IsSupersetOf({"top", "sides"}));
  EXPECT_EQ(surface.patch_names.size(), 3u) << "patches without faces are left out";
}

std::vector<MeshFormat> formats_with_boundary() {
  std::vector<MeshFormat> formats;
  for (std::size_t i = 0; i < kMeshFormatNames.size(); ++i) {
    if (has_boundary(static_cast<MeshFormat>(i))) formats.push_back(static_cast<MeshFormat>(i));
  }
  return formats;
}

std::string readable(const testing::TestParamInfo<MeshFormat>& test) {
  std::string name(name_of(test.param));
  for (char& c : name) c = c == '.' || c == '-' ? '_' : c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, SurfaceOfMesh, testing::ValuesIn(formats_with_boundary()), readable);

TEST(SurfaceOfMeshInNastran, IsTheBoundaryOfItsCellsWhateverItsFacesSay) {
  // A tetrahedron with two of its faces, one of them seen from inside, and a bar.
  const TemporaryFolder folder;
  const auto path = folder.file("m.bdf",
                                "BEGIN BULK\nGRID,9,,0.,0.,0.\nGRID,7,,1.,0.,0.\nGRID,5,,0.,1.,0.\nGRID,3,,0.,0.,1.\n"
                                "GRID,1,,5.,5.,5.\nCTETRA,1,4,9,7,5,3\nCTRIA3,2,5,9,7,5\nCTRIA3,3,6,7,5,3\nENDDATA\n");
  const SurfaceMesh surface = read_surface(path);
  EXPECT_EQ(surface.points.size(), 4u);
  EXPECT_EQ(n_open_sides(surface), 0u);
  EXPECT_DOUBLE_EQ(enclosed_volume(surface), 1.0 / 6);
  EXPECT_EQ(triangles_of_patches(surface), (std::map<std::string, int>{{"pid5", 1}, {"pid6", 1}, {"boundary", 2}}));
}

// Surfaces alone.

/// A cube whose bottom is a patch of its own, and a point that no triangle uses.
SurfaceMesh cube() {
  SurfaceMesh cube = shapes_for_tests::cube();
  cube.patch_names = {};
  const PatchId bottom = cube.patch_names.push_back("bottom"), rest = cube.patch_names.push_back("rest");
  for (std::size_t f = 0; f < cube.faces.size(); ++f) cube.face_patch[FaceId(f)] = f < 2 ? bottom : rest;
  cube.points.push_back(Vec3(0.125, 0.25, 0.375));
  return cube;
}

using Corner = std::array<double, 3>;

/// Triangles by their patch and corners, in the order of the surface.
std::vector<std::pair<std::string, std::vector<Corner>>> in_words(const SurfaceMesh& surface) {
  std::vector<std::pair<std::string, std::vector<Corner>>> faces;
  for (const FaceId f : surface.faces.ids()) {
    auto& face = faces.emplace_back();
    face.first = surface.patch_names[surface.face_patch[f]];
    for (const VertexId v : surface.faces[f]) {
      const Vec3& p = surface.points[v];
      face.second.push_back({p.x(), p.y(), p.z()});
    }
  }
  return faces;
}

TEST(SurfaceAlone, IsReadAsItStands) {
  const SurfaceMesh expected = cube();
  const TemporaryFolder folder;
  folder.file("a.mapbc", files::mapbc(expected));
  const std::map<std::string, std::string> text = {
      {"a.su2", files::su2(expected)},    {"a.ugrid", files::ugrid(expected)}, {"a.msh", files::msh41(expected)},
      {"a.msh2", files::msh22(expected)}, {"b.MSH", files::msh22(expected)},   {"a.nas", files::nastran(expected)},
      {"a.bdf", files::nastran(expected)}};
  for (const auto& [name, bytes] : text) {
    SCOPED_TRACE(name);
    const SurfaceMesh found = read_surface(folder.file(name, bytes));
    EXPECT_EQ(in_words(found), in_words(expected));
    EXPECT_EQ(found.points.size(), 8u) << "the point of no triangle is left out";
    EXPECT_THAT(found.patch_names, ElementsAre("bottom", "rest"));
    EXPECT_NEAR(enclosed_volume(found), 1, 1e-15);
    const auto packed = folder.file(name + ".gz", gzip(bytes));
    if (!name.ends_with(".ugrid")) {
      EXPECT_EQ(in_words(read_surface(packed)), in_words(expected)) << "packed";
    }
  }
}

TEST(SurfaceAlone, IsReadFromCgnsToo) {
  const TemporaryFolder folder;
  write_surface_by_library(folder / "a.cgns", cube());
  EXPECT_EQ(in_words(read_surface(folder / "a.cgns")), in_words(cube()));
}

/// Nobody asks a mesh without cells for neighbours.
class NoNeighbours final : public mesh::NeighbourSource {
 public:
  void read_neighbours(std::size_t, const mesh::CellBatch&, mesh::NeighbourBatch&) const override { ADD_FAILURE(); }
};

TEST(SurfaceAlone, IsReadFromBinaryFilesToo) {
  const SurfaceMesh expected = cube();
  MeshForTests points;
  points.points = expected.points.raw();
  mesh::Boundary boundary;
  for (const std::string& name : expected.patch_names) boundary.patches.push_back({name, mesh::BoundaryType::Wall});
  for (const FaceId f : expected.faces.ids()) {
    const auto& v = expected.faces[f];
    boundary.faces.push_back({v[0].index(), v[1].index(), v[2].index(), mesh::kNoFourthNode});
    boundary.patch.push_back(expected.face_patch[f]);
  }
  const TemporaryFolder folder;
  write_mesh(folder / "a.msh", MeshFormat::Msh, {points, boundary, NoNeighbours(), "cube"}, {});
  EXPECT_EQ(in_words(read_surface(folder / "a.msh")), in_words(expected));
}

TEST(SurfaceAlone, HasQuadsInHalves) {
  const TemporaryFolder folder;
  const auto path = folder.file("a.su2",
                                "NDIME= 3\nNPOIN= 4\n0 0 0\n2 0 0\n2 1 0\n0 1 0\nNELEM= 0\nNMARK= 1\nMARKER_TAG= "
                                "w\nMARKER_ELEMS= 1\n9 0 1 2 3\n");
  const SurfaceMesh surface = read_surface(path);
  EXPECT_EQ(surface.faces.size(), 2u);
  double area = 0;
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    area += 0.5 * cross(b - a, c - a).z();
  }
  EXPECT_DOUBLE_EQ(area, 2);
}

TEST(SurfaceAlone, HasATriangleAtLeast) {
  const TemporaryFolder folder;
  const auto path = folder.file("a.su2", "NDIME= 3\nNPOIN= 3\n0 0 0\n1 0 0\n0 1 0\nNELEM= 0\nNMARK= 0\n");
  EXPECT_THAT([&] { read_surface(path); }, ThrowsMessage<GeometryError>(HasSubstr("a.su2")));
}

TEST(SurfaceAlone, HasNoPointArrays) {
  const TemporaryFolder folder;
  const auto path = folder.file("a.su2", files::su2(cube()));
  EXPECT_TRUE(point_array_names(path).empty());
  const std::vector<std::string> wanted = {"height"};
  EXPECT_THAT([&] { read_surface(path, wanted); },
              ThrowsMessage<PointArrayMissing>(AllOf(HasSubstr(".su2"), HasSubstr("\"height\""))));
}

TEST(SurfaceAlone, IsKnownByItsName) {
  for (const char* name : {"a.su2", "A.SU2.gz", "a.cgns", "a.ugrid", "a.b8.ugrid", "a.lb8.ugrid", "a.msh", "a.msh2",
                           "a.bdf", "a.nas", "a.vtk"}) {
    EXPECT_TRUE(is_surface_name(name)) << name;
  }
  for (const char* name : {"a.vtu", "a.vtkhdf", "su2", "a.ugrid/b"}) EXPECT_FALSE(is_surface_name(name)) << name;
}

TEST(SurfaceFiles, AreAllThatMakeTheSurface) {
  const TemporaryFolder folder;
  EXPECT_THAT(surface_files(folder / "a.stl"), ElementsAre(folder / "a.stl"));
  EXPECT_THAT(surface_files(folder / "a.ugrid"), ElementsAre(folder / "a.ugrid"));
  folder.file("a.mapbc", "");
  for (const char* name : {"a.ugrid", "a.lb8.ugrid", "a.ugrid.gz"}) {
    EXPECT_THAT(surface_files(folder / name), ElementsAre(folder / name, folder / "a.mapbc"));
  }
  EXPECT_THAT(surface_files(folder / "a.su2"), ElementsAre(folder / "a.su2"));
  const auto mesh = folder / "constant/polyMesh";
  std::filesystem::create_directories(mesh);
  for (const char* name : {"points", "owner.gz", "boundary", "notes"})
    folder.file("constant/polyMesh/" + std::string(name), "");
  for (const auto& path : {folder.path(), mesh, folder / "a.foam"}) {
    EXPECT_THAT(surface_files(path), ElementsAre(mesh / "points", mesh / "owner.gz", mesh / "boundary"));
  }
}

// VTK's legacy grids.

/// A tetrahedron under a triangle and a quad, and a line. \param data  of its four cells
std::string grid(const std::string& data) {
  return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n0 0 0 1 0 0 1 1 0 0 1 0 "
         "2 0 0 0 0 -1\nCELLS 4 17\n4 0 2 1 5\n3 1 4 2\n2 0 1\n4 0 1 2 3\nCELL_TYPES 4\n10 5 3 9\n" +
         data;
}

TEST(LegacyGrid, GivesItsTrianglesAndQuads) {
  const TemporaryFolder folder;
  const SurfaceMesh plain = read_surface(folder.file("plain.vtk", grid("")));
  EXPECT_EQ(plain.faces.size(), 3u);
  EXPECT_THAT(plain.patch_names, ElementsAre("surface"));
  for (const char* array : {"Patch", "CellEntityIds"}) {
    const std::string data = std::string("CELL_DATA 4\nSCALARS ") + array + " int 1\nLOOKUP_TABLE default\n9 8 7 6\n";
    const SurfaceMesh surface = read_surface(folder.file("a.vtk", grid(data)));
    EXPECT_THAT(surface.patch_names, ElementsAre("patch6", "patch8")) << array;
    EXPECT_EQ(triangles_of_patches(surface), (std::map<std::string, int>{{"patch6", 2}, {"patch8", 1}}));
    for (const FaceId f : surface.faces.ids()) {
      const auto [a, b, c] = surface.triangle(f);
      EXPECT_GT(cross(b - a, c - a).z(), 0) << "as they stand";
      EXPECT_EQ(surface.patch_names[surface.face_patch[f]], std::max({a.x(), b.x(), c.x()}) > 1 ? "patch8" : "patch6");
    }
  }
}

TEST(LegacyGrid, NamesPatchesAsOursDo) {
  const TemporaryFolder folder;
  const std::string data =
      "FIELD FieldData 1\nPatchNames 1 2 string\nhull\nfin\nCELL_DATA 4\nSCALARS Patch int 1\nLOOKUP_TABLE default\n"
      "0 1 0 0\n";
  EXPECT_THAT(read_surface(folder.file("a.vtk", grid(data))).patch_names, ElementsAre("hull", "fin"));
}

TEST(LegacyGrid, WithCellsAloneIsNoSurface) {
  const TemporaryFolder folder;
  const auto path = folder.file("a.vtk",
                                "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
                                "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
  EXPECT_THAT([&] { read_surface(path); },
              ThrowsMessage<GeometryError>(AllOf(HasSubstr("a.vtk"), HasSubstr("Extract Surface"))));
}

}  // namespace
}  // namespace nearwall::io

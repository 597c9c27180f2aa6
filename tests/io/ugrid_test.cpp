#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "io/mesh_builder.h"
#include "io/volume_formats.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/ugrid_writer.h"
#include "tests/io/solver_files.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using namespace whole_meshes_for_tests;
using namespace volume_meshes_for_tests;
using testing::HasSubstr;

struct Form {
  const char* name;
  UgridForm form;
  const char* ending;
  VolumeFile (*parse)(std::string_view, const std::string&);
  std::size_t n_spare;  ///< bytes that the file can do without at its end
};

const Form kForms[] = {{"Ascii", UgridForm::Ascii, "ugrid", parse_ugrid, 2},
                       {"BigEndian", UgridForm::BigEndian, "b8.ugrid", parse_ugrid_big, 0},
                       {"LittleEndian", UgridForm::LittleEndian, "lb8.ugrid", parse_ugrid_little, 0}};

class Ugrid : public testing::TestWithParam<Form> {
 protected:
  std::filesystem::path grid() const { return folder_ / fmt::format("mesh.{}", GetParam().ending); }
  std::string written(const Stored& mesh) const {
    write_ugrid(grid(), mesh.whole(), GetParam().form);
    EXPECT_EQ(folder_.n_files(), 2u);
    return bytes_of(grid());
  }
  std::string map() const { return bytes_of(folder_ / "mesh.mapbc"); }
  const TemporaryFolder folder_;
};

TEST_P(Ugrid, ReadsBackBitForBit) {
  const Stored mesh = blocks_of_all_types(3);
  written(mesh);
  const VolumeFile file = read_volume_mesh(grid());
  expect_same_cells(file.mesh, mesh.mesh(), cells_by_type(mesh.mesh()));
  expect_same_patches(turned(file.boundary), mesh.boundary(), {"wall__one_", "top", "no faces", "sides"});
  EXPECT_EQ(file.patch_names, std::vector<std::string>({"wall__one_", "top", "sides"}));
  for (const PatchId patch : file.boundary.patches.ids()) {
    constexpr std::array kTypes = {BoundaryType::Wall, BoundaryType::FarField, BoundaryType::Symmetry};
    EXPECT_EQ(file.boundary.patches[patch].type, kTypes[patch.index()]);
  }
}

TEST_P(Ugrid, IsReadWithoutTheNamesBesideIt) {
  const Stored mesh = blocks_of_all_types(1);
  const std::string bytes = written(mesh);
  std::filesystem::remove(folder_ / "mesh.mapbc");
  const VolumeFile file = read_volume_mesh(grid());
  EXPECT_EQ(file.patch_names, std::vector<std::string>({"patch1", "patch2", "patch3"}));
  EXPECT_EQ(file.boundary.patches[PatchId(0)].type, BoundaryType::Other);
}

TEST_P(Ugrid, HasTheSameBytesWhateverThreads) {
  const Stored mesh = blocks_of_all_types(12);
  std::string one;
  {
    const ThreadLimit limit(1);
    one = written(mesh);
  }
  EXPECT_EQ(one == written(mesh), true);
}

TEST_P(Ugrid, WithstandsDamage) {
  const std::string seed = written(blocks_of_all_types(1));
  expect_withstands_damage(GetParam().parse, seed, GetParam().n_spare);
}

/// A source that nobody gets to read.
struct Claims final : mesh::MeshSource {
  NodeIndex points = 0;
  std::array<CellIndex, mesh::kNCellTypes> cells{};

  NodeIndex n_points() const override { return points; }
  CellIndex n_cells() const override { return std::accumulate(cells.begin(), cells.end(), CellIndex{0}); }
  std::array<CellIndex, mesh::kNCellTypes> n_cells_by_type() const override { return cells; }
  std::size_t n_point_batches() const override { return 1; }
  void read_points(std::size_t, mesh::PointBatch&) const override { ADD_FAILURE(); }
  std::size_t n_cell_batches() const override { return 1; }
  void read_cells(std::size_t, mesh::CellBatch&) const override { ADD_FAILURE(); }
};

TEST_P(Ugrid, IsNotBegunWhereNumbersDoNotFit) {
  constexpr std::uint64_t kTooMany = std::uint64_t{1} << 31;
  const Stored stored = blocks_of_all_types(1);
  const auto expect_refused = [&](const mesh::MeshSource& source, const char* message) {
    const WholeMesh whole{source, stored.boundary(), stored.whole().neighbours, "huge"};
    try {
      write_ugrid(grid(), whole, GetParam().form);
      ADD_FAILURE() << message;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
    EXPECT_EQ(folder_.n_files(), 0u);
  };
  Claims points, wedges;
  points.points = kTooMany;
  wedges.cells[static_cast<std::size_t>(CellType::Wedge)] = kTooMany;
  expect_refused(points, "the mesh has 2147483648 points, but UGRID's numbers of 32 bits hold 2147483647 at most");
  expect_refused(wedges, "the mesh has 2147483648 wedges");
}

INSTANTIATE_TEST_SUITE_P(Forms, Ugrid, testing::ValuesIn(kForms), [](const auto& test) { return test.param.name; });

std::string text_of(const Stored& mesh) {
  const TemporaryFolder folder;
  write_ugrid(folder / "mesh.ugrid", mesh.whole(), UgridForm::Ascii);
  return bytes_of(folder / "mesh.ugrid");
}

// AFLR3's figure of the pyramid: its base is 1 4 5 2, counterclockwise seen from the apex 3. Faces look into the mesh.
TEST(WriteUgrid, WritesAPyramidAsTheFormatHasIt) {
  VolumeMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.1, 0.5, 1}};
  add_cell(mesh, CellType::Pyramid, {0, 1, 2, 3, 4});
  EXPECT_EQ(text_of({std::move(mesh), {}}),
            "5 4 1 0 1 0 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.1 0.5 1\n"
            "1 5 2\n2 5 3\n3 5 4\n4 5 1\n1 2 3 4\n1\n1\n1\n1\n1\n1 4 5 2 3\n");
}

TEST(WriteUgrid, WritesBinaryNumbersInTheByteOrderAsked) {
  const TemporaryFolder folder;
  VolumeMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  add_cell(mesh, CellType::Tetrahedron, {0, 1, 2, 3});
  const Stored stored(std::move(mesh), {});
  write_ugrid(folder / "m.b8.ugrid", stored.whole(), UgridForm::BigEndian);
  write_ugrid(folder / "m.lb8.ugrid", stored.whole(), UgridForm::LittleEndian);
  const std::string big = bytes_of(folder / "m.b8.ugrid"), little = bytes_of(folder / "m.lb8.ugrid");
  // 7 counts, 4 points, 4 triangles and their patches, 4 nodes.
  EXPECT_EQ(big.size(), 7 * 4u + 12 * 8u + 16 * 4u + 4 * 4u);
  EXPECT_EQ(big.substr(0, 8), std::string("\0\0\0\4\0\0\0\4", 8));
  EXPECT_EQ(little.substr(0, 8), std::string("\4\0\0\0\4\0\0\0", 8));
  EXPECT_EQ(big.substr(28 + 24, 8), std::string("\x3f\xf0\0\0\0\0\0\0", 8)) << "1.0";
  EXPECT_EQ(little.substr(28 + 24, 8), std::string("\0\0\0\0\0\0\xf0\x3f", 8));
  try {
    parse_ugrid_little(big, "file");
    ADD_FAILURE();
  } catch (const GeometryError& error) {
    EXPECT_THAT(error.what(), HasSubstr("of the other byte order"));
  }
}

/// A cube with a patch on each side: x = 0, 1, y = 0, 1, z = 0, 1.
Stored cube(const std::array<BoundaryPatch, 6>& patches, const std::function<Vec3(const Vec3&)>& map) {
  VolumeMesh mesh = block(1, as_wedges());
  Boundary boundary;
  mesh::fit_boundary(mesh, boundary);
  boundary.patches = {};
  for (const BoundaryPatch& patch : patches) boundary.patches.push_back(patch);
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    const mesh::BoundaryFace& face = boundary.faces[f];
    for (int side = 0; side < 6; ++side) {
      bool is_all = true;
      for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(face)); ++k) {
        is_all &= mesh.points[face[k]][side / 2] == side % 2;
      }
      if (is_all) boundary.patch[f] = PatchId(static_cast<std::size_t>(side));
    }
  }
  return {mapped(std::move(mesh), map), std::move(boundary)};
}

std::string map_of(const Stored& mesh) {
  const TemporaryFolder folder;
  write_ugrid(folder / "mesh.lb8.ugrid", mesh.whole(), UgridForm::LittleEndian);
  return bytes_of(folder / "mesh.mapbc");
}

constexpr BoundaryType kSymmetry = BoundaryType::Symmetry;

TEST(WriteUgrid, WritesConditionsOfFun3d) {
  const auto stays = [](const Vec3& p) { return p; };
  EXPECT_EQ(map_of(cube({{{"left", kSymmetry},
                          {"in", BoundaryType::Inlet},
                          {"back", kSymmetry},
                          {"the rest", BoundaryType::Other},
                          {"low", kSymmetry},
                          {"sky", BoundaryType::FarField}}},
                        stays)),
            "6\n1 6661 left\n2 7011 in\n3 6662 back\n4 0 the_rest\n5 6663 low\n6 5000 sky\n");
}

TEST(WriteUgrid, WritesTangencyForSymmetryPlanesAskewToTheAxes) {
  const auto sheared = [](const Vec3& p) { return Vec3(p.x() + 0.01 * p.y(), p.y(), p.z()); };
  EXPECT_EQ(map_of(cube({{{"left", kSymmetry},
                          {"out", BoundaryType::Outlet},
                          {"back", kSymmetry},
                          {"hull", BoundaryType::Wall},
                          {"a/b", BoundaryType::Wall},
                          {"a_b", BoundaryType::Wall}}},
                        sheared)),
            "6\n1 3000 left\n2 7012 out\n3 6662 back\n4 4000 hull\n5 4000 a_b_2\n6 4000 a_b\n");
}

TEST(ReadUgrid, ReadsASurface) {
  const VolumeFile file = parse_ugrid("5 1 1 0 0 0 0\n0 0 0 1 0 0 1 1 0 0 1 0\n2 1 0\n2 5 3\n1 2 3 4\n7\n-2\n", "file");
  EXPECT_EQ(file.mesh.n_cells(), 0u);
  EXPECT_THAT(file.patch_names, testing::ElementsAre("patch-2", "patch7"));
  const mesh::SurfaceMesh surface = surface_of(file, "file");
  EXPECT_EQ(surface.faces.size(), 3u);
  EXPECT_EQ(surface.patch_names.size(), 2u);
}

TEST(ReadUgrid, SaysWhatIsWrong) {
  const auto message = [](const std::string& text) {
    try {
      parse_ugrid(text, "file");
    } catch (const GeometryError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const std::string points = "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  EXPECT_THAT(message("4 0 0 1 0 0 0" + points + "1 2 3 5\n"), HasSubstr("cell 0 uses point 4 (counted from 0)"));
  EXPECT_THAT(message("4 0 0 1 0 0 0" + points + "1 2 3 0\n"), HasSubstr("file:6: -1 is no number of a point"));
  EXPECT_THAT(message("4 0 0 2147483647 0 0 0" + points), HasSubstr("the header claims a mesh of 17179869"));
  EXPECT_THAT(message("9223372036854775807 0 0 1 0 0 0" + points), HasSubstr("expected the number of points"));
  EXPECT_THAT(message("4 0 0 -1 0 0 0" + points), HasSubstr("expected the number of tetrahedra, found -1"));
  EXPECT_THAT(message("4 0 0 1 0 0 0\n0 0 nan" + points),
              HasSubstr("file:2: expected a coordinate as a finite number"));
}

VolumeFile named(std::vector<std::string> patches, const std::string& mapbc) {
  VolumeFile file;
  for (const std::string& name : patches) file.boundary.patches.push_back({name});
  name_patches(file, mapbc, "m.mapbc");
  return file;
}

TEST(NamePatches, GivesNamesAndTypesByNumber) {
  const VolumeFile file = named({"patch1", "patch2", "patch3", "patch8"},
                                "4\n8 4000 wing 17 \r\n2\t5050\tfar\r\n3 6662\n99 4000 not_in_the_grid\n");
  EXPECT_THAT(file.patch_names, testing::ElementsAre("patch1", "far", "patch3", "wing"));
  EXPECT_THAT(
      file.boundary.patches,
      testing::ElementsAre(BoundaryPatch{"patch1", BoundaryType::Other}, BoundaryPatch{"far", BoundaryType::FarField},
                           BoundaryPatch{"patch3", kSymmetry}, BoundaryPatch{"wing", BoundaryType::Wall}));
}

TEST(NamePatches, KeepsNamesApart) {
  const VolumeFile file = named({"patch1", "patch2", "patch3"}, "2\n1 4000 wing\n2 4000 wing\n");
  EXPECT_THAT(file.patch_names, testing::ElementsAre("wing", "wing_patch2", "patch3"));
}

TEST(NamePatches, RefusesWhatIsNoMap) {
  EXPECT_THROW(named({"patch1"}, ""), GeometryError);
  EXPECT_THROW(named({"patch1"}, "2\n1 4000 wing\n"), GeometryError);
  EXPECT_THROW(named({"patch1"}, "1\n1 viscous wing\n"), GeometryError);
  EXPECT_THROW(named({"patch1"}, "1000000\n1 4000 wing\n"), GeometryError);
  EXPECT_THROW(named({"patch1"}, "-1\n"), GeometryError);
}

TEST(NamePatches, WithstandsDamage) {
  Mutator mutator(41);
  int n_refused = 0;
  for (int round = 0; round < 3000; ++round) {
    try {
      named({"patch1", "patch8"}, mutator.mutated("3\n8 4000 wing\n2 5050 far\n1 6662 symmetry\n"));
    } catch (const GeometryError&) {
      ++n_refused;
    }
  }
  EXPECT_GT(n_refused, 500);
}

}  // namespace
}  // namespace nearwall::io

#include "nearwall/io/mesh_formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "nearwall/core/parallel.h"
#include "nearwall/io/boundary_file.h"
#include "nearwall/io/volume_reader.h"
#include "tests/io/openfoam_meshes.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/whole_meshes.h"

namespace nearwall::io {
namespace {

namespace fs = std::filesystem;
using mesh::BoundaryType;
using testing::ElementsAre;
using whole_meshes_for_tests::Stored;

TEST(MeshFormat, IsKnownByItsName) {
  for (std::size_t i = 0; i < kMeshFormatNames.size(); ++i) {
    const auto format = mesh_format(kMeshFormatNames[i]);
    ASSERT_TRUE(format) << kMeshFormatNames[i];
    EXPECT_EQ(*format, static_cast<MeshFormat>(i));
    EXPECT_EQ(name_of(*format), kMeshFormatNames[i]);
  }
  for (const char* name : {"", "VTU", ".vtu", "foam", "polyMesh", "stl"}) EXPECT_FALSE(mesh_format(name)) << name;
}

TEST(MeshFormat, IsKnownByTheEndingOfAPath) {
  using enum MeshFormat;
  const std::vector<std::pair<const char*, MeshFormat>> known = {{"a.vtu", Vtu},
                                                                 {"out.su2/A.VTU", Vtu},
                                                                 {"a.VtkHdf", Vtkhdf},
                                                                 {"a.cgns", Cgns},
                                                                 {"a.b.SU2", Su2},
                                                                 {"a.ugrid", Ugrid},
                                                                 {"ab8.ugrid", Ugrid},
                                                                 {"a.b8.ugrid", UgridBig},
                                                                 {"a.lb8.ugrid", UgridLittle},
                                                                 {"A.LB8.UGRID", UgridLittle},
                                                                 {"a.msh", Msh},
                                                                 {"a.MSH2", Msh2},
                                                                 {"polyMesh", OpenFoam},
                                                                 {"a/constant/polyMesh", OpenFoam},
                                                                 {"a/constant/polyMesh/", OpenFoam}};
  for (const auto& [path, format] : known) {
    EXPECT_EQ(mesh_format_of(path), format) << path;
  }
  for (const char* path : {"", "a", "a.stl", "a.vtp", "a.vtk", "a.vtu.gz", "vtu", "a.openfoam", "a.openfoam-ascii",
                           "a.msh3", "a.bdf", "a.vtu/b", "xpolyMesh"}) {
    EXPECT_FALSE(mesh_format_of(path)) << path;
  }
}

TEST(MeshFormat, NamesItsFiles) {
  EXPECT_THAT(mesh_file_names("wing", MeshFormat::Vtu), ElementsAre("wing.vtu"));
  EXPECT_THAT(mesh_file_names("wing", MeshFormat::Msh2), ElementsAre("wing.msh2"));
  EXPECT_THAT(mesh_file_names("wing", MeshFormat::Ugrid), ElementsAre("wing.ugrid", "wing.mapbc"));
  EXPECT_THAT(mesh_file_names("wing", MeshFormat::UgridBig), ElementsAre("wing.b8.ugrid", "wing.mapbc"));
  EXPECT_THAT(mesh_file_names("wing.v2", MeshFormat::UgridLittle), ElementsAre("wing.v2.lb8.ugrid", "wing.v2.mapbc"));
  EXPECT_THAT(mesh_file_names("wing", MeshFormat::OpenFoam),
              ElementsAre("wing-openfoam/constant/polyMesh", "wing-openfoam/wing.foam"));
  EXPECT_THAT(mesh_file_names("wing", MeshFormat::OpenFoamAscii),
              ElementsAre("wing-openfoam-ascii/constant/polyMesh", "wing-openfoam-ascii/wing.foam"));
  EXPECT_THAT(files_beside("a/wing.lb8.ugrid", MeshFormat::UgridLittle), ElementsAre(fs::path("a/wing.mapbc")));
  EXPECT_THAT(files_beside("a/wing.su2", MeshFormat::Su2), ElementsAre());
}

/// All cell types, layers, and patches of all types by names that each format takes as they are.
Stored mesh_of_all() {
  const Stored blocks = whole_meshes_for_tests::blocks_of_all_types(2);
  mesh::Boundary boundary = blocks.boundary();
  boundary.patches[PatchId(0)].name = "wall-one";
  const PatchId inlet = boundary.patches.push_back({"in", BoundaryType::Inlet});
  const PatchId outlet = boundary.patches.push_back({"out.let", BoundaryType::Outlet});
  const PatchId other = boundary.patches.push_back({"else_where", BoundaryType::Other});
  const std::array sides = {PatchId(3), inlet, outlet, other};
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    if (boundary.patch[f] == PatchId(3)) boundary.patch[f] = sides[f % 4];
  }
  return {blocks.mesh(), std::move(boundary)};
}

using Cycle = std::vector<NodeIndex>;

/// Faces of each patch that has some; the cycles from their smallest node on.
std::map<std::string, std::multiset<Cycle>> faces_by_patch_name(const mesh::Boundary& boundary) {
  std::map<std::string, std::multiset<Cycle>> faces;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    const auto& face = boundary.faces[f];
    faces[boundary.patches[boundary.patch[f]].name].insert(
        openfoam_meshes::from_smallest({face.begin(), face.begin() + mesh::size_of(face)}));
  }
  return faces;
}

/// What a cell is but for which of its nodes comes first: its type, whether it is of the layers, its faces from
/// outside.
using Cell = std::tuple<mesh::CellType, bool, std::vector<Cycle>>;

std::multiset<Cell> cells_of(const mesh::VolumeMesh& mesh, bool with_layers) {
  std::multiset<Cell> cells;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    cells.insert({mesh.type[c], with_layers && mesh.layer[c] > 0, openfoam_meshes::oriented_faces(mesh, c)});
  }
  return cells;
}

/// The numbers of the cells by which the nodes stand where the format keeps each cell's order of nodes.
std::vector<std::size_t> order_in_file(const mesh::VolumeMesh& mesh, MeshFormat format) {
  std::vector<std::size_t> order(mesh.n_cells());
  for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
  using enum MeshFormat;
  const auto rank = [&](std::size_t c) {
    const int type = static_cast<int>(mesh.type[c]), is_rest = mesh.layer[c] == 0 ? 1 : 0;
    if (format == Ugrid || format == UgridBig || format == UgridLittle) return std::pair(type, is_rest);
    if (format == Cgns || format == Msh || format == Msh2) return std::pair(is_rest, type);
    return std::pair(0, 0);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

class EveryMeshFormat : public testing::TestWithParam<MeshFormat> {
 protected:
  static bool is_openfoam() { return GetParam() == MeshFormat::OpenFoam || GetParam() == MeshFormat::OpenFoamAscii; }
  static bool has_layers() {
    using enum MeshFormat;
    return GetParam() != Su2 && GetParam() != Ugrid && GetParam() != UgridBig && GetParam() != UgridLittle;
  }
  static bool has_types() {
    using enum MeshFormat;
    return GetParam() != Su2 && GetParam() != Msh && GetParam() != Msh2;
  }

  /// \returns  the path of the mesh in a folder of its own
  fs::path write(const Stored& mesh, const std::string& name) const {
    const auto files = mesh_file_names(name, GetParam());
    const fs::path path = folder_.path() / name / files.front();
    fs::create_directories(path.parent_path());
    write_mesh(path, GetParam(), mesh.whole(), {{}, {"wall-one", "top"}});
    return path;
  }

  /// All files of a folder, by their names in it.
  static std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = bytes_of(entry.path());
    }
    return files;
  }

  const TemporaryFolder folder_;
};

TEST_P(EveryMeshFormat, GivesBackPointsAndCells) {
  const Stored mesh = mesh_of_all();
  const VolumeFile file = read_volume_mesh(write(mesh, "m"));
  EXPECT_EQ(file.mesh.points, mesh.mesh().points) << "bit for bit";
  EXPECT_EQ(file.skipped.lines + file.skipped.points, 0u);
  EXPECT_EQ(cells_of(file.mesh, has_layers()), cells_of(mesh.mesh(), has_layers()));
  if (is_openfoam()) return;  // cells are rebuilt from faces there
  const auto order = order_in_file(mesh.mesh(), GetParam());
  ASSERT_EQ(file.mesh.n_cells(), order.size());
  for (std::size_t c = 0; c < order.size(); ++c) {
    ASSERT_EQ(file.mesh.type[c], mesh.mesh().type[order[c]]) << c;
    ASSERT_TRUE(std::ranges::equal(file.mesh.nodes_of(c), mesh.mesh().nodes_of(order[c]))) << "cell " << c;
  }
}

TEST_P(EveryMeshFormat, GivesBackTheLayersIfItKnowsGroups) {
  const Stored mesh = mesh_of_all();
  const VolumeFile file = read_volume_mesh(write(mesh, "m"));
  const auto n_layers = [](const mesh::VolumeMesh& m) {
    return std::count_if(m.layer.begin(), m.layer.end(), [](std::int32_t layer) { return layer > 0; });
  };
  EXPECT_EQ(n_layers(file.mesh), has_layers() ? n_layers(mesh.mesh()) : 0);
}

TEST_P(EveryMeshFormat, GivesBackPatchesWithTheirFaces) {
  const Stored mesh = mesh_of_all();
  const VolumeFile file = read_volume_mesh(write(mesh, "m"));
  if (!has_boundary(GetParam())) {
    EXPECT_TRUE(file.boundary.faces.empty());
    EXPECT_THAT(file.patch_names, ElementsAre("wall-one", "top"));
    return;
  }
  mesh::Boundary boundary = file.boundary;
  const mesh::BoundaryChanges changes = mesh::fit_boundary(file.mesh, boundary);
  EXPECT_EQ(changes.n_dropped + changes.n_added, 0u);
  EXPECT_EQ(faces_by_patch_name(boundary), faces_by_patch_name(mesh.boundary()));
  std::map<std::string, BoundaryType> type;
  for (const mesh::BoundaryPatch& patch : mesh.boundary().patches) type[patch.name] = patch.type;
  const auto faces = mesh::faces_by_patch(file.boundary);
  for (const PatchId patch : file.boundary.patches.ids()) {
    if (faces[patch].empty()) continue;
    const auto& [name, found] = file.boundary.patches[patch];
    EXPECT_EQ(found, has_types() ? type[name] : BoundaryType::Other) << name;
  }
}

TEST_P(EveryMeshFormat, WritesNoOtherFilesThanItNames) {
  const fs::path path = write(mesh_of_all(), "m");
  std::set<fs::path> expected = {path};
  for (const fs::path& beside : files_beside(path, GetParam())) expected.insert(beside);
  std::set<fs::path> found;
  for (const auto& entry : fs::directory_iterator(path.parent_path())) found.insert(entry.path());
  EXPECT_EQ(found, expected);
}

TEST_P(EveryMeshFormat, WritesTheSameBytesAtAnyNumberOfThreads) {
  // Several batches of cells.
  const auto mesh = whole_meshes_for_tests::blocks_of_all_types(17);
  write(mesh, "m");
  const auto several = contents(folder_ / "m");
  fs::remove_all(folder_ / "m");
  const ThreadLimit one(1);
  write(mesh, "m");
  EXPECT_TRUE(contents(folder_ / "m") == several);
  EXPECT_FALSE(several.empty());
}

TEST_P(EveryMeshFormat, ReplacesAnOlderMesh) {
  write(whole_meshes_for_tests::blocks_of_all_types(3), "m");
  const Stored mesh = mesh_of_all();
  const VolumeFile file = read_volume_mesh(write(mesh, "m"));
  EXPECT_EQ(file.mesh.points, mesh.mesh().points);
}

std::vector<MeshFormat> all_formats() {
  std::vector<MeshFormat> formats;
  for (std::size_t i = 0; i < kMeshFormatNames.size(); ++i) formats.push_back(static_cast<MeshFormat>(i));
  return formats;
}

std::string readable(const testing::TestParamInfo<MeshFormat>& test) {
  std::string name(name_of(test.param));
  for (char& c : name) c = c == '.' || c == '-' ? '_' : c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(MeshFormats, EveryMeshFormat, testing::ValuesIn(all_formats()), readable);

}  // namespace
}  // namespace nearwall::io

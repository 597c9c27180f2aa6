// Meshes of runs in all formats that a case may ask for, and surfaces that come from such formats.
#include <stdlib.h>

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/boundary_file.h"
#include "nearwall/io/mesh_formats.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/surface_writer.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/mesh/volume_neighbours.h"
#include "nearwall/pipeline/run.h"
#include "tests/pipeline/scratch_folder.h"
#include "tests/support/shapes.h"
#include "tests/support/surface_files.h"

namespace nearwall {
namespace {

namespace fs = std::filesystem;
namespace files = surface_files_for_tests;
using mesh::SurfaceMesh;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;
using Json = nlohmann::json;

const std::string kFilled = "[volume]\nfill = \"tetgen\"\nfarfield = { radius = 6, size = 2 }\n";

std::string formats(const std::vector<std::string>& names) { return "formats = " + Json(names).dump() + "\n"; }

std::string all_formats() { return formats({io::kMeshFormatNames.begin(), io::kMeshFormatNames.end()}); }

class Formats : public testing::Test {
 protected:
  void SetUp() override { ::setenv("NEARWALL_TETGEN", NEARWALL_TETGEN_PROGRAM, 1); }
  void TearDown() override { ::unsetenv("NEARWALL_TETGEN"); }

  /// Three layers on a surface. \param output  further keys of [output] \param more  further tables
  Report meshed(const std::string& surface, const std::string& output, const std::string& more = "",
                const std::string& of_surface = "") const {
    folder_.write("case.toml", "name = \"body\"\n[surface]\nfile = \"" + surface + "\"\n" + of_surface +
                                   "[layers]\nfirst_height = 0.01\ncount = 3\n[output]\npictures = false\n" + output +
                                   more);
    return run(read_case(folder_ / "case.toml"));
  }
  Report meshed(const SurfaceMesh& surface, const std::string& output, const std::string& more = "") const {
    io::write_surface(folder_ / "body.vtp", surface);
    return meshed("body.vtp", output, more);
  }
  fs::path out(const std::string& file) const { return folder_ / "out" / file; }
  bool has(const std::string& file) const { return fs::exists(out(file)); }

  /// All files of the folder by their names in it, but for the reports.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(out(""))) {
      const std::string name = entry.path().lexically_relative(out("")).string();
      if (entry.is_regular_file() && !name.starts_with("report")) all[name] = folder_.read("out/" + name);
    }
    return all;
  }

  ScratchFolder folder_;
};

using Corners = std::vector<std::array<double, 3>>;

/// Corners in an order that does not depend on that of the nodes.
template <class Nodes>
Corners corners_of(const mesh::VolumeMesh& mesh, const Nodes& nodes) {
  Corners corners;
  for (const auto node : nodes)
    corners.push_back({mesh.points[node].x(), mesh.points[node].y(), mesh.points[node].z()});
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// What a mesh is whatever the order of its points, cells and faces: type and corners of cells, patch and corners of
/// faces, types of patches.
struct Contents {
  std::multiset<std::pair<mesh::CellType, Corners>> cells;
  std::multiset<Corners> layers;
  std::multiset<std::pair<std::string, Corners>> faces;
  std::map<std::string, mesh::BoundaryType> types;
};

Contents contents_of(const mesh::VolumeMesh& mesh, const mesh::Boundary& boundary) {
  Contents all;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    EXPECT_GT(mesh::cell_volume(mesh.type[c], mesh.corners_of(c)), 0) << c;
    const Corners corners = corners_of(mesh, mesh.nodes_of(c));
    all.cells.emplace(mesh.type[c], corners);
    if (!mesh.layer.empty() && mesh.layer[c] > 0) all.layers.insert(corners);
  }
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    const auto& face = boundary.faces[f];
    const mesh::BoundaryPatch& patch = boundary.patches[boundary.patch[f]];
    const std::span nodes(face.data(), static_cast<std::size_t>(mesh::size_of(face)));
    all.faces.emplace(patch.name, corners_of(mesh, nodes));
    all.types[patch.name] = patch.type;
  }
  return all;
}

/// Reads each format back and holds it against the .vtu with its boundary file.
void expect_all_alike(const fs::path& folder) {
  const mesh::VolumeMesh vtu = io::read_volume_mesh(folder / "body.vtu").mesh;
  const mesh::Boundary boundary = io::read_boundary(folder / "body-boundary.vtp", vtu.points.size());
  const Contents expected = contents_of(vtu, boundary);
  EXPECT_FALSE(expected.layers.empty());
  mesh::Boundary complete = boundary;
  const mesh::BoundaryChanges changes = mesh::fit_boundary(vtu, complete);
  EXPECT_EQ(changes.n_added + changes.n_dropped, 0u) << "each face of one cell alone is in one patch";
  for (std::size_t i = 1; i < io::kMeshFormatNames.size(); ++i) {
    const auto format = static_cast<io::MeshFormat>(i);
    SCOPED_TRACE(io::name_of(format));
    const io::VolumeFile file = io::read_volume_mesh(folder / io::mesh_file_names("body", format).front());
    EXPECT_EQ(file.mesh.points, vtu.points) << "bit for bit";
    const Contents found = contents_of(file.mesh, io::has_boundary(format) ? file.boundary : boundary);
    EXPECT_TRUE(found.cells == expected.cells);
    EXPECT_TRUE(found.faces == expected.faces);
    const bool has_groups = format != io::MeshFormat::Su2 && io::files_beside("a", format).empty();
    EXPECT_TRUE(!has_groups || found.layers == expected.layers);
    using enum io::MeshFormat;
    const bool has_types = format != Su2 && format != Msh && format != Msh2;
    EXPECT_TRUE(!has_types || found.types == expected.types);
  }
}

void expect_listed(const Report& report, const fs::path& folder) {
  const Json json = Json::parse(std::ifstream(folder / "report.json"));
  const auto listed = json["files"].get<std::vector<std::string>>();
  EXPECT_EQ(listed, report.files);
  for (const auto& name : io::kMeshFormatNames) {
    for (const std::string& file : io::mesh_file_names("body", *io::mesh_format(name))) {
      EXPECT_THAT(listed, Contains(file).Times(1));
      EXPECT_TRUE(fs::exists(folder / file)) << file;
    }
  }
}

TEST_F(Formats, OfLayersAloneAreAllTheSameMesh) {
  const Report report = meshed(shapes_for_tests::sphere(1), all_formats());
  EXPECT_EQ(report.n_cells(), 3u * 32);
  expect_listed(report, out(""));
  expect_all_alike(out(""));
  const auto file = io::read_volume_mesh(out("body.cgns"));
  std::vector<std::string> names;
  for (const auto& patch : file.boundary.patches) names.push_back(patch.name);
  EXPECT_THAT(names, UnorderedElementsAre("wall", "front"));
}

TEST_F(Formats, OfAFilledVolumeAreAllTheSameMesh) {
  const Report report = meshed(shapes_for_tests::cube(), all_formats(), kFilled);
  ASSERT_TRUE(report.volume) << report.volume_failure;
  expect_listed(report, out(""));
  expect_all_alike(out(""));
  for (const char* name : {"body.cgns", "body.lb8.ugrid", "body-openfoam", "body-openfoam-ascii/constant/polyMesh"}) {
    const auto file = io::read_volume_mesh(out(name));
    std::map<std::string, mesh::BoundaryType> types;
    for (const auto& patch : file.boundary.patches) types[patch.name] = patch.type;
    EXPECT_EQ(types, (std::map<std::string, mesh::BoundaryType>{{"wall", mesh::BoundaryType::Wall},
                                                                {"farfield", mesh::BoundaryType::FarField}}))
        << name;
  }
}

/// A corner with several lines gives cells of all types, and layers of uneven height windows of quads.
TEST_F(Formats, OfFansAndUnevenLayersAreAllTheSameMesh) {
  SurfaceMesh body = shapes_for_tests::subdivided(shapes_for_tests::l_step());
  const PatchId bare = body.patch_names.push_back("bare");
  for (const FaceId f : body.faces.ids()) {
    const auto [a, b, c] = body.triangle(f);
    if (std::min({a.x(), b.x(), c.x()}) == 2) body.face_patch[f] = bare;
  }
  const std::string more = "[normals]\nmulti_angle = 80\n[patches.bare]\ntype = \"nolayer\"\n";
  meshed(body, all_formats(), more);
  expect_all_alike(out(""));
  const Report filled = meshed(body, all_formats(), more + "[volume]\nfill = \"tetgen\"\nfarfield = { radius = 12 }\n");
  ASSERT_TRUE(filled.volume) << filled.volume_failure;
  for (const CellIndex n : {filled.cells[0], filled.cells[1], filled.cells[2]}) EXPECT_GT(n, 0u);
  expect_all_alike(out(""));
}

TEST_F(Formats, OfALumenWithCapsKeepTheSidesThatLayersLandOn) {
  SurfaceMesh room = shapes_for_tests::subdivided(shapes_for_tests::subdivided(shapes_for_tests::cube()));
  const PatchId inlet = room.patch_names.push_back("in flow"), side = room.patch_names.push_back("side");
  for (const FaceId f : room.faces.ids()) {
    const auto [a, b, c] = room.triangle(f);
    const Vec3 middle = (a + b + c) / 3;
    if (middle.x() == 0.5) room.face_patch[f] = inlet;
    if (middle.x() == -0.5) room.face_patch[f] = side;
  }
  io::write_surface(folder_ / "room.vtp", room);
  const Report report = meshed("room.vtp", formats({"vtu", "su2", "openfoam", "cgns"}),
                               "[volume]\nfill = \"tetgen\"\n[patches.\"in flow\"]\ntype = \"inlet\"\n[patches.side]\n"
                               "type = \"symmetry\"\n",
                               "fluid = \"inside\"\n");
  ASSERT_TRUE(report.volume) << report.volume_failure;
  const mesh::VolumeMesh vtu = io::read_volume_mesh(out("body.vtu")).mesh;
  const Contents expected =
      contents_of(vtu, io::read_boundary(out("body-boundary.vtp"), static_cast<NodeIndex>(vtu.points.size())));
  const auto found = [&](const char* name) {
    const auto file = io::read_volume_mesh(out(name));
    return contents_of(file.mesh, file.boundary);
  };
  EXPECT_TRUE(found("body.cgns").faces == expected.faces);
  EXPECT_EQ(found("body.cgns").types, expected.types);
  EXPECT_EQ(found("body-openfoam").types,
            (std::map<std::string, mesh::BoundaryType>{{"wall", mesh::BoundaryType::Wall},
                                                       {"in_flow", mesh::BoundaryType::Inlet},
                                                       {"side", mesh::BoundaryType::Symmetry}}));
  EXPECT_THAT(found("body.su2").types, Contains(testing::Key("in_flow")));
}

TEST_F(Formats, LeaveThePatchFrontToTheSurfaceThatHasIt) {
  SurfaceMesh body = shapes_for_tests::cube();
  body.patch_names[PatchId(0)] = "front";
  meshed(body, formats({"vtu", "su2"}));
  const auto file = io::read_volume_mesh(out("body.su2"));
  EXPECT_THAT(file.patch_names, UnorderedElementsAre("front", "front2"));
  const auto faces = mesh::faces_by_patch(file.boundary);
  for (const PatchId patch : file.boundary.patches.ids()) {
    for (const std::uint32_t f : faces[patch]) {
      // The wall's triangles are the only ones with all corners at half an edge's length from the middle planes.
      bool is_wall = true;
      for (const int k : {0, 1, 2}) {
        const Vec3& p = file.mesh.points[file.boundary.faces[f][static_cast<std::size_t>(k)]];
        is_wall = is_wall && std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) == 0.5;
      }
      EXPECT_EQ(is_wall, file.boundary.patches[patch].name == "front");
    }
  }
}

TEST_F(Formats, AreThoseAskedForOnceEach) {
  const Report report = meshed(shapes_for_tests::cube(), formats({"su2", "msh2", "su2"}));
  EXPECT_FALSE(has("body.vtu"));
  EXPECT_TRUE(has("body.msh2"));
  EXPECT_EQ(std::count(report.files.begin(), report.files.end(), "body.su2"), 1);
  EXPECT_EQ(io::read_volume_mesh(out("body.su2")).mesh.n_cells(), 36u);
  // Another run without them leaves none of them behind.
  meshed(shapes_for_tests::cube(), formats({"b8.ugrid"}));
  EXPECT_FALSE(has("body.su2"));
  EXPECT_FALSE(has("body.msh2"));
  EXPECT_TRUE(has("body.b8.ugrid"));
  EXPECT_TRUE(has("body.mapbc"));
  meshed(shapes_for_tests::cube(), "");
  EXPECT_FALSE(has("body.mapbc"));
  EXPECT_TRUE(has("body.vtu"));
}

TEST_F(Formats, ThatAreNoneAreRefusedWithTheKnownOnes) {
  for (const char* bad : {"[\"vtk\"]", "\"vtu\"", "[]", "[1]", "[\"VTU\"]"}) {
    try {
      meshed(shapes_for_tests::cube(), std::string("formats = ") + bad + "\n");
      ADD_FAILURE() << bad;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr("formats"));
    }
    EXPECT_FALSE(has("body.vtu"));
  }
}

TEST_F(Formats, OfOpenfoamLeaveASolversFilesAlone) {
  meshed(shapes_for_tests::cube(), formats({"openfoam"}));
  fs::create_directories(out("body-openfoam/system"));
  fs::create_directories(out("body-openfoam/constant/triSurface"));
  folder_.write("out/body-openfoam/system/controlDict", "mine");
  folder_.write("out/body-openfoam/constant/transportProperties", "mine, too");
  folder_.write("out/body-openfoam/constant/polyMesh/sets", "of the older mesh");
  const std::string points = folder_.read("out/body-openfoam/constant/polyMesh/points");
  meshed(shapes_for_tests::sphere(1), formats({"openfoam", "vtu"}));
  EXPECT_EQ(folder_.read("out/body-openfoam/system/controlDict"), "mine");
  EXPECT_EQ(folder_.read("out/body-openfoam/constant/transportProperties"), "mine, too");
  EXPECT_NE(folder_.read("out/body-openfoam/constant/polyMesh/points"), points);
  EXPECT_FALSE(has("body-openfoam/constant/polyMesh/sets")) << "the folder is that of one mesh";
  EXPECT_EQ(io::read_volume_mesh(out("body-openfoam")).mesh.n_cells(), 3u * 32);
  meshed(shapes_for_tests::cube(), formats({"vtu"}));
  EXPECT_FALSE(has("body-openfoam/constant/polyMesh"));
  EXPECT_FALSE(has("body-openfoam/body.foam"));
  EXPECT_EQ(folder_.read("out/body-openfoam/system/controlDict"), "mine");
  EXPECT_EQ(folder_.read("out/body-openfoam/constant/transportProperties"), "mine, too");
  meshed(shapes_for_tests::cube(), formats({"vtu", "openfoam"}));
  EXPECT_EQ(io::read_volume_mesh(out("body-openfoam")).mesh.n_cells(), 36u);
}

TEST_F(Formats, OfOpenfoamLeaveNoEmptyFolderBehind) {
  meshed(shapes_for_tests::cube(), formats({"openfoam", "openfoam-ascii"}));
  EXPECT_TRUE(has("body-openfoam-ascii/body.foam"));
  meshed(shapes_for_tests::cube(), formats({"vtu"}));
  EXPECT_FALSE(has("body-openfoam"));
  EXPECT_FALSE(has("body-openfoam-ascii"));
}

TEST_F(Formats, AreLeftOutWhereTheVolumeCannotBeHad) {
  ::setenv("NEARWALL_TETGEN", "/bin/false", 1);
  const Report report = meshed(shapes_for_tests::cube(), all_formats(), kFilled);
  EXPECT_NE(report.volume_failure, "");
  std::vector<std::string> found;
  for (const auto& [name, bytes] : contents()) found.push_back(name);
  EXPECT_THAT(
      found, UnorderedElementsAre("body-layers.vtu", "body-layers-boundary.vtp", "body-surface.vtp", "body-front.vtp"));
  const mesh::VolumeMesh layers = io::read_volume_mesh(out("body-layers.vtu")).mesh;
  mesh::Boundary boundary = io::read_boundary(out("body-layers-boundary.vtp"), layers.points.size());
  EXPECT_EQ(boundary.faces.size(), 24u) << "wall and front";
  const mesh::BoundaryChanges changes = mesh::fit_boundary(layers, boundary);
  EXPECT_EQ(changes.n_added + changes.n_dropped, 0u);
}

TEST_F(Formats, HaveTheSameBytesAtAnyNumberOfThreads) {
  for (const std::string& fill : {std::string(), kFilled}) {
    meshed(shapes_for_tests::sphere(2), all_formats(), fill);
    const auto several = contents();
    const ThreadLimit one(1);
    meshed(shapes_for_tests::sphere(2), all_formats(), fill);
    const auto single = contents();
    ASSERT_EQ(several.size(), single.size());
    for (const auto& [name, bytes] : several) EXPECT_TRUE(single.at(name) == bytes) << name;
  }
}

TEST_F(Formats, CountForTheQuestionWhetherARunIsUpToDate) {
  meshed(shapes_for_tests::cube(), formats({"vtu", "openfoam"}));
  const Case settings = read_case(folder_ / "case.toml");
  EXPECT_TRUE(is_up_to_date(settings, {}));
  const std::vector<std::string> other = {"output.formats=[\"vtu\"]"};
  EXPECT_FALSE(is_up_to_date(read_case(folder_ / "case.toml", other), {}));
  fs::remove_all(out("body-openfoam/constant/polyMesh"));
  EXPECT_FALSE(is_up_to_date(settings, {}));
}

// Surfaces from solvers' formats.

TEST_F(Formats, OfSurfacesMakeNoDifferenceToTheMesh) {
  const SurfaceMesh body = shapes_for_tests::translated(shapes_for_tests::cube(), {0.125, 0, 0});
  folder_.write("body.su2", files::su2(body));
  folder_.write("body.msh", files::msh41(body));
  folder_.write("body.msh2", files::msh22(body));
  folder_.write("body.ugrid", files::ugrid(body));
  folder_.write("body.mapbc", files::mapbc(body));
  folder_.write("body.bdf", files::nastran(body));
  // The points come in the order in which the triangles name them.
  io::write_surface(folder_ / "body.ply", io::read_surface(folder_ / "body.su2"));
  meshed("body.ply", formats({"vtu"}));
  const auto expected = contents();
  EXPECT_EQ(expected.size(), 4u);
  for (const char* name : {"body.su2", "body.msh", "body.msh2", "body.ugrid", "body.bdf"}) {
    EXPECT_EQ(meshed(name, formats({"vtu"})).n_cells(), 36u);
    EXPECT_TRUE(contents() == expected) << name;
  }
}

TEST_F(Formats, OfSurfacesInFoldersAreLookedIntoForChanges) {
  meshed(shapes_for_tests::cube(), formats({"openfoam"}), kFilled);
  fs::rename(out("body-openfoam"), folder_ / "domain");
  const auto settings = [&] {
    meshed("domain", "", "", "fluid = \"inside\"\n");
    return read_case(folder_ / "case.toml");
  }();
  EXPECT_TRUE(is_up_to_date(settings, {}));
  const std::string boundary = folder_.read("domain/constant/polyMesh/boundary");
  folder_.write("domain/constant/polyMesh/boundary", boundary + "// another\n");
  EXPECT_FALSE(is_up_to_date(settings, {}));
}

TEST_F(Formats, OfOurMeshesAreSurfacesOfTheSameDomain) {
  const Report first = meshed(shapes_for_tests::cube(), all_formats(), kFilled);
  ASSERT_TRUE(first.volume) << first.volume_failure;
  const double volume = first.volume->certificate.enclosed_volume;
  for (const std::string name :
       {"body.cgns", "body.su2", "body.lb8.ugrid", "body.msh", "body-openfoam/constant/polyMesh"}) {
    SCOPED_TRACE(name);
    const Report again = run(
        read_case(folder_.write("again.toml", "name = \"again\"\n[surface]\nfile = \"out/" + name +
                                                  "\"\nfluid = \"inside\"\n[layers]\nfirst_height = 0.01\ncount = "
                                                  "3\n[patches.farfield]\ntype = \"farfield\"\n[volume]\nfill = "
                                                  "\"tetgen\"\nfarfield = { shape = \"given\" }\n[output]\npictures "
                                                  "= false\n")),
        {folder_ / "again", false, false});
    ASSERT_TRUE(again.volume) << again.volume_failure;
    EXPECT_NEAR(again.volume->certificate.enclosed_volume, volume, 1e-12 * volume);
    EXPECT_EQ(again.patches.size(), 2u);
  }
}

}  // namespace
}  // namespace nearwall

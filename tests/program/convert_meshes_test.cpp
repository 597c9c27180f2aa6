#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

#include "nearwall/io/boundary_file.h"
#include "nearwall/io/mesh_formats.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/volume_reader.h"
#include "tests/program/workplace.h"
#include "tests/support/whole_meshes.h"

namespace nearwall::program {
namespace {

namespace fs = std::filesystem;
using io::MeshFormat;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using whole_meshes_for_tests::Stored;

// Cells of all types, some of the layers; patches "one", "top" and "sides".
Stored small_mesh() {
  const Stored blocks = whole_meshes_for_tests::blocks_of_all_types(2);
  mesh::Boundary boundary = blocks.boundary();
  boundary.patches[PatchId(0)].name = "one";
  return {blocks.mesh(), std::move(boundary)};
}

/// Writes it as `convert` would name it. \returns the path
std::string write(const Workplace& place, const std::string& name, const Stored& mesh) {
  const MeshFormat format = *io::mesh_format_of(name);
  const fs::path path = place.path(name);
  fs::create_directories(path.parent_path());
  io::write_mesh(path, format, mesh.whole(), {});
  if (!io::has_boundary(format)) {
    io::write_polydata(io::boundary_file_of(path), io::boundary_polydata(mesh.boundary(), [&](NodeIndex node) {
                         return mesh.mesh().points[node];
                       }));
  }
  return name;
}

/// A file of each format, and a folder polyMesh.
std::vector<std::string> all_names(const std::string& stem) {
  std::vector<std::string> names;
  for (const auto& ending : io::kMeshFormatNames) {
    if (!ending.starts_with("openfoam")) names.push_back(stem + "." + std::string(ending));
  }
  names.push_back(stem + "/polyMesh");
  return names;
}

/// Corners of a cell or face by their coordinates, whatever the order of nodes: the cells of the blocks are convex and
/// right, so corners, type and a positive volume say which cell it is.
using Corners = std::vector<std::array<double, 3>>;

template <class Nodes>
Corners corners_of(const mesh::VolumeMesh& mesh, const Nodes& nodes) {
  Corners corners;
  for (const auto node : nodes) {
    const Vec3& p = mesh.points[node];
    corners.push_back({p.x(), p.y(), p.z()});
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

std::multiset<std::pair<mesh::CellType, Corners>> cells_of(const mesh::VolumeMesh& mesh) {
  std::multiset<std::pair<mesh::CellType, Corners>> cells;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    EXPECT_GT(mesh::cell_volume(mesh.type[c], mesh.corners_of(c)), 0);
    cells.emplace(mesh.type[c], corners_of(mesh, mesh.nodes_of(c)));
  }
  return cells;
}

std::multiset<std::pair<std::string, Corners>> faces_of(const mesh::VolumeMesh& mesh, const mesh::Boundary& boundary) {
  std::multiset<std::pair<std::string, Corners>> faces;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    const auto& face = boundary.faces[f];
    const std::span nodes(face.data(), static_cast<std::size_t>(mesh::size_of(face)));
    faces.emplace(boundary.patches[boundary.patch[f]].name, corners_of(mesh, nodes));
  }
  return faces;
}

void expect_same(const fs::path& path, const Stored& mesh) {
  io::VolumeFile file = io::read_volume_mesh(path);
  EXPECT_EQ(file.mesh.points, mesh.mesh().points) << "bit for bit";
  EXPECT_EQ(cells_of(file.mesh), cells_of(mesh.mesh()));
  if (!io::has_named_faces(path)) {
    file.boundary = io::read_boundary(io::boundary_file_of(path), file.mesh.points.size());
  }
  EXPECT_EQ(faces_of(file.mesh, file.boundary), faces_of(mesh.mesh(), mesh.boundary()));
}

TEST(ConvertMeshes, FromEachFormatToEachOther) {
  const Stored mesh = small_mesh();
  Workplace place;
  for (const std::string& from : all_names("from")) {
    write(place, from, mesh);
    for (const std::string& to : all_names("to")) {
      SCOPED_TRACE(from + " " + to);
      const Outcome outcome = place.run({"convert", from, to});
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_THAT(outcome.err, Not(HasSubstr("patch"))) << "all faces have one";
      expect_same(place.path(to), mesh);
    }
  }
}

TEST(ConvertMeshes, KeepsTypesAndLayersWhereBothFormatsHaveThem) {
  const Stored mesh = small_mesh();
  Workplace place;
  write(place, "a.vtu", mesh);
  std::string last = "a.vtu";
  for (const char* step : {"a.cgns", "case/constant/polyMesh", "b.vtkhdf", "b.vtu"}) {
    ASSERT_EQ(place.run({"convert", last, step}).exit_code, 0) << step;
    last = step;
  }
  const io::VolumeFile file = io::read_volume_mesh(place.path("b.vtu"));
  const auto n_layers = [](const mesh::VolumeMesh& m) {
    return std::count_if(m.layer.begin(), m.layer.end(), [](std::int32_t layer) { return layer > 0; });
  };
  EXPECT_EQ(n_layers(file.mesh), n_layers(mesh.mesh()));
  const mesh::Boundary boundary = io::read_boundary(place.path("b-boundary.vtp"), file.mesh.points.size());
  std::map<std::string, mesh::BoundaryType> types;
  for (const mesh::BoundaryPatch& patch : mesh.boundary().patches) types[patch.name] = patch.type;
  for (const mesh::BoundaryPatch& patch : boundary.patches) EXPECT_EQ(patch.type, types.at(patch.name)) << patch.name;
}

TEST(ConvertMeshes, TellsWhatItWroteInJson) {
  const Stored mesh = small_mesh();
  Workplace place;
  write(place, "a.vtu", mesh);
  const Outcome outcome = place.run({"convert", "a.vtu", "b.lb8.ugrid", "--json"});
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["file"], "b.lb8.ugrid");
  EXPECT_EQ(result["files"], (json{"b.lb8.ugrid", "b.mapbc"}));
  EXPECT_EQ(result["points"], 3 * 27 + 9);
  EXPECT_EQ(result["cells"]["hexahedron"], 8);
  EXPECT_EQ(result["cells"]["wedge"], 16);
  EXPECT_EQ(result["cells"]["tetrahedron"], 48);
  EXPECT_EQ(result["cells"]["pyramid"], 6);
  EXPECT_EQ(result["boundary_faces"], mesh.boundary().faces.size());
  ASSERT_GE(result["patches"].size(), 3u);
  EXPECT_EQ(result["patches"][0], (json{{"name", "one"}, {"type", "wall"}}));
  EXPECT_EQ(json::parse(place.run({"convert", "b.lb8.ugrid", "c.vtu", "--json"}).out)["files"],
            (json{"c.vtu", "c-boundary.vtp"}));
}

TEST(ConvertMeshes, SaysWhereThereAreNoPatches) {
  const Stored mesh = small_mesh();
  Workplace place;
  write(place, "a.vtu", mesh);
  fs::rename(place.path("a-boundary.vtp"), place.path("patches.vtp"));
  const Outcome without = place.run({"convert", "a.vtu", "b.su2", "--json"});
  EXPECT_EQ(without.exit_code, 0) << without.err;
  EXPECT_THAT(without.err, HasSubstr("a-boundary.vtp is not there: the boundary will be one patch"));
  EXPECT_EQ(json::parse(without.out)["patches"], (json::array({{{"name", "boundary"}, {"type", "other"}}})));
  const Outcome given = place.run({"convert", "a.vtu", "b.su2", "--boundary", "patches.vtp"});
  EXPECT_EQ(given.exit_code, 0) << given.err;
  EXPECT_THAT(given.err, Not(HasSubstr("patch")));
  expect_same(place.path("b.su2"), mesh);
}

TEST(ConvertMeshes, LeavesTheBoundaryBesideBothAsItIs) {
  const Stored mesh = small_mesh();
  Workplace place;
  write(place, "a.vtu", mesh);
  auto boundary = io::boundary_polydata(mesh.boundary(), [&](NodeIndex node) { return mesh.mesh().points[node]; });
  boundary.triangle_data.push_back({"Triangle", std::vector<std::int32_t>(mesh.boundary().faces.size(), 7)});
  io::write_polydata(place.path("a-boundary.vtp"), boundary);
  const std::string before = place.read("a-boundary.vtp");
  ASSERT_EQ(place.run({"convert", "a.vtu", "a.vtkhdf"}).exit_code, 0);
  EXPECT_EQ(place.read("a-boundary.vtp"), before);
  ASSERT_EQ(place.run({"convert", "a.vtu", "b.vtkhdf"}).exit_code, 0);
  EXPECT_TRUE(place.has("b-boundary.vtp"));
  expect_same(place.path("a.vtkhdf"), mesh);
}

TEST(ConvertMeshes, RefusesTheBoundaryOfAnotherMesh) {
  Workplace place;
  write(place, "a.vtu", small_mesh());
  write(place, "large.vtu", whole_meshes_for_tests::blocks_of_all_types(4));
  const Outcome outcome = place.run({"convert", "a.vtu", "b.su2", "--boundary", "large-boundary.vtp"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("belongs to another mesh"));
  EXPECT_EQ(place.run({"convert", "a.vtu", "b.su2", "--boundary", "none.vtp"}).exit_code, 2);
  EXPECT_FALSE(place.has("b.su2"));
}

TEST(ConvertMeshes, WritesPolyMeshAsTextIfAsked) {
  const Stored mesh = small_mesh();
  Workplace place;
  write(place, "a.msh", mesh);
  ASSERT_EQ(place.run({"convert", "a.msh", "text/constant/polyMesh/", "--ascii"}).exit_code, 0);
  EXPECT_THAT(place.read("text/constant/polyMesh/points"), HasSubstr("ascii"));
  ASSERT_EQ(place.run({"convert", "a.msh", "binary/constant/polyMesh"}).exit_code, 0);
  EXPECT_THAT(place.read("binary/constant/polyMesh/points"), HasSubstr("binary"));
  expect_same(place.path("text"), mesh);
  expect_same(place.path("binary/constant/polyMesh/"), mesh);
}

TEST(ConvertMeshes, GivesTheBoundaryAsASurface) {
  const Stored mesh = small_mesh();
  Workplace place;
  for (const std::string& from : all_names("from")) {
    if (!io::has_named_faces(from)) continue;
    write(place, from, mesh);
    ASSERT_EQ(place.run({"convert", from, "s.vtp"}).exit_code, 0) << from;
    const mesh::SurfaceMesh surface = io::read_surface(place.path("s.vtp"));
    EXPECT_EQ(surface.faces.size(), 3u * 6 * 4 * 2 + 6 * 2) << from;
    EXPECT_EQ(surface.patch_names.size(), 3u);
  }
}

struct Wrong {
  std::vector<std::string> arguments;
  std::string advice;
};

TEST(ConvertMeshes, RefusesWhatDoesNotFit) {
  Workplace place;
  const Stored mesh = small_mesh();
  write(place, "a.vtu", mesh);
  write(place, "a.su2", mesh);
  place.write_cube("cube.obj");
  ASSERT_EQ(place.run({"convert", "cube.obj", "cube.vtp"}).exit_code, 0);
  place.write("surface.su2",
              "NDIME= 3\nNELEM= 0\nNPOIN= 3\n0 0 0\n1 0 0\n0 1 0\nNMARK= 1\nMARKER_TAG= w\nMARKER_ELEMS= 1\n5 0 1 2\n");
  const std::vector<Wrong> all = {
      {{"a.vtu", "b.su2", "--weld", "0"}, "--weld makes points of surfaces one"},
      {{"a.vtu", "b.su2", "--ascii"}, "--ascii: is for OpenFOAM's polyMesh"},
      {{"a.vtu", "b.ugrid", "--ascii"}, ".ugrid or .lb8.ugrid"},
      {{"a.su2", "b.cgns", "--boundary", "a-boundary.vtp"}, "a.su2 holds its patches itself"},
      {{"cube.obj", "b.su2"}, "cube.obj: is a surface, and b.su2 would be a mesh; `nearwall run`"},
      {{"cube.vtp", "b.vtu"}, "cube.vtp: is a surface"},
      {{"surface.su2", "b.cgns"}, "expected a mesh of tetrahedra, pyramids, wedges or hexahedra, found none"},
      {{"surface.su2", "b.stl", "--ascii"}, "--ascii"},
      {{"cube.obj", "b.stl", "--boundary", "a-boundary.vtp"}, "--boundary"},
      {{"a.vtu", "b.stl"}, "for b.stl, would be a-boundary.vtp"},
      {{"a.vtu", "b.vtk"}, "a.vtu: holds cells alone, which are written as: vtu vtkhdf cgns"},
      {{"a.vtu", "b.bdf"}, "lb8.ugrid msh msh2, or a folder polyMesh"},
      {{"a.su2", "b.vtu.gz"}, "b.vtu.gz"},
      {{"a.su2", "b.su2.gz"}, "b.su2.gz"},
      {{"a.su2", "b.bdf"}, "b.bdf"},
      {{"none.su2", "b.vtu"}, "none.su2"},
  };
  for (const Wrong& wrong : all) {
    std::vector<std::string> arguments = {"convert"};
    arguments.insert(arguments.end(), wrong.arguments.begin(), wrong.arguments.end());
    const Outcome outcome = place.run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << wrong.arguments[0] << " " << wrong.arguments[1] << "\n" << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(wrong.advice));
    EXPECT_FALSE(place.has(wrong.arguments[1])) << wrong.arguments[1];
  }
}

/// Two tetrahedra on the same side of one triangle, or three on it.
std::string crowd(int n) {
  std::string text = "NDIME= 3\nNELEM= " + std::to_string(n) + "\n";
  for (int i = 0; i < n; ++i) text += "10 0 1 2 " + std::to_string(3 + i) + "\n";
  text += "NPOIN= 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 2\n0 0 3\nNMARK= 0\n";
  return text;
}

TEST(ConvertMeshes, RefusesMeshesWhoseFacesHaveMoreThanTwoCells) {
  Workplace place;
  for (const int n : {2, 3}) {
    place.write("bad.su2", crowd(n));
    for (const char* to : {"b.cgns", "b.msh", "b/polyMesh"}) {
      const Outcome outcome = place.run({"convert", "bad.su2", to});
      EXPECT_EQ(outcome.exit_code, 2) << to;
      EXPECT_THAT(outcome.err, HasSubstr("is also one of " + std::to_string(n - 1) + " other cell(s)"));
      EXPECT_THAT(outcome.err, HasSubstr("the mesh is not conforming; `nearwall certify` names all such faces"));
      EXPECT_FALSE(place.has(to));
    }
    EXPECT_EQ(place.run({"certify", "bad.su2"}).exit_code, 1);
  }
}

TEST(ConvertMeshes, SaysWhatItLeavesOutAndAdds) {
  Workplace place;
  // A tetrahedron with one of its faces twice, one that is none of it, and three without a patch.
  place.write("a.su2",
              "NDIME= 3\nNELEM= 1\n10 0 1 2 3\nNPOIN= 5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\nNMARK= 1\n"
              "MARKER_TAG= w\nMARKER_ELEMS= 3\n5 0 1 2\n5 2 1 0\n5 1 2 4\n");
  const Outcome outcome = place.run({"convert", "a.su2", "b.vtu", "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("left out: 2 faces of patches"));
  EXPECT_THAT(outcome.err, HasSubstr("3 faces of cells were in no patch: they are the patch \"boundary\""));
  EXPECT_EQ(json::parse(outcome.out)["boundary_faces"], 4);
}

// Surfaces of solvers' formats before anything is meshed.

TEST(CheckCommand, TakesTheBoundaryOfAMeshForASurface) {
  const Stored mesh = {volume_meshes_for_tests::block(2, volume_meshes_for_tests::as_wedges()), {}};
  Workplace place;
  for (const std::string& name : all_names("mesh")) {
    if (!io::has_named_faces(name)) continue;
    write(place, name, mesh);
    const Outcome outcome = place.run({"check", name, "--json", "--fluid", "inside"});
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["usable"], true) << name;
    EXPECT_EQ(result["points"], 26) << "not the one within";
    EXPECT_EQ(result["triangles"], 48);
    EXPECT_EQ(result["ridges"]["concave"], 24);
  }
}

}  // namespace
}  // namespace nearwall::program

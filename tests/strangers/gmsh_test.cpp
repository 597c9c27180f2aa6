// Meshes that we write as Gmsh and meshio see them, and those that Gmsh saves as we read them.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "nearwall/io/msh_writer.h"
#include "nearwall/io/volume_reader.h"
#include "tests/io/temporary_folder.h"
#include "tests/peers/child.h"
#include "tests/support/whole_meshes.h"

namespace nearwall::io {
namespace {

using nlohmann::json;
using whole_meshes_for_tests::Stored;

constexpr const char* kPython = "/usr/bin/python3";

/// A mesh without the numbers of its points and the order of its elements: what each is, and where its nodes are.
struct Shape {
  std::vector<std::vector<double>> cells;                         // type, layer, coordinates
  std::map<std::string, std::vector<std::vector<double>>> faces;  // by patch
};

/// \param is_single  coordinates in single precision: Gmsh writes text with one digit fewer than doubles take
Shape shape_of(const mesh::VolumeMesh& mesh, const mesh::Boundary& boundary, bool is_single) {
  Shape shape;
  const auto append = [&](std::vector<double>& to, std::size_t node) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = mesh.points[node][axis];
      to.push_back(is_single ? static_cast<double>(static_cast<float>(x)) : x);
    }
  };
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    std::vector<double>& cell = shape.cells.emplace_back();
    cell = {static_cast<double>(mesh.type[c]), static_cast<double>(mesh.layer[c])};
    for (const std::uint32_t node : mesh.nodes_of(c)) append(cell, node);
  }
  std::ranges::sort(shape.cells);
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    const std::string& name = boundary.patches[boundary.patch[f]].name;
    std::vector<double>& face = shape.faces[name].emplace_back();
    for (std::size_t k = 0; k < static_cast<std::size_t>(mesh::size_of(boundary.faces[f])); ++k) {
      append(face, boundary.faces[f][k]);
    }
  }
  for (auto& [name, faces] : shape.faces) std::ranges::sort(faces);
  return shape;
}

class GmshAndMeshio : public testing::TestWithParam<MshVersion> {
 protected:
  void SetUp() override {
    if (peers::run_program(folder_.path(), {kPython, "-c", "import gmsh, meshio"}).exit_code != 0) {
      GTEST_SKIP() << "gmsh and meshio are not installed for python3; `make test-slow` installs them";
    }
  }

  json figures_of(const Stored& mesh) const {
    write_msh(folder_ / "mesh.msh", mesh.whole(), GetParam());
    const auto run = peers::run_program(
        folder_.path(), {kPython, NEARWALL_STRANGERS_SCRIPTS "/gmsh_figures.py", "mesh.msh", ".", "figures.json"});
    EXPECT_EQ(run.exit_code, 0) << bytes_of(folder_ / "output.txt.err");
    return json::parse(bytes_of(folder_ / "figures.json"));
  }

  const TemporaryFolder folder_;
};

TEST_P(GmshAndMeshio, SeeTheMeshThatWeWrite) {
  const json figures = figures_of(whole_meshes_for_tests::blocks_of_all_types(3));
  for (const char* program : {"gmsh", "meshio"}) {
    SCOPED_TRACE(program);
    const json& seen = figures.at(program);
    // 3 x 4³ points of blocks, 9 of the pyramids; 27 small cubes each; 6 faces of 9 squares, those of the wedges halved
    // at the top and at the bottom, all of the tetrahedra; 6 squares of the pyramids.
    EXPECT_EQ(seen.at("nodes"), 3 * 64 + 9);
    EXPECT_EQ(seen.at("hexahedron"), 27);
    EXPECT_EQ(seen.at("wedge"), 2 * 27);
    EXPECT_EQ(seen.at("tetrahedron"), 6 * 27);
    EXPECT_EQ(seen.at("pyramid"), 6);
    EXPECT_EQ(seen.at("triangle"), 2 * 2 * 9 + 6 * 2 * 9);
    EXPECT_EQ(seen.at("quad"), 6 * 9 + 4 * 9 + 6);
  }
  const json& gmsh = figures.at("gmsh");
  EXPECT_EQ(gmsh.at("complaints"), json::array());
  // Each block is a third by a seventh by an 11e5th; Gmsh's rules have that many digits, but that for pyramids is not
  // one for volumes.
  constexpr double kDigits = 1e-10;
  for (const char* type : {"tetrahedron", "pyramid", "wedge", "hexahedron"}) {
    EXPECT_GT(gmsh.at(fmt::format("{} smallest determinant", type)), 0) << type;
    if (type != std::string_view("pyramid")) {
      EXPECT_NEAR(gmsh.at(fmt::format("{} volume", type)).get<double>() * 3 * 7 * 11e5, 1, kDigits) << type;
    }
  }
  const json& groups = gmsh.at("groups");
  EXPECT_EQ(groups.at("layers").get<int>() + groups.at("rest").get<int>(), 27 + 54 + 162 + 6);
  EXPECT_EQ(groups.at("wall 'one'"), 9 + 18 + 18 + 1);
  EXPECT_EQ(groups.at("top"), 9 + 18 + 18 + 1);
  EXPECT_EQ(groups.at("sides"), 4 * (9 + 9 + 18 + 1));
  EXPECT_THAT(figures.at("meshio").at("groups").get<std::vector<std::string>>(),
              testing::ElementsAre("layers", "no faces", "rest", "sides", "top", "wall 'one'"));
}

TEST_P(GmshAndMeshio, SaveWhatWeReadBack) {
  const Stored mesh = whole_meshes_for_tests::blocks_of_all_types(3);
  figures_of(mesh);
  for (const char* name : {"4.1-1.msh", "4.1-0.msh", "2.2-1.msh", "2.2-0.msh"}) {
    SCOPED_TRACE(name);
    const bool is_text = std::string_view(name).find("-0") != std::string_view::npos;
    const VolumeFile file = read_volume_mesh(folder_ / name);
    EXPECT_EQ(file.mesh.points.size(), mesh.mesh().points.size()) << "no node is lost";
    const Shape found = shape_of(file.mesh, file.boundary, is_text);
    Shape expected = shape_of(mesh.mesh(), mesh.boundary(), is_text);
    expected.faces["wall 'one'"] = expected.faces["wall \"one\""];
    expected.faces.erase("wall \"one\"");
    EXPECT_EQ(found.cells, expected.cells);
    EXPECT_EQ(found.faces, expected.faces);
  }
}

/// Gmsh's Nastran files have no names, and a property for each entity.
TEST_P(GmshAndMeshio, ExportCellsToNastranAsWeReadThem) {
  const Stored mesh = whole_meshes_for_tests::blocks_of_all_types(3);
  figures_of(mesh);
  const VolumeFile file = read_volume_mesh(folder_ / "again.bdf");
  EXPECT_EQ(file.mesh.points.size(), mesh.mesh().points.size());
  EXPECT_EQ(file.boundary.faces.size(), mesh.boundary().faces.size());
  std::map<mesh::CellType, int> n;
  for (std::size_t c = 0; c < file.mesh.n_cells(); ++c) {
    const auto corners = file.mesh.corners_of(c);
    EXPECT_GT(mesh::cell_volume(file.mesh.type[c], corners), 0) << "cell " << c;
    ++n[file.mesh.type[c]];
  }
  using enum mesh::CellType;
  EXPECT_THAT(n, testing::ElementsAre(testing::Pair(Tetrahedron, 162), testing::Pair(Pyramid, 6),
                                      testing::Pair(Wedge, 54), testing::Pair(Hexahedron, 27)));
}

INSTANTIATE_TEST_SUITE_P(Versions, GmshAndMeshio, testing::Values(MshVersion::V41, MshVersion::V22),
                         [](const auto& test) { return test.param == MshVersion::V41 ? "V41" : "V22"; });

}  // namespace
}  // namespace nearwall::io

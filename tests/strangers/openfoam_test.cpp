// Meshes that we write as OpenFOAM's own programs see them, and theirs as we read them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "nearwall/io/openfoam_writer.h"
#include "nearwall/io/volume_reader.h"
#include "tests/io/openfoam_meshes.h"
#include "tests/io/temporary_folder.h"
#include "tests/peers/child.h"

namespace nearwall::io {
namespace {

namespace fs = std::filesystem;
using mesh::BoundaryType;

void write_dictionary(const fs::path& path, std::string_view entries) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << fmt::format("FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n{}\n",
                                     path.filename().string(), entries);
}

/// A case without a solver, as far as programs that look at meshes need it.
void make_case(const fs::path& folder, std::string_view format) {
  write_dictionary(folder / "system" / "controlDict",
                   fmt::format("application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; "
                               "deltaT 1; writeControl timeStep; writeInterval 1; writeFormat {}; writePrecision 17; "
                               "writeCompression off; timeFormat general; timePrecision 6;",
                               format));
  write_dictionary(folder / "system" / "fvSchemes",
                   "ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {} interpolationSchemes {} "
                   "snGradSchemes {}");
  write_dictionary(folder / "system" / "fvSolution", "");
}

class OpenfoamPrograms : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("WM_PROJECT_DIR", "/usr/share/openfoam", 0);
    if (run({"checkMesh", "-help"}).exit_code != 0) {
      GTEST_SKIP() << "OpenFOAM is not installed; `make test-slow` installs it";
    }
  }

  peers::Run run(const std::vector<std::string>& words) const {
    return peers::run_program(folder_.path(), words, words[0] + ".txt");
  }
  std::string text_of(const std::string& program) const { return bytes_of(folder_ / (program + ".txt")); }
  fs::path poly_mesh() const { return folder_ / "constant" / "polyMesh"; }

  const TemporaryFolder folder_;
};

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// The whole number behind a label in checkMesh's text; −1 if there is none.
long number_behind(const std::string& text, const std::string& label) {
  const std::size_t at = text.find(label);
  return at == std::string::npos ? -1 : std::strtol(text.c_str() + at + label.size(), nullptr, 10);
}

TEST_F(OpenfoamPrograms, FindNoFaultInTheTopologyOfOurMeshes) {
  make_case(folder_.path(), "binary");
  for (const auto& [name, make] : openfoam_meshes::kMeshes) {
    for (const FoamForm form : {FoamForm::Binary, FoamForm::Ascii}) {
      const auto mesh = make();
      write_openfoam(poly_mesh(), mesh.whole(), form);
      ASSERT_EQ(run({"checkMesh", "-allGeometry", "-allTopology"}).exit_code, 0);
      const std::string text = text_of("checkMesh");
      SCOPED_TRACE(name + "\n" + text);
      for (const char* check :
           {"Boundary definition OK.", "Cell to face addressing OK.", "Upper triangular ordering OK.",
            "Face vertices OK.", "Topological cell zip-up check OK.", "Face-face connectivity OK.",
            "Number of regions: 1 (OK).", "Face pyramids OK.", "Face tets OK.", "Cell volumes OK."}) {
        EXPECT_EQ(count(text, check), 1U) << check;
      }
      // A cell with one face inside, or two with normals in a plane, counts as under-determined: cells in corners do.
      const std::size_t small_determinant = count(text, "***Cells with small determinant");
      // Corners of the block of one tetrahedron are points that no cell uses, one at least of each side's.
      const std::size_t unused_points = count(text, "***Unused points found");
      EXPECT_EQ(unused_points, name == "OneCell" ? 1U : 0U);
      EXPECT_EQ(count(text, "***"), small_determinant + unused_points);
      const auto n_by_type = mesh.source->n_cells_by_type();
      const std::vector<std::string> labels = {
          "\n    tetrahedra:", "\n    pyramids:", "\n    prisms:", "\n    hexahedra:"};
      for (std::size_t type = 0; type < labels.size(); ++type) {
        EXPECT_EQ(number_behind(text, labels[type]), static_cast<long>(n_by_type[type])) << labels[type];
      }
      EXPECT_EQ(number_behind(text, "\n    layers "), static_cast<long>((mesh.volume.n_cells() + 1) / 2));
    }
  }
}

TEST_F(OpenfoamPrograms, RewriteOurMeshesInTheOtherFormWithoutAChange) {
  const auto mesh = openfoam_meshes::mixed();
  for (const auto& [ours, theirs] : {std::pair(FoamForm::Binary, "ascii"), std::pair(FoamForm::Ascii, "binary"),
                                     std::pair(FoamForm::Binary, "binary")}) {
    make_case(folder_.path(), theirs);
    write_openfoam(poly_mesh(), mesh.whole(), ours);
    const VolumeFile before = read_volume_mesh(folder_.path());
    ASSERT_EQ(run({"foamFormatConvert", "-constant"}).exit_code, 0) << text_of("foamFormatConvert");
    ASSERT_NE(bytes_of(poly_mesh() / "faces").find(fmt::format("format      {}", theirs)), std::string::npos);
    const VolumeFile after = read_volume_mesh(folder_.path());
    EXPECT_EQ(after.mesh.points, before.mesh.points);
    EXPECT_EQ(after.mesh.nodes, before.mesh.nodes);
    EXPECT_EQ(after.mesh.layer, before.mesh.layer);
    EXPECT_EQ(after.boundary.faces, before.boundary.faces);
    EXPECT_EQ(after.boundary.patch, before.boundary.patch);
    EXPECT_TRUE(std::equal(after.boundary.patches.begin(), after.boundary.patches.end(),
                           before.boundary.patches.begin(), before.boundary.patches.end()));
  }
}

TEST_F(OpenfoamPrograms, MakeABlockThatWeRead) {
  for (const char* format : {"ascii", "binary"}) {
    make_case(folder_.path(), format);
    write_dictionary(
        folder_ / "system" / "blockMeshDict",
        "vertices ((0 0 0)(1 0 0)(1 1 0)(0 1 0)(0 0 1)(1 0 1)(1 1 1)(0 1 1));\n"
        "blocks (hex (0 1 2 3 4 5 6 7) layers (2 3 4) simpleGrading (1 1 1)); edges ();\n"
        "boundary (floor { type wall; faces ((0 3 2 1)); } mid { type symmetryPlane; faces ((0 1 5 4)); }\n"
        "rest { type patch; faces ((0 4 7 3)(1 2 6 5)(3 7 6 2)(4 5 6 7)); });");
    ASSERT_EQ(run({"blockMesh"}).exit_code, 0) << text_of("blockMesh");
    const VolumeFile file = read_volume_mesh(folder_.path());
    EXPECT_EQ(file.mesh.points.size(), 3U * 4U * 5U);
    EXPECT_EQ(file.mesh.layer, std::vector<std::int32_t>(24, 1));
    for (std::size_t c = 0; c < file.mesh.n_cells(); ++c) {
      EXPECT_NEAR(mesh::cell_volume(file.mesh.type[c], file.mesh.corners_of(c)), 1.0 / 24, 1e-15);
    }
    ASSERT_EQ(file.patch_names, (std::vector<std::string>{"floor", "mid", "rest"}));
    EXPECT_EQ(file.boundary.patches[PatchId(1)].type, BoundaryType::Symmetry);
    EXPECT_EQ(file.boundary.faces.size(), 2U * (6 + 8 + 12));
  }
}

}  // namespace
}  // namespace nearwall::io

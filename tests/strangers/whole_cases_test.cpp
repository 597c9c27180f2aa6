// Cases of /cases in all formats, as other programs see them: real meshes with thin layers, corners and sides.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "tests/io/temporary_folder.h"
#include "tests/peers/child.h"

namespace nearwall::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kPython = "/usr/bin/python3";

struct WholeCase {
  std::string name;
  /// What checkMesh may find fault with; what each says of layers: docs/solver.md.
  std::set<std::string> faults;
};

/// Thin layers of high aspect ratio have a small determinant, as have cells in corners with few faces inside.
const std::string kDeterminant = "Cells with small determinant (< 0.001) found";
const std::string kAspect = "High aspect ratio cells found";
/// Cells over virtual faces of ridges: they have no width at the wall, and stand beside columns on whole triangles.
const std::string kWeight = "Faces with small interpolation weight (< 0.05) found";
const std::string kRatio = "Faces with small volume ratio (< 0.01) found";

class WholeCases : public testing::TestWithParam<WholeCase> {
 protected:
  const std::string& name() const { return GetParam().name; }

  /// \returns  the exit code; what is said goes to log()
  int run(std::vector<std::string> words) const {
    return peers::run_program(folder_.path(), std::move(words), "log.txt").exit_code;
  }
  bool has_program(const std::string& program) const { return run({"sh", "-c", "command -v " + program}) == 0; }
  bool has_module(const std::string& modules) const { return run({kPython, "-c", "import " + modules}) == 0; }
  std::string log() const { return bytes_of(folder_ / "log.txt"); }
  std::string log_of_errors() const { return bytes_of(folder_ / "log.txt.err"); }
  static std::string script(const char* file) { return fmt::format("{}/{}", NEARWALL_STRANGERS_SCRIPTS, file); }
  fs::path out(const std::string& ending) const { return folder_ / "out" / (name() + ending); }

  void make_meshes() {
    const fs::path source = fs::path(NEARWALL_CASES) / name();
    fs::copy(source / "case.toml", folder_.path());
    fs::copy(source / "geometry.sh", folder_.path());
    const std::string path = fmt::format("PATH='{}':$PATH; ", NEARWALL_PROGRAM_FOLDER);
    ASSERT_EQ(run({"sh", "-c", path + "sh geometry.sh"}), 0) << log_of_errors();
    ASSERT_EQ(run({"sh", "-c", path + R"(nearwall run case.toml --quiet --set output.pictures=false \
                  --set 'output.formats=["vtu","vtkhdf","cgns","su2","lb8.ugrid","msh","openfoam"]')"}),
              0)
        << log_of_errors();
    report_ = json::parse(std::ifstream(folder_ / "out/report.json"));
  }

  void expect_counted_alike() const;
  void expect_sound_to_checkmesh() const;

  const TemporaryFolder folder_;
  json report_;
};

/// The ends of lines that begin with checkMesh's three stars: checks that failed, without their figures.
std::set<std::string> failed_checks(const std::string& text) {
  std::set<std::string> failed;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("***");
    if (at != std::string::npos) failed.insert(line.substr(at + 3, line.find(',') - at - 3));
  }
  return failed;
}

/// Its figures, for the log of the test.
void print_figures(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    for (const char* word : {"Max", "Min", "minimum", "***"}) {
      if (line.find(word) == std::string::npos) continue;
      std::cout << line << '\n';
      break;
    }
  }
}

void WholeCases::expect_sound_to_checkmesh() const {
  const fs::path solver = out("-openfoam");
  fs::create_directories(solver / "system");
  const auto write = [&](const char* file, const char* entries) {
    std::ofstream(solver / "system" / file)
        << fmt::format("FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n{}\n", file, entries);
  };
  write("controlDict",
        "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; "
        "writeControl timeStep; writeInterval 1;");
  write("fvSchemes",
        "ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {} interpolationSchemes {} snGradSchemes {}");
  write("fvSolution", "");
  ASSERT_EQ(run({"checkMesh", "-case", solver.string(), "-allGeometry", "-allTopology"}), 0) << log_of_errors();
  const std::string text = log();
  SCOPED_TRACE(text);
  for (const char* check :
       {"Boundary definition OK.", "Cell to face addressing OK.", "Point usage OK.", "Upper triangular ordering OK.",
        "Face vertices OK.", "Topological cell zip-up check OK.", "Face-face connectivity OK.",
        "Number of regions: 1 (OK).", "Cell volumes OK.", "Non-orthogonality check OK.", "Face pyramids OK.",
        "Face tets OK.", "All angles in faces OK.", "All face flatness OK.", "Concave cell check OK."}) {
    EXPECT_THAT(text, HasSubstr(check));
  }
  EXPECT_THAT(text, Not(HasSubstr("multiply connected (shared")));
  EXPECT_EQ(failed_checks(text), GetParam().faults);
  std::uint64_t n_cells = 0;
  for (const json& of_type : report_.at("cells")) n_cells += of_type.get<std::uint64_t>();
  EXPECT_THAT(text, HasSubstr(fmt::format("    cells:            {}\n", n_cells)));
  std::cout << name() << ", checkMesh:\n";
  print_figures(text);
}

/// Gmsh and meshio count what the report tells.
void WholeCases::expect_counted_alike() const {
  ASSERT_EQ(run({kPython, script("whole_mesh_figures.py"), out("").string(), "figures.json"}), 0) << log_of_errors();
  const json found = json::parse(std::ifstream(folder_ / "figures.json"));
  EXPECT_EQ(found.size(), 4u);
  for (const auto& [program, figures] : found.items()) {
    SCOPED_TRACE(program);
    for (const auto& [type, n] : report_.at("cells").items()) EXPECT_EQ(figures.at(type), n) << type;
    EXPECT_EQ(figures.at("points"), found.at("gmsh").at("points"));
    EXPECT_GT(figures.at("triangle"), 0);
    EXPECT_EQ(figures.at("triangle"), found.at("gmsh").at("triangle"));
    EXPECT_EQ(figures.at("quad"), found.at("gmsh").at("quad"));
  }
  EXPECT_EQ(found.at("gmsh").at("complaints"), json::array());
  const auto groups = found.at("gmsh").at("groups").get<std::vector<std::string>>();
  EXPECT_THAT(groups, testing::Contains("layers"));
}

TEST_P(WholeCases, AreSoundMeshesToOtherPrograms) {
  ASSERT_NO_FATAL_FAILURE(make_meshes());
  int n_programs = 0;
  // checkMesh of Debian's package looks for its settings here.
  ::setenv("WM_PROJECT_DIR", "/usr/share/openfoam", 0);
  if (has_program("checkMesh")) {
    ++n_programs;
    expect_sound_to_checkmesh();
  }
  if (has_program("cgnscheck")) {
    ++n_programs;
    // It ends with 0 whatever it finds.
    EXPECT_EQ(run({"cgnscheck", out(".cgns").string()}), 0);
    EXPECT_THAT(log(), HasSubstr("checking complete"));
    EXPECT_THAT(log(), Not(HasSubstr("WARNING")));
    EXPECT_THAT(log(), Not(HasSubstr("ERROR")));
  }
  if (has_module("gmsh, meshio")) {
    ++n_programs;
    expect_counted_alike();
  }
  if (has_module("vtkmodules")) {
    ++n_programs;
    EXPECT_EQ(run({kPython, script("vtk_figures.py"), out(".vtkhdf").string(), out(".vtu").string()}), 0)
        << log_of_errors();
    EXPECT_EQ(log(), "same\n");
  }
  // Ours is no stranger, but reads what it wrote in each format as anybody else's.
  const fs::path program = fs::path(NEARWALL_PROGRAM_FOLDER) / "nearwall";
  for (const char* ending : {".vtu", ".vtkhdf", ".cgns", ".su2", ".lb8.ugrid", ".msh", "-openfoam"}) {
    EXPECT_EQ(run({program.string(), "certify", out(ending).string()}), 0) << ending << log();
  }
  if (n_programs == 0) GTEST_SKIP() << "no other program is installed; `make test-slow` installs them";
}

INSTANTIATE_TEST_SUITE_P(Cases, WholeCases,
                         testing::Values(WholeCase{"half-onera-m6", {kDeterminant, kAspect, kWeight, kRatio}},
                                         WholeCase{"sphere-in-box", {kDeterminant}},
                                         WholeCase{"pipe-bend", {kDeterminant}},
                                         WholeCase{"onera-m6", {kDeterminant, kAspect, kWeight, kRatio}}),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace nearwall::io

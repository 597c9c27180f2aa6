// SU2 and UGRID files that we write as meshio and CGNS's converters understand them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "nearwall/io/su2_writer.h"
#include "nearwall/io/ugrid_writer.h"
#include "tests/io/solver_files.h"
#include "tests/io/temporary_folder.h"
#include "tests/peers/child.h"

namespace nearwall::io {
namespace {

using whole_meshes_for_tests::blocks_of_all_types;
using whole_meshes_for_tests::Stored;

class MeshPrograms : public testing::Test {
 protected:
  bool runs(const std::vector<std::string>& words) const {
    return peers::run_program(folder_.path(), words, "log.txt").exit_code == 0;
  }
  std::string log() const { return bytes_of(folder_ / "log.txt"); }

  /// Each block is a cube of side 1 squeezed to 1/3 × 1/7 × 1e-5/11: what the cells of each type fill.
  /// \param wedges  1, or −1 where the format has them as VTK does
  void expect_volumes(const char* file, double wedges) const {
    constexpr double kVolume = 1e-5 / 231, kRounding = 1e-12 * kVolume;
    ASSERT_TRUE(runs({"/usr/bin/python3", fmt::format("{}/signed_volumes.py", NEARWALL_STRANGERS_SCRIPTS),
                      (folder_ / file).string()}))
        << log();
    const std::map<std::string, std::pair<int, double>> expected = {
        {"hexahedron", {27, 1}}, {"wedge", {54, wedges}}, {"tetra", {162, 1}}, {"pyramid", {6, 1}}};
    std::istringstream lines(log());
    std::size_t n_types = 0;
    double enclosed = 0;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string type;
      words >> type;
      if (type == "faces") words >> enclosed;
      const auto found = expected.find(type);
      if (found == expected.end()) continue;
      const auto& [n, sign] = found->second;
      int count = 0;
      double least = 0, most = 0, sum = 0;
      words >> count >> least >> most >> sum;
      EXPECT_EQ(count, n) << line;
      EXPECT_NEAR(least, sign * kVolume / n, kRounding) << line;
      EXPECT_NEAR(most, sign * kVolume / n, kRounding) << line;
      EXPECT_NEAR(sum, sign * kVolume, kRounding) << line;
      ++n_types;
    }
    EXPECT_EQ(n_types, expected.size()) << log();
    EXPECT_NEAR(enclosed, -4 * kVolume, kRounding) << "faces look into the mesh";
  }

  const TemporaryFolder folder_;
};

TEST_F(MeshPrograms, OfMeshioSeeOurCellsTheRightWayRound) {
  if (!runs({"/usr/bin/python3", "-c", "import meshio"})) GTEST_SKIP() << "meshio is not installed";
  const Stored mesh = blocks_of_all_types(3);
  write_su2(folder_ / "mesh.su2", mesh.whole());
  expect_volumes("mesh.su2", -1);
  write_ugrid(folder_ / "mesh.b8.ugrid", mesh.whole(), UgridForm::BigEndian);
  expect_volumes("mesh.b8.ugrid", 1);
  write_ugrid(folder_ / "mesh.lb8.ugrid", mesh.whole(), UgridForm::LittleEndian);
  expect_volumes("mesh.lb8.ugrid", 1);
}

// Into CGNS, whose order of pyramids is another, and back: the same points and cells.
TEST_F(MeshPrograms, OfCgnsConvertOurUgridThereAndBack) {
  if (!runs({"sh", "-c", "command -v aflr3_to_cgns"})) GTEST_SKIP() << "cgns-convert is not installed";
  const Stored mesh = blocks_of_all_types(3);
  write_ugrid(folder_ / "mesh.lb8.ugrid", mesh.whole(), UgridForm::LittleEndian);
  ASSERT_TRUE(runs({"aflr3_to_cgns", "-l", "mesh.lb8.ugrid", "mesh.cgns"})) << log();
  ASSERT_TRUE(runs({"cgnscheck", "mesh.cgns"}));
  EXPECT_EQ(log().find("ERROR"), std::string::npos) << log();
  ASSERT_TRUE(runs({"cgns_to_aflr3", "-l", "mesh.cgns", "back.lb8.ugrid"})) << log();
  expect_same_cells(read_volume_mesh(folder_ / "back.lb8.ugrid").mesh, mesh.mesh(), cells_by_type(mesh.mesh()));
}

}  // namespace
}  // namespace nearwall::io

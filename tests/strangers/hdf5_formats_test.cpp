// CGNS and VTKHDF files that we write as the tools of CGNS and VTK's own readers understand them.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/io/cgns_writer.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/io/vtkhdf_writer.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/round_trips.h"
#include "tests/io/temporary_folder.h"
#include "tests/peers/child.h"
#include "tests/support/whole_meshes.h"

namespace nearwall::io {
namespace {

using testing::HasSubstr;
using testing::Not;
using whole_meshes_for_tests::blocks_of_all_types;
using whole_meshes_for_tests::Stored;

class Hdf5Programs : public testing::Test {
 protected:
  bool runs(const std::vector<std::string>& words) const {
    return peers::run_program(folder_.path(), words, "log.txt").exit_code == 0;
  }
  std::string log() const { return bytes_of(folder_ / "log.txt"); }

  const TemporaryFolder folder_;
};

TEST_F(Hdf5Programs, CgnscheckHasNothingToSay) {
  if (!runs({"sh", "-c", "command -v cgnscheck"})) GTEST_SKIP() << "cgns-convert is not installed";
  const Stored mesh = blocks_of_all_types(3);
  write_cgns(folder_ / "mesh.cgns", mesh.whole());
  ASSERT_TRUE(runs({"cgnscheck", "mesh.cgns"})) << log();
  // It ends with 0 whatever it finds.
  EXPECT_THAT(log(), HasSubstr("checking complete"));
  EXPECT_THAT(log(), Not(HasSubstr("WARNING")));
  EXPECT_THAT(log(), Not(HasSubstr("ERROR")));
}

TEST_F(Hdf5Programs, OfCgnsConvertToUgridTheSameCells) {
  if (!runs({"sh", "-c", "command -v cgns_to_aflr3"})) GTEST_SKIP() << "cgns-convert is not installed";
  const Stored mesh = blocks_of_all_types(3);
  write_cgns(folder_ / "mesh.cgns", mesh.whole());
  ASSERT_TRUE(runs({"cgns_to_aflr3", "-l", "mesh.cgns", "mesh.lb8.ugrid", "mesh.mapbc"})) << log();
  VolumeFile file = read_volume_mesh(folder_ / "mesh.lb8.ugrid");
  EXPECT_EQ(file.mesh.points, mesh.mesh().points);
  file.mesh.layer = {};
  mesh::VolumeMesh ours = mesh.mesh();
  ours.layer = {};
  EXPECT_EQ(cells_with_layers(file.mesh), cells_with_layers(ours));
  EXPECT_EQ(file.boundary.faces.size(), mesh.boundary().faces.size());
}

TEST_F(Hdf5Programs, VtkReadsTheSameOfVtkHdfAsOfVtu) {
  if (!runs({"/usr/bin/python3", "-c", "import vtkmodules"})) GTEST_SKIP() << "python3-vtk9 is not installed";
  const VtuMetadata metadata = {{"hull", "fin & rudder"}};
  for (const MeshForTests& mesh : {one_of_each(), wedge_block(60, 30)}) {
    write_vtkhdf(folder_ / "mesh.vtkhdf", mesh, {}, metadata);
    write_vtu(folder_ / "mesh.vtu", mesh, {}, metadata);
    ASSERT_TRUE(runs({"/usr/bin/python3", fmt::format("{}/vtk_figures.py", NEARWALL_STRANGERS_SCRIPTS),
                      (folder_ / "mesh.vtkhdf").string(), (folder_ / "mesh.vtu").string()}))
        << log();
    EXPECT_EQ(log(), "same\n");
  }
}

}  // namespace
}  // namespace nearwall::io

#include "nearwall/io/vtkhdf_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "io/volume_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/volume_reader.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/round_trips.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using testing::ElementsAre;

const CellArray kNumber = {"Number", [](const mesh::CellBatch& cells, std::span<double> out) {
                             for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<double>(cells.first + i);
                           }};

std::string written(const mesh::MeshSource& mesh, const VtuMetadata& metadata = {}) {
  const TemporaryFolder folder;
  write_vtkhdf(folder / "mesh.vtkhdf", mesh, std::span(&kNumber, 1), metadata);
  EXPECT_EQ(folder.n_files(), 1u);
  return bytes_of(folder / "mesh.vtkhdf");
}

/// The same mesh by way of the XML form, whose reader VTK's own writers have checked.
VolumeFile by_vtu(const mesh::MeshSource& mesh, const VtuMetadata& metadata) {
  const TemporaryFolder folder;
  write_vtu(folder / "mesh.vtu", mesh, {}, metadata);
  return read_volume_mesh(folder / "mesh.vtu");
}

VolumeFile read_back(std::string_view bytes) {
  const TemporaryFolder folder;
  return read_volume_mesh(folder.file("mesh.vtkhdf", bytes));
}

TEST(VtkHdf, GivesTheMeshBackBitForBitAsVtuDoes) {
  const VtuMetadata metadata = {{"hull", "fin & rudder"}};
  for (const MeshForTests& mesh : {one_of_each(), wedge_block(60, 30)}) {
    const VolumeFile file = read_back(written(mesh, metadata)), other = by_vtu(mesh, metadata);
    EXPECT_EQ(file.mesh.points, mesh.points);
    EXPECT_EQ(file.mesh.points, other.mesh.points);
    EXPECT_EQ(file.mesh.type, other.mesh.type);
    EXPECT_EQ(file.mesh.first_node, other.mesh.first_node);
    EXPECT_EQ(file.mesh.nodes, other.mesh.nodes);
    ASSERT_EQ(file.mesh.layer.size(), mesh.cells.size());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) ASSERT_EQ(file.mesh.layer[c], mesh.cells[c].layer);
    EXPECT_THAT(file.patch_names, ElementsAre("hull", "fin & rudder"));
  }
}

TEST(VtkHdf, WritesTheSameBytesAtAnyTimeAndWithAnyThreads) {
  const auto mesh = wedge_block(60, 30);
  std::string one;
  {
    const ThreadLimit limit(1);
    one = written(mesh, {{"hull"}});
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 keeps times in seconds
  EXPECT_TRUE(one == written(mesh, {{"hull"}}));
}

TEST(VtkHdf, WritesAMeshWithoutCells) {
  const VolumeFile file = read_back(written(MeshForTests()));
  EXPECT_EQ(file.mesh.n_cells(), 0u);
}

TEST(VtkHdf, LeavesNothingBehindWhenTheSourceFails) {
  const TemporaryFolder folder;
  const CellArray failing = {"Fails", [](const mesh::CellBatch&, std::span<double>) { throw Interrupted(); }};
  EXPECT_THROW(write_vtkhdf(folder / "mesh.vtkhdf", one_of_each(), std::span(&failing, 1), {}), Interrupted);
  EXPECT_EQ(folder.n_files(), 0u);
}

TEST(VtkHdf, RefusesOtherFilesOfHdf5) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_volume_mesh(folder.file("mesh.vtkhdf", "text")), GeometryError);
}

TEST(MalformedVtkHdf, IsReadOrRefusedWhereverItIsDamaged) {
  const int n_refused = damage(written(one_of_each(), {{"hull"}}), "mesh.vtkhdf", read_vtkhdf);
  EXPECT_GT(n_refused, 100) << "the changes do reach the reader";
}

}  // namespace
}  // namespace nearwall::io

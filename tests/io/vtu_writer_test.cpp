#include "nearwall/io/vtu_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/vtk_xml_input.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using testing::ElementsAre;

/// Its number among all cells: what a batch must know for itself.
const CellArray kNumber = {"Number", [](const mesh::CellBatch& cells, std::span<double> out) {
                             for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<double>(cells.first + i);
                           }};

std::string written(const mesh::MeshSource& mesh, const VtuMetadata& metadata = {}) {
  const TemporaryFolder folder;
  write_vtu(folder / "mesh.vtu", mesh, std::span(&kNumber, 1), metadata);
  EXPECT_EQ(folder.n_files(), 1u);
  return bytes_of(folder / "mesh.vtu");
}

const XmlArray& array(const VtkXmlInput& file, std::string_view name) {
  for (const XmlArray& a : file.arrays()) {
    if (a.name() == name) return a;
  }
  throw std::out_of_range(std::string(name));
}

TEST(WriteVtu, WritesAllArraysOfAllCellTypes) {
  const std::string bytes = written(one_of_each(), {{"hull", "fin & rudder"}});
  const VtkXmlInput file(bytes, "mesh.vtu");
  EXPECT_EQ(file.type(), "UnstructuredGrid");
  EXPECT_EQ(file.count_of(0, "NumberOfPoints"), 16);
  EXPECT_EQ(file.count_of(0, "NumberOfCells"), 4);
  EXPECT_THAT(file.integers(array(file, "types")), ElementsAre(12, 14, 13, 10));
  EXPECT_THAT(file.integers(array(file, "offsets")), ElementsAre(8, 13, 19, 23));
  EXPECT_THAT(file.integers(array(file, "Layer")), ElementsAre(1, 0, 1, 2));
  EXPECT_THAT(file.integers(array(file, "Column")), ElementsAre(0, -1, 3000000000, 7));
  EXPECT_THAT(file.integers(array(file, "Patch")), ElementsAre(0, -1, 1, 1));
  EXPECT_THAT(file.reals(array(file, "Number")), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(file.integers(array(file, "Line"))[0], -1);
  EXPECT_EQ(file.integers(array(file, "Level"))[9], 4);
  EXPECT_THAT(file.strings(array(file, "PatchNames")), ElementsAre("hull", "fin & rudder"));
  const auto mesh = one_of_each();
  const auto points = file.reals(array(file, "Points"));
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    EXPECT_EQ(Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]), mesh.points[i]);
  }
}

TEST(WriteVtu, NumbersTheWedgeAsVtkDoesAndOtherCellsAlike) {
  const std::string bytes = written(one_of_each());
  const VtkXmlInput file(bytes, "mesh.vtu");
  EXPECT_THAT(file.integers(array(file, "connectivity")),
              ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 11, 10, 12, 14, 13, 12, 13, 14, 15));
}

TEST(WriteVtu, WritesTheSameBytesWhateverThreadsAndBatches) {
  auto mesh = wedge_block(60, 30);
  std::string one;
  {
    const ThreadLimit limit(1);
    one = written(mesh);
  }
  EXPECT_EQ(one, written(mesh));
  mesh.batch_size = 1000;
  const std::string other = written(mesh);
  EXPECT_EQ(one, other);
}

TEST(WriteVtu, WritesManyBlocksInOrder) {
  const auto mesh = wedge_block(60, 30);
  const std::string bytes = written(mesh);
  const VtkXmlInput file(bytes, "mesh.vtu");
  const auto offsets = file.integers(array(file, "offsets"));
  const auto columns = file.integers(array(file, "Column"));
  const auto numbers = file.reals(array(file, "Number"));
  ASSERT_EQ(offsets.size(), mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    ASSERT_EQ(offsets[c], static_cast<std::int64_t>(6 * (c + 1)));
    ASSERT_EQ(columns[c], mesh.cells[c].column);
    ASSERT_EQ(numbers[c], static_cast<double>(c));
  }
}

TEST(WriteVtu, WritesAMeshWithoutCells) {
  const std::string bytes = written(MeshForTests());
  const VtkXmlInput file(bytes, "mesh.vtu");
  EXPECT_TRUE(file.integers(array(file, "types")).empty());
}

TEST(WriteVtu, LeavesNothingBehindWhenTheSourceFails) {
  const TemporaryFolder folder;
  const CellArray failing = {"Fails", [](const mesh::CellBatch&, std::span<double>) { throw Interrupted(); }};
  EXPECT_THROW(write_vtu(folder / "mesh.vtu", one_of_each(), std::span(&failing, 1), {}), Interrupted);
  EXPECT_EQ(folder.n_files(), 0u);
}

}  // namespace
}  // namespace nearwall::io

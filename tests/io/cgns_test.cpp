#include "nearwall/io/cgns_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "io/volume_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/volume_reader.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/mutator.h"
#include "tests/io/round_trips.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/whole_meshes.h"

namespace nearwall::io {
namespace {

using testing::HasSubstr;
using whole_meshes_for_tests::blocks_of_all_types;
using whole_meshes_for_tests::Stored;

std::string written(const WholeMesh& mesh) {
  const TemporaryFolder folder;
  write_cgns(folder / "mesh.cgns", mesh);
  EXPECT_EQ(folder.n_files(), 1u);
  return bytes_of(folder / "mesh.cgns");
}

VolumeFile read_back(std::string_view bytes) {
  const TemporaryFolder folder;
  return read_volume_mesh(folder.file("mesh.cgns", bytes));
}

/// A block whose patches have these names.
Stored named_block(const std::vector<std::string>& names) {
  auto mesh = volume_meshes_for_tests::block(1, volume_meshes_for_tests::as_wedges());
  mesh::Boundary boundary;
  mesh::fit_boundary(mesh, boundary);
  boundary.patches = {};
  for (const std::string& name : names) boundary.patches.push_back({name, mesh::BoundaryType::Wall});
  for (std::size_t f = 0; f < boundary.patch.size(); ++f) boundary.patch[f] = PatchId(f % names.size());
  return {std::move(mesh), std::move(boundary)};
}

TEST(Cgns, GivesTheMeshBackBitForBit) {
  const Stored stored = blocks_of_all_types(3);
  const VolumeFile file = read_back(written(stored.whole()));
  EXPECT_EQ(file.mesh.points, stored.mesh().points);
  EXPECT_EQ(cells_with_layers(file.mesh), cells_with_layers(stored.mesh()));
  EXPECT_EQ(faces_by_name(file.boundary), faces_by_name(stored.boundary()));
  EXPECT_EQ(file.boundary.patches, stored.boundary().patches);
  EXPECT_EQ(file.skipped.all(), 0u);
}

TEST(Cgns, KeepsNamesThatAreTooLongOrAlikeOrTaken) {
  const std::string stem(40, 'x');
  const std::vector<std::string> names = {stem + "1", stem + "2",        "a/b",
                                          "Zone",     "GridCoordinates", "layers",
                                          "ZoneBC",   "LayerWedges",     "Größe größer als zweiunddreißig"};
  const Stored stored = named_block(names);
  const VolumeFile file = read_back(written(stored.whole()));
  EXPECT_EQ(file.patch_names, names);
  EXPECT_EQ(faces_by_name(file.boundary), faces_by_name(stored.boundary()));
}

TEST(Cgns, KeepsNamesWithBlanksAtTheirEnds) {
  const std::vector<std::string> names = {"wall", " wall", std::string(31, 'x') + " y"};
  const Stored stored = named_block(names);
  const VolumeFile file = read_back(written(stored.whole()));
  EXPECT_EQ(file.patch_names, names);
  EXPECT_EQ(faces_by_name(file.boundary), faces_by_name(stored.boundary()));
  EXPECT_NO_THROW(written(named_block({"wall", "wall "}).whole())) << "one name to the library";
}

TEST(Cgns, WritesPatchesWithoutName) {
  EXPECT_EQ(read_back(written(named_block({"", "wall"}).whole())).patch_names,
            (std::vector<std::string>{"patch", "wall"}));
}

TEST(Cgns, WritesTheSameBytesAtAnyTimeAndWithAnyThreads) {
  const Stored stored = blocks_of_all_types(4);
  std::string one;
  {
    const ThreadLimit limit(1);
    one = written(stored.whole());
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 keeps times in seconds
  EXPECT_TRUE(one == written(stored.whole()));
}

/// Claims more cells than there can be in memory; nobody asks for them.
class Claimed final : public mesh::MeshSource {
 public:
  Claimed(NodeIndex n_points, CellIndex n_cells) : n_points_(n_points), n_cells_(n_cells) {}
  NodeIndex n_points() const override { return n_points_; }
  CellIndex n_cells() const override { return n_cells_; }
  std::array<CellIndex, mesh::kNCellTypes> n_cells_by_type() const override { return {n_cells_, 0, 0, 0}; }
  std::size_t n_point_batches() const override { return fail(); }
  void read_points(std::size_t, mesh::PointBatch&) const override { fail(); }
  std::size_t n_cell_batches() const override { return fail(); }
  void read_cells(std::size_t, mesh::CellBatch&) const override { fail(); }

 private:
  static std::size_t fail() { throw InternalError("read"); }
  NodeIndex n_points_;
  CellIndex n_cells_;
};

TEST(Cgns, RefusesWhatItsNumbersDoNotHoldBeforeItWrites) {
  const Stored stored = named_block({"wall"});
  const auto refused = [&](NodeIndex n_points, CellIndex n_cells, const char* what) {
    const TemporaryFolder folder;
    const Claimed source(n_points, n_cells);
    try {
      write_cgns(folder / "mesh.cgns", {source, stored.boundary(), stored.whole().neighbours, "big"});
      ADD_FAILURE() << what;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(what));
    }
    EXPECT_EQ(folder.n_files(), 0u);
  };
  refused(2147483648, 100, "2147483648 points");
  refused(100, 2147483648, "cells and boundary faces");
  refused(100, 536870912, "2147483648 nodes of cells of the type tetrahedron");
  refused(0, 0, "no cells");
}

TEST(Cgns, LeavesNothingBehindWhenTheFolderIsNotThere) {
  const Stored stored = named_block({"wall"});
  EXPECT_THROW(write_cgns("/no/such/folder/mesh.cgns", stored.whole()), IoError);
}

TEST(Cgns, RefusesFilesThatAreNone) {
  const auto refuse = [](std::string_view bytes) { EXPECT_THROW(read_back(bytes), GeometryError); };
  refuse("");
  refuse("solid x");
  refuse("\x89HDF\r\n\x1a\n");
  EXPECT_THROW(read_back("@(#)ADF Database Version A02011>"), InputError);
}

TEST(MalformedCgns, IsReadOrRefusedWhereverItIsDamaged) {
  // HDF5 stores more than eight members of a group in another way.
  const std::vector<std::string> few = {"wall", "top"}, many = {"a", "b", "c", "d", "e", "f", "g", "h", "i"};
  for (const auto& names : {few, many}) {
    const auto n_refused = damage(written(named_block(names).whole()), "mesh.cgns", read_cgns);
    EXPECT_GT(n_refused, 100) << "the changes do reach the reader";
  }
}

}  // namespace
}  // namespace nearwall::io

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/volume_formats.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/msh_writer.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/solver_files.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using namespace whole_meshes_for_tests;
using namespace volume_meshes_for_tests;
using testing::ElementsAre;
using testing::HasSubstr;

std::string written(const Stored& mesh, MshVersion version) {
  const TemporaryFolder folder;
  write_msh(folder / "mesh.msh", mesh.whole(), version);
  EXPECT_EQ(folder.n_files(), 1u);
  return bytes_of(folder / "mesh.msh");
}

/// Cells as the writers list them: those of the layers by type, then the others by type.
std::vector<std::size_t> cells_by_group(const VolumeMesh& mesh) {
  std::vector<std::size_t> order = cells_by_type(mesh);
  std::stable_partition(order.begin(), order.end(), [&](std::size_t c) { return mesh.layer[c] > 0; });
  return order;
}

/// A wedge with layers below a tetrahedron.
Stored two_cells() {
  VolumeMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 1e-7}, {0.25, 0.25, 2}};
  add_cell(mesh, CellType::Wedge, {0, 1, 2, 3, 4, 5});
  add_cell(mesh, CellType::Tetrahedron, {3, 4, 5, 6});
  mesh.layer = {1, 0};
  Boundary boundary;
  boundary.patches.push_back({"wall", BoundaryType::Wall});
  boundary.faces.push_back({0, 2, 1, mesh::kNoFourthNode});
  boundary.patch.push_back(PatchId(0));
  return {std::move(mesh), std::move(boundary)};
}

constexpr const char* kTwoCells22 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n2 1 \"wall\"\n2 2 \"boundary\"\n3 3 \"layers\"\n"
    "3 4 \"rest\"\n$EndPhysicalNames\n$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 0.1\n5 1 0 0.1\n6 0 1 1e-07\n"
    "7 0.25 0.25 2\n$EndNodes\n$Elements\n9\n1 2 2 1 1 1 3 2\n2 2 2 2 2 4 5 7\n3 2 2 2 2 5 6 7\n4 2 2 2 2 6 4 7\n"
    "5 3 2 2 2 1 2 5 4\n6 3 2 2 2 2 3 6 5\n7 3 2 2 2 3 1 4 6\n8 6 2 3 1 1 2 3 4 5 6\n9 4 2 4 2 4 5 6 7\n"
    "$EndElements\n";

TEST(WriteMsh, WritesVersion22AsTheFormatHasIt) {
  const std::string text = written(two_cells(), MshVersion::V22);
  const std::string expected = kTwoCells22;
  const auto part = [](const std::string& all, const std::string& begin, const std::string& end) {
    return all.substr(all.find(begin), all.find(end) - all.find(begin));
  };
  EXPECT_EQ(part(text, "$MeshFormat", "$Elements"), part(expected, "$MeshFormat", "$Elements"));
  EXPECT_EQ(part(text, "\n8 6", "$EndElements"), part(expected, "\n8 6", "$EndElements"));
  EXPECT_THAT(text, HasSubstr("$Elements\n9\n1 2 2 1 1 1 3 2\n"));
  // The order of the faces that no patch had is not ours to choose.
  EXPECT_EQ(text.size(), expected.size());
}

class Msh : public testing::TestWithParam<MshVersion> {};

TEST_P(Msh, ReadsBackBitForBit) {
  const Stored mesh = blocks_of_all_types(3);
  const VolumeFile file = parse_msh(written(mesh, GetParam()), "file");
  const auto order = cells_by_group(mesh.mesh());
  expect_same_cells(file.mesh, mesh.mesh(), order);
  expect_same_patches(file.boundary, mesh.boundary(), {"wall 'one'", "top", "no faces", "sides"});
  for (std::size_t c = 0; c < order.size(); ++c) EXPECT_EQ(file.mesh.layer[c], mesh.mesh().layer[order[c]]);
  EXPECT_EQ(file.skipped.all(), 0u);
}

TEST_P(Msh, WritesTheSameBytesWhateverThreads) {
  const Stored mesh = blocks_of_all_types(12);
  std::string one;
  {
    const ThreadLimit limit(1);
    one = written(mesh, GetParam());
  }
  EXPECT_EQ(one == written(mesh, GetParam()), true);
}

TEST_P(Msh, KeepsNamesApartWithoutQuotesAndLineEnds) {
  VolumeMesh mesh = block(1, as_hexahedron());
  Boundary boundary;
  mesh::fit_boundary(mesh, boundary);
  boundary.patches = {};
  const std::string long_name(500, 'x');
  for (const std::string& name : {std::string("a\"b"), std::string("a'b"), std::string("a\nb"), std::string("a b"),
                                  long_name + "1", long_name + "2"}) {
    boundary.patches.push_back({name});
  }
  for (std::size_t f = 0; f < 6; ++f) boundary.patch[f] = PatchId(f);
  const VolumeFile file = parse_msh(written({std::move(mesh), std::move(boundary)}, GetParam()), "file");
  const std::string cut(120, 'x');
  EXPECT_THAT(file.patch_names, ElementsAre("a'b_2", "a'b", "a b_2", "a b", cut, cut + "_2"));
}

TEST_P(Msh, WithstandsDamage) { expect_withstands_damage(parse_msh, written(two_cells(), GetParam()), 1); }

INSTANTIATE_TEST_SUITE_P(Versions, Msh, testing::Values(MshVersion::V41, MshVersion::V22),
                         [](const auto& test) { return test.param == MshVersion::V41 ? "V41" : "V22"; });

/// As many points or cells as asked for, which nobody may read.
class Vast final : public mesh::MeshSource {
 public:
  Vast(NodeIndex n_points, CellIndex n_cells) : n_points_(n_points), n_cells_(n_cells) {}
  NodeIndex n_points() const override { return n_points_; }
  CellIndex n_cells() const override { return n_cells_; }
  std::array<CellIndex, mesh::kNCellTypes> n_cells_by_type() const override { return {n_cells_, 0, 0, 0}; }
  std::size_t n_point_batches() const override { return 1; }
  void read_points(std::size_t, mesh::PointBatch&) const override { ADD_FAILURE() << "points are read"; }
  std::size_t n_cell_batches() const override { return 1; }
  void read_cells(std::size_t, mesh::CellBatch&) const override { ADD_FAILURE() << "cells are read"; }

 private:
  NodeIndex n_points_;
  CellIndex n_cells_;
};

TEST(WriteMsh, RefusesMoreThanVersion22NumbersBeforeItWrites) {
  const Stored small = two_cells();
  const TemporaryFolder folder;
  constexpr std::uint64_t kMost = 0x7fffffff;
  const std::size_t n_faces = small.boundary().faces.size();
  for (const Vast& mesh : {Vast(kMost + 1, 8), Vast(8, kMost + 1 - n_faces)}) {
    try {
      write_msh(folder / "mesh.msh", {mesh, small.boundary(), small.whole().neighbours, "x"}, MshVersion::V22);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("2147483648"));
      EXPECT_THAT(error.what(), HasSubstr("write MSH 4.1 instead"));
    }
    EXPECT_EQ(folder.n_files(), 0u);
  }
}

// One tetrahedron with a triangle, a quad that no cell has, a line and a point; nodes with gaps and out of order.
constexpr const char* kByHand22 =
    "$MeshFormat\n2.1 0 8\n$EndMeshFormat\n$Comments\nanything $Nodes\n$EndComments\n$PhysicalNames\n2\n2 5 \"a "
    "wall\"\n"
    "3 2 \"layers\"\n$EndPhysicalNames\n$Nodes\n5\n90 0 0 1\n7 0 0 0\n1000000 1 0 0\n3 0 1 0\n4 1.5 1 0\n$EndNodes\n"
    "$Elements\n7\n1 15 2 0 1 7\n2 1 2 0 1 7 3\n3 2 2 5 1 7 3 1000000\n4 3 3 0 8 1 7 1000000 4 3\n5 2 2 6 2 7 90 3\n"
    "6 4 2 2 1 7 1000000 3 90\n7 4 0 7 1000000 3 90\n$EndElements\n$NodeData\n1 \"x\"\n$EndNodeData\n";

constexpr const char* kByHand41 =
    "$MeshFormat\r\n4.1 0 8\r\n$EndMeshFormat\r\n$PhysicalNames\n2\n2 5 \"a wall\"\n3 2 \"layers\"\n$EndPhysicalNames\n"
    "$Entities\n1 0 3 2\n1 0 0 0 0\n1 0 0 0 1 1 1 2 -5 6 1 1\n8 0 0 0 1 1 1 0 0\n2 0 0 0 1 1 1 1 6 0\n"
    "1 0 0 0 1 1 1 1 2 1 -1\n2 0 0 0 1 1 1 0 0\n$EndEntities\n$Nodes\n2 5 3 1000000\n2 1 1 3\n90\n7\n1000000\n"
    "0 0 1 0.5 0.5\n0 0 0 0 0\n1 0 0 1 0\n3 1 0 2\n3\n4\n0 1 0\n1.5 1 0\n$EndNodes\n$Periodic\n0\n$EndPeriodic\n"
    "$Elements\n7 7 1 7\n0 1 15 1\n1 7\n1 3 1 1\n2 7 3\n2 1 2 1\n3 7 3 1000000\n2 8 3 1\n4 7 1000000 4 3\n"
    "2 2 2 1\n5 7 90 3\n3 1 4 1\n6 7 1000000 3 90\n3 2 4 1\n7 7 1000000 3 90\n$EndElements\n";

TEST(ReadMsh, ReadsFilesByHandOfBothVersions) {
  for (const char* bytes : {kByHand22, kByHand41}) {
    const VolumeFile file = parse_msh(bytes, "file");
    EXPECT_THAT(file.mesh.points,
                ElementsAre(Vec3(0, 0, 1), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1.5, 1, 0)));
    EXPECT_THAT(file.mesh.nodes, ElementsAre(1, 2, 3, 0, 1, 2, 3, 0));
    EXPECT_THAT(file.mesh.layer, ElementsAre(1, 0));
    EXPECT_THAT(file.mesh.file_cell, ElementsAre(5, 6));
    EXPECT_EQ(file.skipped.points, 1u);
    EXPECT_EQ(file.skipped.lines, 1u);
    EXPECT_THAT(file.patch_names, ElementsAre("a wall", "surface8", "patch6"));
    EXPECT_THAT(file.boundary.faces,
                ElementsAre(mesh::BoundaryFace{1, 3, 2, mesh::kNoFourthNode}, mesh::BoundaryFace{1, 2, 4, 3},
                            mesh::BoundaryFace{1, 0, 3, mesh::kNoFourthNode}));
  }
}

TEST(ReadMsh, ReadsSurfacesAlone) {
  const VolumeFile file = parse_msh(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
      "$Elements\n1 1 1 1\n2 4 2 1\n1 1 2 3\n$EndElements\n",
      "file");
  EXPECT_EQ(file.mesh.n_cells(), 0u);
  EXPECT_EQ(file.boundary.faces.size(), 1u);
  EXPECT_THAT(file.patch_names, ElementsAre("surface4"));
}

/// What the same file is in the other byte order; for version 4.1.
std::string swapped_two_points() {
  std::string bytes = "$MeshFormat\n4.1 1 8\n";
  const auto add = [&](std::uint64_t value, int n_bytes) {
    for (int i = n_bytes - 1; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  };
  const auto tags = [&](std::initializer_list<int> values) {
    for (const int value : values) add(static_cast<std::uint64_t>(value), 4);
  };
  const auto numbers = [&](std::initializer_list<std::uint64_t> values) {
    for (const std::uint64_t value : values) add(value, 8);
  };
  tags({1});
  bytes += "\n$EndMeshFormat\n$Nodes\n";
  numbers({1, 3, 1, 3});
  tags({2, 1, 0});
  numbers({3, 1, 2, 3});
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0.}) add(std::bit_cast<std::uint64_t>(x), 8);
  bytes += "\n$EndNodes\n$Elements\n";
  numbers({1, 1, 1, 1});
  tags({2, 4, 2});
  numbers({1, 1, 1, 2, 3});
  return bytes + "\n$EndElements\n";
}

TEST(ReadMsh, ReadsBigEndian) {
  const VolumeFile file = parse_msh(swapped_two_points(), "file");
  EXPECT_THAT(file.mesh.points, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
  EXPECT_THAT(file.boundary.faces, ElementsAre(mesh::BoundaryFace{0, 1, 2, mesh::kNoFourthNode}));
}

/// Version 2.2 binary: a count in text, then bytes; a run of two elements.
std::string binary_22() {
  std::string bytes = "$MeshFormat\n2.2 1 8\n";
  const auto add = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  const auto tags = [&](std::initializer_list<std::int32_t> values) {
    for (const std::int32_t value : values) add(value);
  };
  tags({1});
  bytes += "\n$EndMeshFormat\n$PhysicalNames\n1\n2 9 \"hull\"\n$EndPhysicalNames\n$Nodes\n4\n";
  for (const std::int32_t i : {1, 2, 3, 4}) {
    tags({i});
    for (const double x : {0.1 * i, 0.2, 1.0 / i}) add(x);
  }
  bytes += "\n$EndNodes\n$Elements\n3\n";
  tags({2, 2, 2, 1, 9, 1, 1, 2, 3, 2, -9, 1, 2, 3, 4, 4, 1, 2, 3, 0, 1, 1, 2, 3, 4});
  return bytes + "\n$EndElements\n";
}

TEST(ReadMsh, ReadsBinary22) {
  const VolumeFile file = parse_msh(binary_22(), "file");
  EXPECT_EQ(file.mesh.points[2], Vec3(0.1 * 3, 0.2, 1.0 / 3));
  EXPECT_THAT(file.boundary.faces, ElementsAre(mesh::BoundaryFace{0, 1, 2, mesh::kNoFourthNode},
                                               mesh::BoundaryFace{1, 2, 3, mesh::kNoFourthNode}));
  EXPECT_THAT(file.mesh.nodes, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(file.patch_names, ElementsAre("hull"));
}

TEST(ReadMsh, WithstandsDamageToFilesOfOthers) {
  for (const std::string& seed : {std::string(kByHand41), swapped_two_points(), binary_22()}) {
    expect_withstands_damage(parse_msh, seed, 1);
  }
  expect_withstands_damage(parse_msh, kByHand22, std::string("\n$NodeData\n1 \"x\"\n$EndNodeData\n").size() + 1);
}

struct Refused {
  std::string from, to, message;
};

TEST(ReadMsh, SaysWhatIsWrongAndWhere) {
  const std::vector<Refused> all = {
      {"2.1 0 8", "4.0 0 8", "file: version 4.0 of Gmsh's format, expected 2.2 or 4.1"},
      {"2.1 0 8", "1 0 8", "file: version 1 of Gmsh's format"},
      {"$MeshFormat", "$NOD", "file: version 1 of Gmsh's format"},
      {"2.1 0 8", "2.1 0 4", "file:2: expected numbers of 8 bytes, found 4"},
      {"\n5\n90", "\n5000000\n90", "the number of nodes is 5000000, more than"},
      {"1.5 1 0", "nan 1 0", "file:18: expected a coordinate as a finite number, found 'nan'"},
      {"90 0 0 1", "7 0 0 1", "two nodes have the number 7"},
      {"7 90 3", "7 91 3", "file:26: cell 4 uses node 91, which the file does not have"},
      {"5 2 2 6 2", "5 9 2 6 2", "file: cell 4 is of Gmsh's type 9: of higher order"},
      {"$EndNodes\n$El", "$El", "expected $EndNodes, found '$Elements'"},
      {"$Elements\n7\n", "$Elements\n8\n", "expected the number of an element"},
      {"\"a wall\"", "a wall", "expected a physical name in double quotes, found 'a wall'"},
  };
  for (const Refused& test : all) {
    std::string bytes = kByHand22;
    ASSERT_NE(bytes.find(test.from), std::string::npos) << test.from;
    bytes.replace(bytes.find(test.from), test.from.size(), test.to);
    try {
      parse_msh(bytes, "file");
      ADD_FAILURE() << "read in spite of " << test.to;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(test.message));
    }
  }
}

}  // namespace
}  // namespace nearwall::io

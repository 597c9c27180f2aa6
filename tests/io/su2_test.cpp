#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "io/mesh_builder.h"
#include "io/volume_formats.h"
#include "nearwall/core/parallel.h"
#include "nearwall/io/su2_writer.h"
#include "tests/io/solver_files.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using namespace whole_meshes_for_tests;
using namespace volume_meshes_for_tests;
using testing::HasSubstr;

std::string written(const Stored& mesh) {
  const TemporaryFolder folder;
  write_su2(folder / "mesh.su2", mesh.whole());
  EXPECT_EQ(folder.n_files(), 1u);
  return bytes_of(folder / "mesh.su2");
}

Stored one_wedge() {
  VolumeMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 1e-7}};
  add_cell(mesh, CellType::Wedge, {0, 1, 2, 3, 4, 5});
  Boundary boundary;
  boundary.patches.push_back({"wall", BoundaryType::Wall});
  boundary.faces.push_back({0, 2, 1, mesh::kNoFourthNode});
  boundary.patch.push_back(PatchId(0));
  return {std::move(mesh), std::move(boundary)};
}

// VTK's figure of the wedge: the first triangle clockwise seen from the second. Faces of markers clockwise from
// outside.
TEST(WriteSu2, WritesAWedgeAsTheFormatHasIt) {
  EXPECT_EQ(written(one_wedge()),
            "NDIME= 3\nNPOIN= 6\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n1 0 0.1\n0 1 1e-07\nNELEM= 1\n13 0 2 1 3 5 4\nNMARK= 2\n"
            "MARKER_TAG= wall\nMARKER_ELEMS= 1\n5 0 1 2\nMARKER_TAG= boundary\nMARKER_ELEMS= 4\n"
            "5 3 5 4\n9 0 3 4 1\n9 1 4 5 2\n9 2 5 3 0\n");
}

TEST(WriteSu2, ReadsBackBitForBit) {
  const Stored mesh = blocks_of_all_types(3);
  const VolumeFile file = parse_su2(written(mesh), "file");
  std::vector<std::size_t> order(mesh.mesh().n_cells());
  std::iota(order.begin(), order.end(), std::size_t{0});
  expect_same_cells(file.mesh, mesh.mesh(), order);
  expect_same_patches(turned(file.boundary), mesh.boundary(), {"wall__one_", "top", "no faces", "sides"});
  EXPECT_EQ(file.patch_names, std::vector<std::string>({"wall__one_", "top", "sides"}));
  EXPECT_EQ(file.skipped.all(), 0u);
}

TEST(WriteSu2, WritesTheSameBytesWhateverThreads) {
  const Stored mesh = blocks_of_all_types(12);
  std::string one;
  {
    const ThreadLimit limit(1);
    one = written(mesh);
  }
  EXPECT_EQ(one == written(mesh), true);
}

TEST(WriteSu2, MakesTagsSingleWordsThatDiffer) {
  VolumeMesh mesh = block(1, as_hexahedron());
  Boundary boundary;
  mesh::fit_boundary(mesh, boundary);
  boundary.patches = {};
  for (const char* name : {"a b", "a_b", "a\tb", "(a)b", "SEND_RECEIVE", ""}) boundary.patches.push_back({name});
  for (std::size_t f = 0; f < 6; ++f) boundary.patch[f] = PatchId(f);
  const VolumeFile file = parse_su2(written({std::move(mesh), std::move(boundary)}), "file");
  EXPECT_THAT(file.patch_names, testing::ElementsAre("a_b_2", "a_b", "a_b_3", "_a_b", "SEND_RECEIVE_2", "patch"));
}

constexpr const char* kAnyOrder =
    "% made by hand\nNDIME=3\nAOA_OFFSET= 1.5\nNMARK= 2 % two\nMARKER_TAG =  lower wall \nMARKER_ELEMS= 1\n5 0 1 2 0\n"
    "MARKER_TAG= SEND_RECEIVE\nMARKER_ELEMS= 1\nSEND_TO= 2\n1 3 0\n\n"
    "NELEM= 2\n10 0 1 2 3 0\n\n% between\n10\t1 2 3 4\t1\nNPERIODIC= 1\nPERIODIC_INDEX= 0\nPERIODIC_CENTER= 0 0 0\n"
    "FFD_NBOX= 1\nFFD_CORNER_POINTS= 1\n0 0 0\nNPOIN= 5 5\r\n0 0 0 0\r\n1 0 0 1\r\n0 1 0 2\r\n+0 0 1e0 3\r\n1 1 1 4 4";

TEST(ReadSu2, ReadsSectionsInAnyOrderWithCommentsAndNumbersBehindLines) {
  const VolumeFile file = parse_su2(kAnyOrder, "file");
  EXPECT_THAT(file.mesh.points,
              testing::ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1)));
  EXPECT_THAT(file.mesh.nodes, testing::ElementsAre(0, 1, 2, 3, 1, 2, 3, 4));
  EXPECT_THAT(file.patch_names, testing::ElementsAre("lower wall"));
  EXPECT_EQ(file.boundary.faces, (std::vector<mesh::BoundaryFace>{{0, 1, 2, mesh::kNoFourthNode}}));
}

TEST(ReadSu2, ReadsASurfaceFromElementsThatAreTrianglesAndQuads) {
  const std::string points = "NPOIN= 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 1 0\n";
  const std::string elements = "NDIME= 3\nNELEM= 3\n9 0 1 2 3 0\n3 0 1 1\n5 1 4 2 2\n";
  const VolumeFile file = parse_su2(elements + points + "NMARK= 1\nMARKER_TAG= rim\nMARKER_ELEMS= 1\n3 0 1\n", "file");
  EXPECT_EQ(file.mesh.n_cells(), 0u);
  EXPECT_EQ(file.skipped.lines, 2u);
  EXPECT_EQ(file.boundary.faces, (std::vector<mesh::BoundaryFace>{{0, 1, 2, 3}, {1, 4, 2, mesh::kNoFourthNode}}));
  EXPECT_EQ(surface_of(file, "file").faces.size(), 3u);

  const VolumeFile marked =
      parse_su2(elements + points + "NMARK= 1\nMARKER_TAG= hull\nMARKER_ELEMS= 1\n5 1 4 2\n", "file");
  EXPECT_THAT(marked.patch_names, testing::ElementsAre("hull"));
  EXPECT_EQ(marked.boundary.faces.size(), 1u);
  EXPECT_EQ(marked.skipped.faces, 2u);
}

struct Refusal {
  const char* text;
  const char* message;
};

TEST(ReadSu2, SaysWhatIsWrongAndWhere) {
  const std::string points = "NDIME= 3\nNPOIN= 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  for (const Refusal& refusal : std::vector<Refusal>{
           {"NELEM= 1\n10 0 1 2\n",
            "file:8: expected the number of a point (a whole number), found the end of the line"},
           {"NELEM= 1\n10 0 1 2 4\n", "file: cell 0 uses point 4 (counted from 0), but there are 4 points"},
           {"NELEM= 1\n10 0 1 2 -1\n", "file:8: -1 is no number of a point"},
           {"NELEM= 1\n10 0 1 2 3 0 0\n", "file:8: expected the end of the line, found '0'"},
           {"NELEM= 1000000\n10 0 1 2 3\n", "file:7: NELEM= is 1000000, more than the 12 bytes that follow can hold"},
           {"NELEM= -1\n", "file:7: expected NELEM=, found -1"},
           {"NELEM= 0\nNELEM= 0\n", "file:8: NELEM= stands twice"},
           {"NELEM= 2\n10 0 1 2 3\n", "file:9: expected element 2 of 2, found the end of the file"},
           {"NELEM= 0\n7 7 7\n", "file:8: expected a keyword such as NELEM=, NPOIN= or MARKER_TAG=, found '7'"},
           {"NELEM= 0\nMARKER_ELEMS= 0\n", "file:8: expected MARKER_TAG= before MARKER_ELEMS="},
           {"NELEM= 0\nMARKER_TAG= a\n", "file:9: expected MARKER_ELEMS= of the marker 'a'"},
           {"NELEM= 0\nNMARK= 1\n", "NMARK= claims 1 markers, the file holds 0"},
           {"NELEM= 0\nMARKER_TAG= a\nMARKER_ELEMS= 1\n10 0 1 2 3\n", "file:10: expected a triangle (5) or a quad (9)"},
           {"", "expected NELEM= somewhere in the file, found none"}}) {
    try {
      parse_su2(points + refusal.text, "file");
      ADD_FAILURE() << refusal.text;
    } catch (const GeometryError& error) {
      EXPECT_THAT(error.what(), HasSubstr(refusal.message)) << refusal.text;
    }
  }
  EXPECT_THROW(parse_su2("NDIME= 3\nNPOIN= 1\n0 nan 0\nNELEM= 0\n", "file"), GeometryError);
  EXPECT_THROW(parse_su2("NPOIN= 1\n0 0 0\nNELEM= 0\nNDIME= 3\n", "file"), GeometryError);
  EXPECT_THROW(parse_su2("", "file"), GeometryError);
}

TEST(ReadSu2, RefusesWhatItCannotHold) {
  for (const Refusal& refusal :
       std::vector<Refusal>{{"NDIME= 2\nNPOIN= 1\n0 0\n", "file:1: a mesh in the plane (NDIME= 2)"},
                            {"NZONE= 2\nIZONE= 1\nNDIME= 3\n", "file:1: the file has 2 zones, expected one"},
                            {"NDIME= 3\nNELEM= 1\n24 0 1 2 3 4 5 6 7 8 9\n",
                             "file:3: an element of type 24; read are tetrahedra (10)"}}) {
    try {
      parse_su2(refusal.text, "file");
      ADD_FAILURE() << refusal.text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(refusal.message));
    }
  }
}

// With the markers in front: SU2 needs them, we do without, so a file may end behind its elements.
TEST(ReadSu2, WithstandsDamage) {
  std::string seed = written(blocks_of_all_types(1));
  const std::size_t points = seed.find("NPOIN"), markers = seed.find("NMARK");
  std::rotate(seed.begin() + static_cast<std::ptrdiff_t>(points), seed.begin() + static_cast<std::ptrdiff_t>(markers),
              seed.end());
  expect_withstands_damage(parse_su2, seed, 2);
}

TEST(ReadSu2, WithstandsDamageToTheRarerParts) {
  ASSERT_TRUE(is_read_or_refused(parse_su2, kAnyOrder));
  Mutator mutator(37);
  for (int round = 0; round < 3000; ++round) is_read_or_refused(parse_su2, mutator.mutated(kAnyOrder));
}

}  // namespace
}  // namespace nearwall::io

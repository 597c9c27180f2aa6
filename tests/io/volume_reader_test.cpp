#include "nearwall/io/volume_reader.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/file_bytes.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/vtu_writer.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/temporary_folder.h"
#include "tests/io/volume_files.h"

namespace nearwall::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string message_of(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  try {
    read_volume_mesh(folder.file(name, bytes));
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::vector<std::uint32_t> nodes_of(const mesh::VolumeMesh& mesh, std::size_t cell) {
  const auto nodes = mesh.nodes_of(cell);
  return {nodes.begin(), nodes.end()};
}

void expect_same(const VolumeFile& found, const MeshForTests& written) {
  EXPECT_EQ(found.skipped.all(), 0u);
  EXPECT_EQ(found.mesh.points, written.points);
  ASSERT_EQ(found.mesh.n_cells(), written.cells.size());
  ASSERT_EQ(found.mesh.first_node.size(), written.cells.size() + 1);
  EXPECT_EQ(found.mesh.first_node.back(), found.mesh.nodes.size());
  for (std::size_t c = 0; c < written.cells.size(); ++c) {
    ASSERT_EQ(found.mesh.type[c], written.cells[c].type);
    ASSERT_EQ(found.mesh.file_cell[c], c);
    const auto nodes = found.mesh.nodes_of(c);
    ASSERT_EQ(found.mesh.first_node[c] + nodes.size(), found.mesh.first_node[c + 1]);
    ASSERT_TRUE(std::equal(nodes.begin(), nodes.end(), written.cells[c].nodes.begin())) << "cell " << c;
  }
}

TEST(ReadVolumeMesh, GivesBackWhatWeWrote) {
  const TemporaryFolder folder;
  for (const MeshForTests& mesh : {one_of_each(), wedge_block(80, 25), MeshForTests()}) {
    write_vtu(folder / "mesh.vtu", mesh, {}, {{"hull", "fin & rudder"}});
    const VolumeFile file = read_volume_mesh(folder / "mesh.vtu");
    expect_same(file, mesh);
    EXPECT_THAT(file.patch_names, ElementsAre("hull", "fin & rudder"));
    folder.file("mesh.VTU.gz", gzip(bytes_of(folder / "mesh.vtu")));
    expect_same(read_volume_mesh(folder / "mesh.VTU.gz"), mesh);
  }
}

TEST(ReadVolumeMesh, ReadsLegacyFilesOfBothStyles) {
  for (const std::string& text : {volume_files::kLegacyOld, volume_files::kLegacyOffsets, volume_files::kXmlAscii}) {
    const VolumeFile file = text.starts_with('#') ? parse_legacy_volume(text, "file") : parse_vtu(text, "file");
    ASSERT_EQ(file.mesh.n_cells(), 2u);
    EXPECT_EQ(file.mesh.points.size(), 7u);
    EXPECT_EQ(file.mesh.points[4], Vec3(1, 0, 1.5));
    EXPECT_EQ(file.mesh.type[0], mesh::CellType::Wedge);
    EXPECT_THAT(nodes_of(file.mesh, 0), ElementsAre(0, 1, 2, 3, 4, 5));  // in the file 0 2 1 3 5 4
    EXPECT_EQ(file.mesh.type[1], mesh::CellType::Tetrahedron);
    EXPECT_THAT(nodes_of(file.mesh, 1), ElementsAre(3, 4, 5, 6));
    EXPECT_THAT(file.mesh.file_cell, ElementsAre(1, 4));
    EXPECT_EQ(file.skipped.points, 1u);
    EXPECT_EQ(file.skipped.lines, 1u);
    EXPECT_EQ(file.skipped.faces, 1u);
  }
}

TEST(ReadVolumeMesh, TurnsVoxelsIntoHexahedra) {
  const VolumeFile file = parse_legacy_volume(
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n"
      "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n",
      "file");
  ASSERT_EQ(file.mesh.n_cells(), 1u);
  const auto corners = file.mesh.corners_of(0);
  EXPECT_DOUBLE_EQ(mesh::cell_volume(mesh::CellType::Hexahedron, corners), 1);
  EXPECT_EQ(corners[2], Vec3(1, 1, 0));
  EXPECT_EQ(corners[3], Vec3(0, 1, 0));
}

TEST(ReadVolumeMesh, AppendsPieces) {
  const std::string piece =
      "<Piece NumberOfPoints='4' NumberOfCells='2'><Points><DataArray type='Float32' format='ascii'>0 0 0 1 0 0 0 1 0 "
      "0 "
      "0 1</DataArray></Points><Cells><DataArray type='Int64' Name='connectivity' format='ascii'>3 0 1 2 "
      "3</DataArray><DataArray type='Int64' Name='offsets' format='ascii'>1 5</DataArray><DataArray type='UInt8' "
      "Name='types' format='ascii'>1 10</DataArray></Cells></Piece>";
  const std::string empty = "<Piece NumberOfPoints='0' NumberOfCells='0'></Piece>";
  const VolumeFile file = parse_vtu(
      "<VTKFile type='UnstructuredGrid'><UnstructuredGrid>" + piece + empty + piece + "</UnstructuredGrid></VTKFile>",
      "file");
  EXPECT_EQ(file.mesh.points.size(), 8u);
  ASSERT_EQ(file.mesh.n_cells(), 2u);
  EXPECT_THAT(nodes_of(file.mesh, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(nodes_of(file.mesh, 1), ElementsAre(4, 5, 6, 7));
  EXPECT_THAT(file.mesh.file_cell, ElementsAre(1, 3));
  EXPECT_THAT(file.mesh.first_node, ElementsAre(0, 4, 8));
  EXPECT_EQ(file.skipped.points, 2u);
}

/// The ascii file with one text in it changed.
std::string changed(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ReadVolumeMesh, NamesTheCellOfATypeThatIsNotOurs) {
  using volume_files::kXmlAscii;
  const std::string higher = message_of("m.vtu", changed(kXmlAscii, "1 13 3 5 10", "1 13 3 5 24"));
  EXPECT_THAT(higher, HasSubstr("m.vtu: cell 4 has VTK's type 24, expected linear tetrahedra (10)"));
  EXPECT_THAT(higher, HasSubstr("of higher order: save the mesh with linear cells"));
  EXPECT_THAT(message_of("m.vtu", changed(kXmlAscii, "1 13 3 5 10", "1 42 3 5 10")), HasSubstr("a polyhedron"));
  EXPECT_THAT(message_of("m.vtu", changed(kXmlAscii, "1 13 3 5 10", "1 15 3 5 10")), HasSubstr("cut it into wedges"));
  EXPECT_THAT(message_of("m.vtu", changed(kXmlAscii, "1 13 3 5 10", "1 99 3 5 10")), HasSubstr("unknown"));
  EXPECT_THAT(message_of("m.vtu", changed(kXmlAscii, "1 13 3 5 10", "1 13 3 5 300")), HasSubstr("has the type 300"));
  EXPECT_THROW(parse_vtu(changed(kXmlAscii, "1 13 3 5 10", "1 13 3 5 24"), "m.vtu"), InputError);
}

TEST(ReadVolumeMesh, NamesWhatIsDamaged) {
  using volume_files::kXmlAscii;
  const auto message = [&](std::string_view from, std::string_view to) {
    return message_of("m.vtu", changed(kXmlAscii, from, to));
  };
  EXPECT_THAT(message("3 4 5 6", "3 4 5 7"), HasSubstr("cell 4 uses point 7 (counted from 0), but there are 7 points"));
  EXPECT_THAT(message("3 4 5 6", "3 4 -5 6"), HasSubstr("cell 4 uses point -5"));
  EXPECT_THAT(message("3 4 5 6", "3 4 5"), HasSubstr("the cells use 16 nodes, but 15 are listed"));
  EXPECT_THAT(message("1 7 9 12 16", "1 7 7 12 16"), HasSubstr("cell 2 of VTK's type 3 has 0 nodes, expected 2"));
  EXPECT_THAT(message("1 7 9 12 16", "1 7 6 12 16"), HasSubstr("cell 2: its nodes end at entry 6, those of the cell"));
  EXPECT_THAT(message("1 7 9 12 16", "1 7 9 12"), HasSubstr("NumberOfCells is 5, but the file holds 4 offsets"));
  EXPECT_THAT(message("1 7 9 12 16", "1 7 9 12 99"), HasSubstr("the cells use 99 nodes, but"));
  EXPECT_THAT(message("1 13 3 5 10", "1 13 3 5"), HasSubstr("NumberOfCells is 5, but the file holds 4 types"));
  EXPECT_THAT(message("1 0 1.5", "1 0"), HasSubstr("the points do not have 3 coordinates each"));
  EXPECT_THAT(message("1 0 1.5", "1 0 nan"), HasSubstr("finite"));
  EXPECT_THAT(message("NumberOfPoints='7'", "NumberOfPoints='8'"),
              HasSubstr("NumberOfPoints is 8, but the file holds"));
  EXPECT_THAT(message("UnstructuredGrid'", "ImageData'"), HasSubstr("expected a VTK file of type 'UnstructuredGrid'"));
  EXPECT_THAT(message_of("m.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"),
              HasSubstr("m.vtk:4: expected 'UNSTRUCTURED_GRID'"));
}

TEST(ReadVolumeMesh, NamesThePointThatIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    MeshForTests mesh = one_of_each();
    mesh.points[11][2] = bad;
    const TemporaryFolder folder;
    write_vtu(folder / "m.vtu", mesh, {}, {});
    EXPECT_THAT(message_of("n.vtu", bytes_of(folder / "m.vtu")),
                HasSubstr("n.vtu: point 11: expected finite coordinates, found a NaN or an infinity"));
  }
}

TEST(ReadVolumeMesh, RefusesOtherFiles) {
  EXPECT_THROW(read_volume_mesh("no/such/file.vtu"), InputError);
  EXPECT_THROW(read_volume_mesh("/tmp"), InputError);
  EXPECT_THAT(message_of("m.stl", ""), HasSubstr("unknown ending '.stl', expected a mesh in one of: vtu vtk"));
  EXPECT_THAT(message_of("m.vtu", ""), HasSubstr("this is no VTK XML file"));
  EXPECT_TRUE(is_volume_name("a/b.VTU.gz"));
  EXPECT_TRUE(is_volume_name("b.vtk"));
  EXPECT_FALSE(is_volume_name("b.stl"));
}

TEST(ReadVolumeMesh, ReadsASelectionBackUnderItsOldNumbers) {
  const MeshForTests all = wedge_block(40, 25);
  const TemporaryFolder folder;
  write_vtu(folder / "all.vtu", all, {}, {});
  const VolumeFile file = read_volume_mesh(folder / "all.vtu");
  const std::vector<CellIndex> chosen{31415, 7, 8, 39999};
  const mesh::VolumeSource some(file.mesh, chosen);
  const CellArray number = numbers_in_file(some);
  write_vtu(folder / "some.vtu", some, std::span(&number, 1), {});

  const std::string bytes = bytes_of(folder / "some.vtu");
  const VolumeFile back = parse_vtu(bytes, "some.vtu");
  ASSERT_EQ(back.mesh.n_cells(), chosen.size());
  EXPECT_LE(back.mesh.points.size(), 6 * chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    EXPECT_EQ(back.mesh.corners_of(i), file.mesh.corners_of(chosen[i]));
  }
  EXPECT_THAT(volume_files::reals_of(bytes, "Cell"), ElementsAre(31415, 7, 8, 39999));
}

}  // namespace
}  // namespace nearwall::io

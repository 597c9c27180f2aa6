// The layers of cells as VTK's files have them in the array `Layer`, ours and those of others.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/volume_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/vtkhdf_writer.h"
#include "nearwall/io/vtu_writer.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LayersOfCells, AreReadFromBothOfVtksFormats) {
  const TemporaryFolder folder;
  MeshForTests mesh = one_of_each();
  mesh.cells[2].layer = 2147483647;
  write_vtu(folder / "m.vtu", mesh, {}, {});
  write_vtkhdf(folder / "m.vtkhdf", mesh, {}, {});
  for (const char* name : {"m.vtu", "m.vtkhdf"}) {
    EXPECT_THAT(read_volume_mesh(folder / name).mesh.layer, ElementsAre(1, 0, 2147483647, 2)) << name;
  }
}

/// A piece of a triangle, a tetrahedron and another. \param cell_data  arrays of it
std::string piece(const std::string& cell_data) {
  return "<Piece NumberOfPoints='5' NumberOfCells='3'><Points><DataArray type='Float32' NumberOfComponents='3' "
         "format='ascii'>0 0 0 1 0 0 0 1 0 0 0 1 1 1 1</DataArray></Points><Cells>"
         "<DataArray type='Int64' Name='connectivity' format='ascii'>0 1 2 0 1 2 3 1 2 3 4</DataArray>"
         "<DataArray type='Int64' Name='offsets' format='ascii'>3 7 11</DataArray>"
         "<DataArray type='UInt8' Name='types' format='ascii'>5 10 10</DataArray></Cells>"
         "<CellData>" +
         cell_data + "</CellData></Piece>";
}

std::string layer_array(const std::string& values, const std::string& type = "Int32", const std::string& more = "") {
  return fmt::format("<DataArray type='{}' Name='Layer' {} format='ascii'>{}</DataArray>", type, more, values);
}

mesh::VolumeMesh read_pieces(const std::string& pieces) {
  return parse_vtu("<VTKFile type='UnstructuredGrid'><UnstructuredGrid>" + pieces + "</UnstructuredGrid></VTKFile>",
                   "m.vtu")
      .mesh;
}

TEST(LayersOfCells, StayWithTheirCellsWhereOthersArePassedOver) {
  EXPECT_THAT(read_pieces(piece(layer_array("9 4 0"))).layer, ElementsAre(4, 0));
  EXPECT_THAT(read_pieces(piece(layer_array("9 4 7", "UInt8"))).layer, ElementsAre(4, 7));
}

TEST(LayersOfCells, FollowThePieces) {
  const std::string pieces = piece(layer_array("0 1 2")) + piece(layer_array("0 3 4"));
  EXPECT_THAT(read_pieces(pieces).layer, ElementsAre(1, 2, 3, 4));
}

TEST(LayersOfCells, AreNotKnownWhereAPieceHasNone) {
  EXPECT_THAT(read_pieces(piece("")).layer, IsEmpty());
  for (const std::string& pieces :
       {piece(layer_array("0 1 2")) + piece(""), piece("") + piece(layer_array("0 1 2")),
        piece(layer_array("0 1 2")) + piece(layer_array("0 1 2", "Float64")) + piece(layer_array("0 1 2"))}) {
    const mesh::VolumeMesh mesh = read_pieces(pieces);
    EXPECT_THAT(mesh.layer, IsEmpty());
    EXPECT_GE(mesh.n_cells(), 4u);
  }
}

/// Others may mean something else by that name.
TEST(LayersOfCells, AreWholeNumbersAboveZeroAndOneForEachCell) {
  EXPECT_THAT(read_pieces(piece(layer_array("-7 -1 3"))).layer, ElementsAre(0, 3));
  EXPECT_THAT(read_pieces(piece(layer_array("0 4294967296 2147483648", "Int64"))).layer, ElementsAre(0, 0));
  EXPECT_THAT(read_pieces(piece(layer_array("0 1.5 2", "Float64"))).layer, IsEmpty());
  EXPECT_THAT(read_pieces(piece(layer_array("0 0 0 1 1 1", "Int32", "NumberOfComponents='2'"))).layer, IsEmpty());
  EXPECT_THAT(read_pieces(piece(layer_array("0 1 2", "Int32", "NumberOfComponents='1'"))).layer, ElementsAre(1, 2));
}

TEST(LayersOfCells, OfAWrongNumberAreADamagedFile) {
  for (const char* values : {"1", "0 1 2 3"}) {
    try {
      read_pieces(piece(layer_array(values)));
      ADD_FAILURE() << values;
    } catch (const GeometryError& e) {
      EXPECT_THAT(e.what(), testing::HasSubstr("layers for 3 cells"));
    }
  }
}

TEST(LayersOfCells, AreNoneWithoutCells) {
  const TemporaryFolder folder;
  write_vtu(folder / "m.vtu", MeshForTests(), {}, {});
  write_vtkhdf(folder / "m.vtkhdf", MeshForTests(), {}, {});
  for (const char* name : {"m.vtu", "m.vtkhdf"}) {
    EXPECT_THAT(read_volume_mesh(folder / name).mesh.layer, IsEmpty()) << name;
  }
}

}  // namespace
}  // namespace nearwall::io

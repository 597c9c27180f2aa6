// Volume meshes that VTK's own writers wrote, in all their encodings.

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "nearwall/core/errors.h"
#include "nearwall/io/volume_reader.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

/// n cubes in a row, each followed by a voxel, two wedges, a pyramid, a tetrahedron and a triangle, all at other
/// places.
vtkSmartPointer<vtkUnstructuredGrid> many_cells(int n, int precision) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(precision == 32 ? VTK_FLOAT : VTK_DOUBLE);
  grid->SetPoints(points);
  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  const auto add = [&](int type, std::initializer_list<std::array<double, 3>> corners, int at) {
    std::vector<vtkIdType> ids;
    for (const auto& c : corners) ids.push_back(points->InsertNextPoint(c[0] + at, c[1] + type, c[2] + 0.1 * at));
    grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    region->InsertNextValue(type);
  };
  for (int i = 0; i < n; ++i) {
    add(VTK_HEXAHEDRON, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, i);
    add(VTK_VOXEL, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}, i);
    // VTK's documentation: the first triangle's normal points out of the wedge.
    add(VTK_WEDGE, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}}, i);
    add(VTK_PYRAMID, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}, i);
    add(VTK_TETRA, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, i);
    add(VTK_TRIANGLE, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, i);
  }
  grid->GetCellData()->AddArray(region);
  vtkNew<vtkStringArray> names;
  names->SetName("PatchNames");
  names->InsertNextValue("hull of it");
  grid->GetFieldData()->AddArray(names);
  return grid;
}

void expect_same(const std::filesystem::path& path, vtkUnstructuredGrid* grid, int n, double tolerance) {
  const VolumeFile file = read_volume_mesh(path);
  const auto size = static_cast<std::size_t>(n);
  EXPECT_EQ(file.skipped.faces, size);
  EXPECT_EQ(file.skipped.all(), size);
  EXPECT_EQ(file.patch_names, std::vector<std::string>{"hull of it"});
  const mesh::VolumeMesh& mesh = file.mesh;
  ASSERT_EQ(mesh.n_cells(), 5 * size);
  ASSERT_EQ(mesh.points.size(), static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    double at[3];
    grid->GetPoint(static_cast<vtkIdType>(p), at);
    ASSERT_LE(max_norm(mesh.points[p] - Vec3(at[0], at[1], at[2])), tolerance);
  }
  using enum mesh::CellType;
  const std::array types{Hexahedron, Hexahedron, Wedge, Pyramid, Tetrahedron};
  const std::array volumes{1.0, 1.0, 1.0 / 2, 1.0 / 3, 1.0 / 6};
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    ASSERT_EQ(mesh.type[c], types[c % 5]);
    ASSERT_EQ(mesh.file_cell[c], c / 5 * 6 + c % 5);
    ASSERT_NEAR(mesh::cell_volume(mesh.type[c], mesh.corners_of(c)), volumes[c % 5], 1e-4);
  }
}

/// precision of the points, width of headers, big endian, compressed
using XmlForm = std::tuple<int, int, bool, bool>;
class VolumesInXml : public testing::TestWithParam<XmlForm> {};

TEST_P(VolumesInXml, AreReadInEveryMode) {
  const auto [precision, header, is_big, is_compressed] = GetParam();
  const TemporaryFolder folder;
  constexpr int kMany = 300;  // several blocks of the size below
  const auto grid = many_cells(kMany, precision);
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
    for (const bool is_base64 : {false, true}) {
      for (const int ids : {vtkXMLWriter::Int32, vtkXMLWriter::Int64}) {
        vtkNew<vtkXMLUnstructuredGridWriter> writer;
        writer->SetInputData(grid);
        writer->SetFileName((folder / "a.vtu").c_str());
        writer->SetDataMode(mode);
        writer->SetEncodeAppendedData(is_base64);
        writer->SetIdType(ids);
        writer->SetHeaderType(header == 32 ? vtkXMLWriter::UInt32 : vtkXMLWriter::UInt64);
        is_big ? writer->SetByteOrderToBigEndian() : writer->SetByteOrderToLittleEndian();
        if (is_compressed) {
          writer->SetCompressorTypeToZLib();
          writer->SetBlockSize(1000 * 8);
        } else {
          writer->SetCompressorTypeToNone();
        }
        ASSERT_TRUE(writer->Write());
        // VTK prints doubles with 11 digits and more.
        expect_same(folder / "a.vtu", grid, kMany, mode == vtkXMLWriter::Ascii ? 1e-5 : 0.0);
      }
    }
  }
}

std::string name_of(const testing::TestParamInfo<XmlForm>& form) {
  const auto [precision, header, is_big, is_compressed] = form.param;
  return "Float" + std::to_string(precision) + "Headers" + std::to_string(header) + (is_big ? "Big" : "Little") +
         (is_compressed ? "Packed" : "Plain");
}

INSTANTIATE_TEST_SUITE_P(, VolumesInXml,
                         testing::Combine(testing::Values(32, 64), testing::Values(32, 64), testing::Bool(),
                                          testing::Bool()),
                         name_of);

TEST(VolumesOfVtk, AreReadFromSeveralPieces) {
  const TemporaryFolder folder;
  const auto grid = many_cells(40, 64);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName((folder / "a.vtu").c_str());
  writer->SetNumberOfPieces(3);
  ASSERT_TRUE(writer->Write());
  const VolumeFile file = read_volume_mesh(folder / "a.vtu");
  // Data that VTK does not know how to cut up it writes whole, as each of the pieces.
  ASSERT_EQ(file.mesh.n_cells(), 3 * 200u);
  EXPECT_EQ(file.skipped.faces, 3 * 40u);
  for (std::size_t c = 0; c < 200; ++c) ASSERT_EQ(file.mesh.corners_of(c), file.mesh.corners_of(400 + c));
}

TEST(VolumesOfVtk, AreRefusedWhenPackedInAnotherWay) {
  const TemporaryFolder folder;
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(many_cells(2, 64));
  writer->SetFileName((folder / "a.vtu").c_str());
  writer->SetCompressorTypeToLZ4();
  ASSERT_TRUE(writer->Write());
  EXPECT_THROW(read_volume_mesh(folder / "a.vtu"), GeometryError);
}

TEST(VolumesOfVtk, AreReadInLegacyFiles) {
  const TemporaryFolder folder;
  for (const int precision : {32, 64}) {
    const auto grid = many_cells(50, precision);
    for (const bool is_binary : {false, true}) {
      for (const bool is_old : {false, true}) {
        vtkNew<vtkUnstructuredGridWriter> writer;
        writer->SetInputData(grid);
        writer->SetFileName((folder / "a.vtk").c_str());
        is_binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
        if (is_old) writer->SetFileVersion(vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);
        ASSERT_TRUE(writer->Write());
        expect_same(folder / "a.vtk", grid, 50, is_binary ? 0.0 : 1e-4);
      }
    }
  }
}

}  // namespace
}  // namespace nearwall::io

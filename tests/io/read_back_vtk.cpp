// What VTK's own readers make of our files, and ours of VTK's.

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataSetReader.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLReader.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkStripper.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "nearwall/io/polydata_writer.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/surface_writer.h"
#include "nearwall/io/vtu_writer.h"
#include "tests/io/mesh_for_tests.h"
#include "tests/io/temporary_folder.h"

namespace nearwall::io {
namespace {

Vec3 point(vtkPoints* points, vtkIdType i) {
  double p[3];
  points->GetPoint(i, p);
  return {p[0], p[1], p[2]};
}

/// Volume by the divergence theorem over the faces as VTK orients them (outward): negative if our node order is wrong.
double volume(vtkCell* cell) {
  double six_volumes = 0;
  for (int f = 0; f < cell->GetNumberOfFaces(); ++f) {
    vtkPoints* corners = cell->GetFace(f)->GetPoints();
    for (vtkIdType k = 1; k + 1 < corners->GetNumberOfPoints(); ++k) {
      six_volumes += dot(point(corners, 0), cross(point(corners, k), point(corners, k + 1)));
    }
  }
  return six_volumes / 6;
}

template <class Reader>
vtkSmartPointer<Reader> read_with(const std::filesystem::path& path) {
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0u);
  return reader;
}

mesh::SurfaceMesh tetrahedron() {
  mesh::SurfaceMesh mesh;
  mesh.points.raw() = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}};
  for (const auto& f : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{2, 0, 3}}) {
    mesh.faces.push_back({VertexId(f[0]), VertexId(f[1]), VertexId(f[2])});
  }
  for (const std::size_t patch : {1, 0, 0, 1}) mesh.face_patch.push_back(PatchId(patch));
  mesh.patch_names.raw() = {"wing tip", "50%"};
  return mesh;
}

TEST(ReadBackVtu, HasPositiveVolumesInVtksOwnOrder) {
  const TemporaryFolder folder;
  write_vtu(folder / "mesh.vtu", one_of_each(), {}, {{"hull", "fin"}});
  const auto reader = read_with<vtkXMLUnstructuredGridReader>(folder / "mesh.vtu");
  vtkUnstructuredGrid* grid = reader->GetOutput();
  ASSERT_EQ(grid->GetNumberOfCells(), 4);
  const double expected[] = {1, 1.0 / 3, 1.0 / 2, 1.0 / 6};
  for (vtkIdType c = 0; c < 4; ++c) EXPECT_NEAR(volume(grid->GetCell(c)), expected[c], 1e-14) << c;
}

TEST(ReadBackVtu, HasTheArraysAndNamesOfTheContract) {
  const TemporaryFolder folder;
  const auto mesh = wedge_block(40, 20);
  const CellArray quality = {"ScaledJacobian",
                             [](const mesh::CellBatch&, std::span<double> out) { std::ranges::fill(out, 0.75); }};
  write_vtu(folder / "mesh.vtu", mesh, std::span(&quality, 1), {{"floor"}});
  const auto reader = read_with<vtkXMLUnstructuredGridReader>(folder / "mesh.vtu");
  vtkUnstructuredGrid* grid = reader->GetOutput();
  ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(mesh.cells.size()));
  ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(mesh.points.size()));
  for (const char* name : {"Layer", "Column", "Patch", "ScaledJacobian"})
    ASSERT_TRUE(grid->GetCellData()->GetArray(name)) << name;
  for (const char* name : {"Line", "Level"}) ASSERT_TRUE(grid->GetPointData()->GetArray(name)) << name;
  const vtkIdType last = grid->GetNumberOfCells() - 1;
  EXPECT_EQ(grid->GetCellData()->GetArray("Layer")->GetTuple1(last), 20);
  EXPECT_EQ(grid->GetCellData()->GetArray("Column")->GetTuple1(last), 2 * 40 * 40 - 1);
  EXPECT_EQ(grid->GetCellData()->GetArray("ScaledJacobian")->GetTuple1(last), 0.75);
  EXPECT_EQ(point(grid->GetPoints(), grid->GetNumberOfPoints() - 1), mesh.points.back());
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("PatchNames"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(0), "floor");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); c += 997) EXPECT_GT(volume(grid->GetCell(c)), 0) << c;
}

TEST(ReadBackVtp, HasLinesTrianglesAndNames) {
  const TemporaryFolder folder;
  auto data = polydata_of(tetrahedron());
  data.lines = {{0, 1}};
  data.line_data = {{"Turn", std::vector<double>{33}, 1}};
  write_polydata(folder / "a.vtp", data);
  const auto reader = read_with<vtkXMLPolyDataReader>(folder / "a.vtp");
  vtkPolyData* read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfLines(), 1);
  ASSERT_EQ(read->GetNumberOfPolys(), 4);
  EXPECT_EQ(read->GetCell(0)->GetNumberOfPoints(), 2);
  EXPECT_EQ(read->GetCellData()->GetArray("Turn")->GetTuple1(0), 33);
  EXPECT_EQ(read->GetCellData()->GetArray("Patch")->GetTuple1(1), 1);
  auto* names = vtkStringArray::SafeDownCast(read->GetFieldData()->GetAbstractArray("PatchNames"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(1), "50%");
}

TEST(ReadBackSurface, IsUnderstoodByVtkInItsFormats) {
  const TemporaryFolder folder;
  const auto mesh = tetrahedron();
  for (const char* name : {"a.stl", "a.ply", "a.vtk"}) write_surface(folder / name, mesh);
  EXPECT_EQ(read_with<vtkSTLReader>(folder / "a.stl")->GetOutput()->GetNumberOfPolys(), 4);
  EXPECT_EQ(read_with<vtkPLYReader>(folder / "a.ply")->GetOutput()->GetNumberOfPolys(), 4);
  const auto reader = read_with<vtkPolyDataReader>(folder / "a.vtk");
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPolys(), 4);
  EXPECT_EQ(point(reader->GetOutput()->GetPoints(), 3), mesh.points[VertexId(3)]);
  auto* names = vtkStringArray::SafeDownCast(reader->GetOutput()->GetFieldData()->GetAbstractArray("PatchNames"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(0), "wing tip");
}

/// A sphere with a patch array, in polygons or in triangle strips.
vtkSmartPointer<vtkPolyData> vtk_sphere(bool in_strips) {
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetThetaResolution(12);
  source->SetPhiResolution(9);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(source->GetOutputPort());
  vtkAlgorithm* last = in_strips ? static_cast<vtkAlgorithm*>(stripper) : source;
  last->Update();
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->DeepCopy(last->GetOutputDataObject(0));
  vtkNew<vtkIntArray> patch;
  patch->SetName("Patch");
  for (vtkIdType c = 0; c < sphere->GetNumberOfCells(); ++c) patch->InsertNextValue(static_cast<int>(c % 2));
  sphere->GetCellData()->AddArray(patch);
  vtkNew<vtkStringArray> names;
  names->SetName("PatchNames");
  names->InsertNextValue("even one");
  names->InsertNextValue("odd");
  sphere->GetFieldData()->AddArray(names);
  return sphere;
}

void expect_sphere(const std::filesystem::path& path, vtkPolyData* sphere, bool in_strips) {
  const auto mesh = read_surface(path);
  constexpr std::size_t kTriangles = 12 * 2 * (9 - 2);
  ASSERT_EQ(mesh.faces.size(), kTriangles);
  ASSERT_EQ(mesh.points.size(), static_cast<std::size_t>(sphere->GetNumberOfPoints()));
  for (const VertexId v : mesh.points.ids()) EXPECT_EQ(mesh.points[v], point(sphere->GetPoints(), v.index()));
  EXPECT_EQ(mesh.patch_names.size(), 2u);
  EXPECT_EQ(mesh.patch_names[PatchId(0)], "even one");
  double six_volumes = 0;  // outward: strips, too
  for (const FaceId f : mesh.faces.ids()) {
    const auto [a, b, c] = mesh.triangle(f);
    six_volumes += dot(a, cross(b, c));
    EXPECT_GT(dot(a, cross(b, c)), 0) << f.index();
    if (!in_strips) {
      EXPECT_EQ(mesh.face_patch[f], PatchId(f.index() % 2));
    }
  }
  EXPECT_GT(six_volumes, 0);
}

struct XmlForm {
  int mode;
  bool compressed;
  bool wide;
  bool encoded;
};

class ReadVtksVtp : public testing::TestWithParam<XmlForm> {};

TEST_P(ReadVtksVtp, InEveryEncoding) {
  const TemporaryFolder folder;
  for (const bool in_strips : {false, true}) {
    const auto sphere = vtk_sphere(in_strips);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(sphere);
    writer->SetFileName((folder / "a.vtp").c_str());
    writer->SetDataMode(GetParam().mode);
    GetParam().compressed ? writer->SetCompressorTypeToZLib() : writer->SetCompressorTypeToNone();
    writer->SetBlockSize(1024);
    writer->SetHeaderType(GetParam().wide ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
    writer->SetEncodeAppendedData(GetParam().encoded);
    ASSERT_TRUE(writer->Write());
    expect_sphere(folder / "a.vtp", sphere, in_strips);
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, ReadVtksVtp,
                         testing::Values(XmlForm{vtkXMLWriter::Ascii, false, false, false},
                                         XmlForm{vtkXMLWriter::Binary, false, false, false},
                                         XmlForm{vtkXMLWriter::Binary, true, true, false},
                                         XmlForm{vtkXMLWriter::Appended, false, true, false},
                                         XmlForm{vtkXMLWriter::Appended, true, false, false},
                                         XmlForm{vtkXMLWriter::Appended, true, true, true},
                                         XmlForm{vtkXMLWriter::Appended, false, false, true}));

TEST(ReadVtksLegacyFiles, InBothEncodingsAndVersions) {
  const TemporaryFolder folder;
  for (const bool in_strips : {false, true}) {
    for (const bool binary : {false, true}) {
      for (const bool old_version : {false, true}) {
        const auto sphere = vtk_sphere(in_strips);
        vtkNew<vtkPolyDataWriter> writer;
        writer->SetInputData(sphere);
        writer->SetFileName((folder / "a.vtk").c_str());
        binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
        if (old_version) writer->SetFileVersion(vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);
        ASSERT_TRUE(writer->Write());
        if (binary) {
          expect_sphere(folder / "a.vtk", sphere, in_strips);
        } else {  // VTK prints too few digits to read the same doubles back
          EXPECT_EQ(read_surface(folder / "a.vtk").faces.size(), 168u);
          EXPECT_EQ(read_surface(folder / "a.vtk").patch_names[PatchId(1)], "odd");
        }
      }
    }
  }
}

}  // namespace
}  // namespace nearwall::io

#include "io/picture_data_vtk.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkClipPolyData.h>
#include <vtkCutter.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkGeometryFilter.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>

#include "io/file_bytes.h"
#include "nearwall/core/errors.h"
#include "nearwall/io/surface_reader.h"

namespace nearwall::io {
namespace {

template <class Reader>
vtkSmartPointer<vtkDataSet> read_with_vtk(const std::filesystem::path& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkDataSet* data = reader->GetOutputAsDataSet();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || !data) {
    throw GeometryError(fmt::format("{}: VTK cannot read it ({})", path.string(),
                                    vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode())));
  }
  return data;
}

vtkSmartPointer<vtkDataSet> to_vtk(const mesh::SurfaceMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p : mesh.points) points->InsertNextPoint(p.x(), p.y(), p.z());
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIntArray> patch;
  patch->SetName("Patch");
  for (const FaceId f : mesh.faces.ids()) {
    const auto& v = mesh.faces[f];
    triangles->InsertNextCell({vtkIdType{v[0].index()}, vtkIdType{v[1].index()}, vtkIdType{v[2].index()}});
    patch->InsertNextValue(static_cast<int>(mesh.face_patch[f].index()));
  }
  vtkNew<vtkStringArray> names;
  names->SetName("PatchNames");
  for (const std::string& name : mesh.patch_names) names->InsertNextValue(name);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->GetCellData()->AddArray(patch);
  data->GetFieldData()->AddArray(names);
  return data;
}

vtkSmartPointer<vtkDataSet> load(const std::filesystem::path& path) {
  const std::string ending = format_ending(path);
  if (ending == "vtu") return read_with_vtk<vtkXMLUnstructuredGridReader>(path);
  if (ending == "vtp" && !is_gzip_name(path)) return read_with_vtk<vtkXMLPolyDataReader>(path);
  return to_vtk(read_surface(path));
}

/// The lines of a data set, or its polygons, alone with their cell data.
vtkSmartPointer<vtkPolyData> part_of(vtkPolyData* data, bool lines) {
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(data->GetPoints());
  part->GetPointData()->ShallowCopy(data->GetPointData());
  vtkCellArray* cells = lines ? data->GetLines() : data->GetPolys();
  lines ? part->SetLines(cells) : part->SetPolys(cells);
  const vtkIdType n = cells->GetNumberOfCells();
  const vtkIdType first = data->GetNumberOfVerts() + (lines ? 0 : data->GetNumberOfLines());
  part->GetCellData()->CopyAllocate(data->GetCellData(), n);
  if (n > 0) part->GetCellData()->CopyData(data->GetCellData(), 0, n, first);
  return part;
}

/// Points moved by −focus, in doubles.
void move_to_origin(vtkPolyData* data, const Vec3& focus) {
  if (!data || !data->GetPoints()) return;
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  moved->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[3];
    data->GetPoint(i, p);
    moved->SetPoint(i, p[0] - focus.x(), p[1] - focus.y(), p[2] - focus.z());
  }
  data->SetPoints(moved);
}

vtkSmartPointer<vtkPlane> plane_of(const ClipPlane& clip, const Vec3& middle) {
  const Vec3 normal = normalized(clip.normal);
  if (normal == Vec3()) throw InputError("the normal of the clip plane is zero");
  const Vec3 point = clip.point.value_or(middle);
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetNormal(normal.x(), normal.y(), normal.z());
  plane->SetOrigin(point.x(), point.y(), point.z());
  return plane;
}

vtkSmartPointer<vtkPolyData> behind(vtkPolyData* data, vtkPlane* plane) {
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(data);
  clip->SetClipFunction(plane);
  clip->InsideOutOn();
  clip->Update();
  return clip->GetOutput();
}

vtkSmartPointer<vtkPolyData> section(vtkDataSet* data, vtkPlane* plane) {
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(data);
  cutter->SetCutFunction(plane);
  cutter->GenerateTrianglesOff();  // polygons: the edges are those of the cells
  cutter->Update();
  return cutter->GetOutput();
}

void frame(PictureData& data, const PictureRequest& request) {
  double b[6];
  data.whole->GetBounds(b);
  Vec3 low(b[0], b[2], b[4]), high(b[1], b[3], b[5]);
  if (request.zoom) low = request.zoom->low, high = request.zoom->high;
  data.focus = (low + high) * 0.5;
  data.half_size = (high - low) * 0.5;
  for (int axis = 0; axis < 3; ++axis) data.half_size[axis] = std::abs(data.half_size[axis]);
  if (!(max_norm(data.half_size) > 0)) throw InputError("the part to be shown has no extent");
}

}  // namespace

PictureData load_picture_data(const PictureRequest& request) {
  PictureData data;
  data.whole = load(request.input);
  if (data.whole->GetNumberOfCells() == 0) {
    throw GeometryError(fmt::format("{}: there are no cells to be shown", request.input.string()));
  }
  double b[6];
  data.whole->GetBounds(b);
  const Vec3 middle(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]));
  vtkNew<vtkGeometryFilter> outside;
  outside->SetInputData(data.whole);
  outside->Update();
  data.skin = part_of(outside->GetOutput(), false);
  if (outside->GetOutput()->GetNumberOfLines() > 0) data.lines = part_of(outside->GetOutput(), true);
  if (request.clip) {
    const auto plane = plane_of(*request.clip, middle);
    if (vtkUnstructuredGrid::SafeDownCast(data.whole)) data.cut = section(data.whole, plane);
    data.skin = behind(data.skin, plane);
    if (data.lines) data.lines = behind(data.lines, plane);
  }
  frame(data, request);
  for (vtkPolyData* part : {data.skin.Get(), data.cut.Get(), data.lines.Get()}) move_to_origin(part, data.focus);
  return data;
}

}  // namespace nearwall::io

#include "io/scene_vtk.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>

#include "io/picture_colours_vtk.h"
#include "io/picture_data_vtk.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

constexpr Vec3 kSkinColour{0.72, 0.77, 0.84};
constexpr Vec3 kEdgeColour{0.15, 0.17, 0.20};
constexpr Vec3 kLineColour{0.75, 0.10, 0.10};
constexpr double kMargin = 1.05;    // of the frame round the box
constexpr double kBarShare = 0.16;  // of the picture's width, left for the colour bar
constexpr int kTextShare = 40;      // picture height over text height

enum class Part { Skin, Cut, Lines };

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* data, Part part, const PictureRequest& request,
                                   const Colours* colours) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarVisibility(colours && part != Part::Lines);
  if (colours) {
    colours->of_cells ? mapper->SetScalarModeToUseCellFieldData() : mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(request.colour_by.c_str());
    mapper->SetLookupTable(colours->table);
    mapper->UseLookupTableScalarRangeOn();
    mapper->SetColorModeToMapScalars();
    mapper->SetInterpolateScalarsBeforeMapping(!colours->is_categorical);
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetInterpolationToFlat();
  look->SetColor(kSkinColour.x(), kSkinColour.y(), kSkinColour.z());
  look->SetEdgeColor(kEdgeColour.x(), kEdgeColour.y(), kEdgeColour.z());
  if (part == Part::Cut) look->LightingOff();  // a section is read for its colours and edges
  const bool is_behind_cut = part == Part::Skin && request.clip && !colours;
  look->SetEdgeVisibility(request.edges && part != Part::Lines && !is_behind_cut);
  look->SetAmbient(0.25);
  look->SetDiffuse(0.8);
  if (part == Part::Lines) {
    look->SetColor(kLineColour.x(), kLineColour.y(), kLineColour.z());
    look->SetLineWidth(2.5);
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-4, -4);
  }
  return actor;
}

void set_letters(vtkTextProperty* text, const PictureRequest& request) {
  constexpr int kSmallest = 8;
  text->SetColor(0, 0, 0);
  text->SetFontFamilyToArial();
  text->SetFontSize(std::max(kSmallest, request.size[1] / kTextShare));
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}

/// The title of the colour bar, at the left of its part of the picture.
vtkSmartPointer<vtkTextActor> title_of(const PictureRequest& request) {
  auto title = vtkSmartPointer<vtkTextActor>::New();
  title->SetInput((request.title.empty() ? request.colour_by : request.title).c_str());
  title->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  title->SetPosition(0.05, 0.84);
  set_letters(title->GetTextProperty(), request);
  return title;
}

vtkSmartPointer<vtkScalarBarActor> bar_of(const Colours& colours, const PictureRequest& request) {
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colours.table);
  bar->SetNumberOfLabels(colours.is_categorical ? 0 : 6);
  bar->SetDrawAnnotations(colours.is_categorical);
  bar->SetDrawTickLabels(!colours.is_categorical);
  bar->SetLabelFormat("%-#.3g");
  bar->SetUnconstrainedFontSize(true);
  if (colours.is_categorical) bar->SetTextPositionToPrecedeScalarBar();  // annotations stand on the other side
  bar->SetPosition(0.05, 0.2);                                           // in its own part of the picture
  bar->SetWidth(colours.is_categorical ? 0.3 : 0.9);
  bar->SetHeight(0.6);
  bar->SetBarRatio(colours.is_categorical ? 0.5 : 0.2);
  for (vtkTextProperty* text : {bar->GetLabelTextProperty(), bar->GetAnnotationTextProperty()})
    set_letters(text, request);
  return bar;
}

/// Direction from the focus to the eye.
Vec3 view_of(const PictureRequest& request) {
  const Vec3 from_above_and_aside(-0.5, -0.8, 0.45);
  const Vec3 view = request.view ? *request.view : request.clip ? request.clip->normal : from_above_and_aside;
  const Vec3 unit = normalized(view);
  if (unit == Vec3()) throw InputError("the view direction is zero");
  return unit;
}

/// Looks at the origin in parallel projection; the box fills the part of the picture that `share` of its width leaves.
void aim(vtkRenderer* renderer, const PictureRequest& request, const Vec3& half_size, double share) {
  const Vec3 view = view_of(request);
  const double steep = 0.9;  // cosine from which "up" is y, not z
  const Vec3 up = std::abs(view.z()) > steep ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const Vec3 right = normalized(cross(up, view));
  const Vec3 top = cross(view, right);
  const auto reach = [&](const Vec3& direction) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) sum += std::abs(direction[axis]) * half_size[axis];
    return sum;
  };
  const double scale = kMargin * std::max(reach(top), reach(right) * request.size[1] / (request.size[0] * share));
  const Vec3 eye = view * (4 * max_norm(half_size));
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetViewUp(top.x(), top.y(), top.z());
  camera->SetParallelScale(scale);
  renderer->ResetCameraClippingRange();
}

void save(vtkRenderWindow* window, const std::filesystem::path& path) {
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  image->SetInputBufferTypeToRGB();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0) throw IoError(path.string() + ": the picture cannot be written");
}

}  // namespace

void render(const PictureRequest& request) {
  const PictureData data = load_picture_data(request);
  std::optional<Colours> colours;
  if (!request.colour_by.empty()) colours = colours_for(data.whole, request);
  const Colours* table = colours ? &*colours : nullptr;

  const double share = table ? 1 - kBarShare : 1;
  vtkNew<vtkRenderer> renderer, beside;
  for (vtkRenderer* r : {renderer.Get(), beside.Get()}) r->SetBackground(1, 1, 1);
  renderer->SetViewport(0, 0, share, 1);
  beside->SetViewport(share, 0, 1, 1);
  // Beside a section the rest stays plain, so that the colours of the section can be read.
  renderer->AddActor(actor_of(data.skin, Part::Skin, request, data.cut ? nullptr : table));
  if (data.cut) renderer->AddActor(actor_of(data.cut, Part::Cut, request, table));
  if (data.lines) renderer->AddActor(actor_of(data.lines, Part::Lines, request, nullptr));
  if (table) beside->AddActor2D(bar_of(*table, request)), beside->AddActor2D(title_of(request));

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(request.size[0], request.size[1]);
  window->AddRenderer(renderer);
  if (table) window->AddRenderer(beside);
  aim(renderer, request, data.half_size, share);
  window->Render();
  save(window, request.output);
}

}  // namespace nearwall::io

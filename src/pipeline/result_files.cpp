#include "pipeline/result_files.h"

#include <algorithm>

#include <fmt/format.h>

#include "nearwall/geometry/box.h"
#include "nearwall/io/picture.h"
#include "pipeline/close_up.h"
#include "pipeline/stage_clock.h"
#include "pipeline/surface_file.h"

namespace nearwall::pipeline {

namespace {

/// More than these, and their edges leave nothing of the colours of a picture of the whole surface.
constexpr std::size_t kMostTrianglesWithEdges = 8000;

/// Makes one picture. \returns whether more of them make sense
bool make_picture(const io::PictureRequest& request, ProgressSink& progress) {
  try {
    const io::PictureResult result = io::render_picture(request);
    if (!result.made) progress.note(fmt::format("pictures are left out: {}", result.reason));
    return result.made;
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& e) {
    progress.warn(fmt::format("a picture is left out: {}", e.what()));
    return false;
  }
}

}  // namespace

/// Walls and what is beside them, without far fields and openings: these would hide what matters. Empty: all.
IdVector<FaceId, char> faces_of_bodies(const Prepared& prepared) {
  const mesh::SurfaceMesh& surface = prepared.surface();
  const auto types = patch_types(prepared.settings, surface.patch_names.raw());
  IdVector<FaceId, char> is_shown;
  for (const PatchId patch : surface.face_patch) is_shown.push_back(is_side(types[patch.index()]) ? 0 : 1);
  const bool is_all = std::find(is_shown.begin(), is_shown.end(), 0) == is_shown.end();
  return is_all ? IdVector<FaceId, char>() : is_shown;
}

/// Round what has layers on a plane, with a quarter of its extent on either side.
io::ZoomBox box_of_walls_on(const Result& result, mesh::PlaneIndex plane) {
  geometry::Box box;
  for (const LineId line : result.growth.front.line_vertex.ids()) {
    const VertexId v = result.growth.front.line_vertex[line];
    if (!result.prepared.wall.planes.is_on(v, plane) || !(result.growth.asked_thickness[line] > 0)) continue;
    box.include(result.growth.lines.base[line]);
  }
  if (box.is_empty()) box = geometry::bounding_box(result.wall.surface.points.raw());
  const double margin = 0.25 * box.diagonal();
  const Vec3 around(margin, margin, margin);
  return {box.low - around, box.high + around};
}

void LayersOfInput::read_cells(std::size_t batch, mesh::CellBatch& out) const {
  source_.read_cells(batch, out);
  for (std::int64_t& column : out.column) {
    if (column < 0) continue;
    const FaceId input = input_face_[FaceId(static_cast<std::size_t>(column))];
    column = input.is_valid() ? std::int64_t{input.index()} : -1;
  }
}

void write_surfaces(const Result& result, const std::string& name, OutputDirectory& output) {
  const IdVector<FaceId, char> is_shown = faces_of_bodies(result.prepared);
  io::write_polydata(output.aside(name + "-surface.vtp"),
                     surface_file(result.wall, result.growth, result.coverage, result.prepared.input_face, is_shown));
  io::write_polydata(output.aside(name + "-front.vtp"), front_file(result.wall, result.growth, is_shown));
}

std::vector<Picture> make_pictures(const Result& result, const std::string& name, bool has_volume,
                                   OutputDirectory& output, ProgressSink& progress) {
  std::vector<Picture> pictures;
  progress.begin_stage("pictures");
  io::PictureRequest request;
  const auto make = [&](const std::string& file, const std::string& title) {
    request.output = output.scratch(file);
    if (!make_picture(request, progress)) return false;
    output.aside(file);
    pictures.push_back({file, title});
    return true;
  };
  request.input = output.scratch(name + "-surface.vtp");
  request.edges = result.wall.surface.faces.size() <= kMostTrianglesWithEdges;
  request.colour_by = "PointKind";
  bool goes_on = make(name + "-surface-kinds.png", "Points of the surface by kind");
  progress.update(0.3);
  if (goes_on) {
    request.colour_by = "Layers";
    request.range = {0, std::max<double>(1, result.growth.lines.table.n_levels())};
    request.title = "layers";
    goes_on = make(name + "-surface-layers.png", "Layers on each triangle");
  }
  progress.update(0.6);
  if (const auto place = goes_on ? choose_close_up(result.wall, result.growth) : std::nullopt) {
    request.input = output.scratch(name + "-close-up.vtu");
    write_columns_near(result.wall, result.growth, *place, request.input);
    request.colour_by = "Layer";
    request.edges = true;
    request.title = "layer, from the wall";
    request.clip = place->plane;
    request.zoom = place->zoom;
    goes_on = make(name + "-clip.png", "Section through the layers, close up");
  }
  const mesh::SidePlanes& planes = result.prepared.wall.planes;
  if (goes_on && has_volume && !planes.empty()) {
    request = io::PictureRequest();
    request.input = output.scratch(name + "-boundary.vtp");
    request.colour_by = "Patch";
    request.view = -planes.planes.front().normal;
    request.zoom = box_of_walls_on(result, 0);
    make(name + "-side.png", "Layers and the rest on a side of the domain");
  }
  progress.end_stage();
  return pictures;
}

}  // namespace nearwall::pipeline

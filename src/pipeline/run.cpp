#include "nearwall/pipeline/run.h"

#include <sys/resource.h>

#include <algorithm>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/helper_process.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/io/polydata_writer.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/layers/grow.h"
#include "nearwall/pipeline/faults_file.h"
#include "pipeline/domain.h"
#include "pipeline/mesh_files.h"
#include "pipeline/output_directory.h"
#include "pipeline/prepare.h"
#include "pipeline/result_files.h"
#include "pipeline/sha256.h"
#include "pipeline/stage_clock.h"
#include "pipeline/surface_file.h"
#include "pipeline/version.h"
#include "pipeline/volume_stage.h"

namespace nearwall {

namespace {

using namespace pipeline;

/// Cells and the space between wall and front may differ by rounding only; more than this would be a defect.
constexpr double kLargestClosure = 1e-9;

/// Thickness of the layers in diagonals of the surface beyond which a unit must be wrong. With the range that admission
/// grants to coordinates it also keeps the volumes of cells within a double.
constexpr double kLargestThickness = 1e6;

std::uint64_t peak_memory() {
  rusage own{}, helpers{};
  getrusage(RUSAGE_SELF, &own);
  getrusage(RUSAGE_CHILDREN, &helpers);
  constexpr std::uint64_t kKibibyte = 1024;
  return static_cast<std::uint64_t>(std::max(own.ru_maxrss, helpers.ru_maxrss)) * kKibibyte;
}

SurfaceReport describe_surface(const Prepared& p) {
  SurfaceReport s;
  s.points = static_cast<std::uint64_t>(
      std::count_if(p.wall.vertex.begin(), p.wall.vertex.end(), [](VertexId v) { return v.is_valid(); }));
  s.triangles = static_cast<std::uint64_t>(
      std::count_if(p.input_face.begin(), p.input_face.end(), [](FaceId f) { return f.is_valid(); }));
  s.components = p.admission.components.size();
  for (const auto& component : p.admission.components) s.unwetted_components += !component.is_wetted;
  s.merged_points = p.n_merged_points;
  // The far field that was made is left out.
  for (const HalfedgeId h : p.features.is_ridge.ids()) {
    if (!p.features.is_ridge[h] || p.topology.twin(h) < h) continue;
    if (!p.input_face[mesh::Topology::face(h)].is_valid()) continue;
    ++(p.features.turn[h] > 0 ? s.convex_ridges : s.concave_ridges);
  }
  for (const VertexId v : p.features.kind.ids()) {
    if (!p.wall.vertex[v].is_valid()) continue;
    const surface::PointKind kind = p.features.kind[v];
    s.corners += kind == surface::PointKind::Corner;
    s.ridge_ends += kind == surface::PointKind::RidgeEnd;
    s.tips += kind == surface::PointKind::Tip;
  }
  s.repairs = p.admission.repairs;
  return s;
}

/// Refuses the surface with the triangles concerned in a file, where a file may be written.
[[noreturn]] void reject(const surface::SurfaceRejected& rejected, const Case& settings, OutputDirectory* output) {
  if (!output) throw surface::SurfaceRejected(rejected.what(), rejected.admission);
  const std::string file = settings.output_name() + "-faults.vtp";
  // As it was admitted: with caps, where it is cut open.
  Case effective = settings;
  std::vector<std::string> notes;
  const mesh::SurfaceMesh surface = with_flat_sides(read_wall(settings, silent_progress()), effective, notes);
  io::write_polydata(output->aside(file), faults_file(surface, rejected.admission.faults));
  output->publish();
  throw surface::SurfaceRejected(
      fmt::format("{}\nThe triangles concerned: {}", rejected.what(), (output->path() / file).string()),
      rejected.admission);
}

Prepared prepare_or_reject(const Case& settings, OutputDirectory* output, ProgressSink& progress) {
  try {
    return prepare(settings, progress);
  } catch (const surface::SurfaceRejected& rejected) {
    reject(rejected, settings, output);
  }
}

void check_thickness(const Case& settings, const std::vector<PatchSettings>& patches, double diagonal) {
  for (const PatchSettings& patch : patches) {
    const double thickness = patch.largest_thickness;
    if (thickness <= kLargestThickness * diagonal) continue;
    throw InputError(fmt::format(
        "{}: layers: expected a total thickness of at most {:g} diagonals of the surface, found {:.3g}, and "
        "the diagonal is {:.3g}; check units and growth",
        settings.file.string(), kLargestThickness, thickness, diagonal));
  }
}

layers::GrowOptions grow_options(const Case& settings, const std::vector<PatchSettings>& patches) {
  layers::GrowOptions options;
  options.normals = settings.normals;
  options.filter = settings.smoothing.filter;
  options.smoothing_iterations = settings.smoothing.iterations;
  options.several_lines = settings.is_multi_allowed;
  options.multi_angle = geometry::to_radians(settings.multi_angle_deg);
  options.max_turn = geometry::to_radians(settings.max_turn_deg);
  for (const PatchSettings& patch : patches) {
    options.schedules.push_back({patch.type == PatchType::Wall, patch.schedule.heights, patch.on_conflict,
                                 patch.max_level_step, patch.first_height, patch.total_thickness,
                                 patch.is_until_isotropic});
  }
  return options;
}

layers::Wall wall_of(const Prepared& prepared) {
  return {prepared.surface(), prepared.topology,        prepared.features,
          prepared.is_wetted, prepared.fluid_is_inside, prepared.wall.planes.empty() ? nullptr : &prepared.wall.planes};
}

certify::CertifiedWall certified_wall(const layers::Wall& wall) {
  return {wall.surface, layers::wetted_components(wall), wall.fluid_is_inside, wall.planes};
}

certify::Certificate certify_or_fail(const mesh::LayerMesh& layer_mesh, const layers::Wall& wall,
                                     ProgressSink& progress) {
  const certify::CertifiedWall certified = certified_wall(wall);
  const certify::Certificate c = certify::certify_layers(layer_mesh, certified, progress);
  if (!c.is_valid() || !(c.closure() <= kLargestClosure)) {
    throw InternalError(fmt::format(
        "the layers could not be certified: {} columns not positive, {} sides turned, {} front intersections, {} "
        "components covered twice, closure {:.3g}; nothing was written",
        c.n_bad_columns, c.n_turned_sides, c.n_front_intersections, c.n_covered_twice, c.closure()));
  }
  return c;
}

IdVector<PatchId, quality::PatchRequest> requests_of(const std::vector<PatchSettings>& patches) {
  IdVector<PatchId, quality::PatchRequest> requests;
  for (const PatchSettings& patch : patches) {
    const spacing::Schedule& s = patch.schedule;
    requests.push_back({patch.type == PatchType::Wall, s.first_height, s.total_thickness, static_cast<Level>(s.count),
                        patch.first_height || patch.total_thickness, patch.is_until_isotropic});
  }
  return requests;
}

/// Patches of the surface file; with a fill those that were made, too.
std::size_t n_reported_patches(const Prepared& prepared) {
  const mesh::SurfaceMesh& surface = prepared.surface();
  if (prepared.settings.volume.fill != Fill::None) return surface.patch_names.size();
  std::size_t n = surface.patch_names.size();
  for (const FaceId f : surface.faces.ids()) {
    if (!prepared.wall.face[f].is_valid()) n = std::min<std::size_t>(n, surface.face_patch[f].index());
  }
  return n;
}

/// Quality and coverage into the report. \returns the coverage of each triangle
IdVector<FaceId, quality::FaceCoverage> measure(const layers::Wall& wall, const layers::Growth& growth,
                                                const mesh::LayerMesh& layers,
                                                const std::vector<PatchSettings>& patches, std::size_t n_shown,
                                                Report& report) {
  report.quality = quality::layer_quality(layers, wall.surface);
  const auto requests = requests_of(patches);
  const quality::LineOutcome outcome{growth.asked_thickness, growth.reached_thickness, growth.reason,
                                     &growth.asked_levels, &growth.asked_first_height};
  auto coverage = quality::face_coverage(layers, wall.surface, requests, outcome);
  const auto by_patch = quality::patch_coverage(wall.surface, coverage, requests, wall.is_wetted);
  report.limited = quality::limited_lines(wall.surface, growth.front, growth.lines, outcome, requests);
  for (const PatchId p : by_patch.ids()) {
    const PatchSettings& patch = patches[p.index()];
    // Patches that were made come last; without a fill they are in no file.
    if (p.index() >= n_shown) break;
    report.patches.push_back(
        {wall.surface.patch_names[p], patch.type, patch.min_coverage, by_patch[p], report.limited.by_patch[p]});
  }
  return coverage;
}

void write_reports(const std::vector<Picture>& pictures, OutputDirectory& output, Report& report) {
  const auto json = output.aside("report.json"), html = output.aside("report.html");
  report.pictures = pictures;
  report.files = output.planned();
  report.peak_memory_bytes = peak_memory();
  io::write_text(html, to_html(report, output.scratch("")));
  io::write_text(json, to_json(report));
}

Forecast forecast_of(const Case& settings, const Prepared& prepared, const std::vector<PatchSettings>& patches) {
  const layers::Wall wall = wall_of(prepared);
  const layers::GrowOptions options = grow_options(settings, patches);
  const bool any_isotropic =
      std::any_of(patches.begin(), patches.end(), [](const auto& patch) { return patch.is_until_isotropic; });
  Forecast result = forecast(wall.surface, patches, wall.is_wetted, layers::forecast_fan_faces(wall, options),
                             any_isotropic ? layers::asked_levels(wall, options) : IdVector<VertexId, Level>());
  if (prepared.settings.volume.fill != Fill::None) {
    add_fill(wall.surface.faces.size(), prepared.settings.volume.growth, result);
  }
  add_mesh_files(settings.output.formats, result);
  return result;
}

VolumeReport describe_volume(const Volume& v, std::size_t n_patches) {
  VolumeReport report{v.fill.tetrahedra.size(), v.certificate, v.quality, std::vector<BoundaryPatch>(n_patches)};
  for (std::size_t f = 0; f < v.boundary.faces.size(); ++f) {
    BoundaryPatch& patch = report.boundary[v.boundary.patch[f].index()];
    ++(v.boundary.size_of(f) == 3 ? patch.triangles : patch.quads);
    const auto corner = [&](int k) { return v.boundary.points[v.boundary.faces[f][static_cast<std::size_t>(k)]]; };
    for (int k = 1; k + 1 < v.boundary.size_of(f); ++k) {
      patch.area += geometry::triangle_area(corner(0), corner(k), corner(k + 1));
    }
  }
  return report;
}

void count_cells(const mesh::MeshSource& mesh, Report& report) {
  report.cells = mesh.n_cells_by_type();
  report.points = mesh.n_points();
}

void write_layers_alone(const Result& result, const mesh::MeshSource& cells, const std::string& name,
                        std::span<const io::MeshFormat> formats, OutputDirectory& output, StageClock& clock,
                        Report& report) {
  count_cells(cells, report);
  auto patches = boundary_patches(result.prepared);
  const volume::DomainBoundary boundary = boundary_of_layers(result, certified_wall(result.wall), patches);
  write_mesh_files(result, {cells, boundary, std::move(patches)}, name, formats, output, clock);
}

/// Layers and volume; where it cannot be had, NAME-layers.vtu with the layers alone.
void write_with_volume(const Result& result, const mesh::MeshSource& layers, OutputDirectory& output, StageClock& clock,
                       Report& report) {
  const auto made = fill_volume(result.prepared, certified_wall(result.wall), result.layers, layers,
                                report.certificate.cells_volume, clock);
  if (const auto* failure = std::get_if<VolumeFailure>(&made)) {
    report.volume_failure = failure->reason;
    if (!failure->triangles.empty()) {
      io::write_polydata(output.aside(report.name + "-fill-faults.vtp"), fill_faults_file(*failure));
    }
    constexpr io::MeshFormat kVtu[] = {io::MeshFormat::Vtu};
    return write_layers_alone(result, layers, report.name + "-layers", kVtu, output, clock, report);
  }
  const Volume& filled = std::get<Volume>(made);
  report.volume = describe_volume(filled, result.wall.surface.patch_names.size());
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    // Sides on which layers land have no faces of their own before.
    if (!has_layers(report.patches[p].type)) report.patches[p].coverage.area = report.volume->boundary[p].area;
  }
  const volume::HybridMesh hybrid(layers, filled.rest, filled.fill);
  count_cells(hybrid, report);
  const volume::FilledRest rest{filled.rest, filled.fill, hybrid};
  write_mesh_files(result, {hybrid, filled.boundary, boundary_patches(result.prepared), &rest}, report.name,
                   result.prepared.settings.output.formats, output, clock);
}

/// The meshes, of layers and volume or of the layers alone, and the surfaces.
void write_results(const Result& result, OutputDirectory& output, StageClock& clock, Report& report) {
  const LayersOfInput layers(result.prepared, result.layers);
  if (result.prepared.settings.volume.fill == Fill::None) {
    write_layers_alone(result, layers, report.name, result.prepared.settings.output.formats, output, clock, report);
  } else {
    write_with_volume(result, layers, output, clock, report);
  }
  write_surfaces(result, report.name, output);
}

/// Layers, certificate, figures and files of a wall that was admitted.
void mesh_wall(const Case& settings, const Prepared& prepared, const std::vector<PatchSettings>& patches,
               OutputDirectory& output, StageClock& clock, Report& report) {
  const layers::Wall wall = wall_of(prepared);
  const layers::Growth growth = layers::grow(wall, grow_options(settings, patches), clock);
  const mesh::LayerMesh layers(growth.front, growth.lines);
  report.certificate = certify_or_fail(layers, wall, clock);
  report.certified = true;
  report.rounds = growth.rounds;
  report.smoothing_iterations = growth.smoothing_iterations;
  for (const auto& normal : growth.normals) report.surface.blind += !normal.is_visible;
  const auto coverage = staged(
      clock, "quality", [&] { return measure(wall, growth, layers, patches, n_reported_patches(prepared), report); });

  const Result result{prepared, wall, growth, layers, coverage};
  write_results(result, output, clock, report);
  std::vector<Picture> pictures;
  if (settings.output.pictures) pictures = make_pictures(result, report.name, report.volume.has_value(), output, clock);
  clock.write_to(report);
  if (settings.output.report) write_reports(pictures, output, report);
  report.files = output.publish();
}

}  // namespace

Report run(const Case& settings, ProgressSink* progress) { return run(settings, RunOptions{}, progress); }

Report run(const Case& settings, const RunOptions& options, ProgressSink* progress) {
  StageClock clock(progress ? *progress : silent_progress());
  Report report;
  report.name = settings.output_name();
  report.version = kVersion;
  report.settings = settings;
  report.dry_run = options.dry_run;
  report.input_file = settings.surface_path().string();
  report.output_directory = options.output_directory.value_or(settings.output_directory());

  std::optional<OutputDirectory> output;
  if (!options.dry_run) output.emplace(report.output_directory, report.name, options.force);
  const Prepared prepared = prepare_or_reject(settings, output ? &*output : nullptr, clock);
  report.input_sha256 = sha256_of_files(io::surface_files(settings.surface_path()));
  report.surface = describe_surface(prepared);
  for (const std::string& repair : prepared.admission.repairs) clock.note(repair);
  for (const std::string& note : prepared.notes) clock.note(note);
  if (report.surface.unwetted_components > 0) {
    clock.warn(fmt::format("{} of {} components are out of the fluid's reach and get no layers",
                           report.surface.unwetted_components, report.surface.components));
  }
  const auto patches = resolve_patches(prepared.settings, prepared.surface(), prepared.topology);
  for (const PatchSettings& patch : patches) {
    for (const std::string& warning : patch.warnings) clock.warn(warning);
  }
  if (settings.volume.fill != Fill::None && find_helper("nearwall-tetgen").empty()) {
    clock.warn(
        "the program nearwall-tetgen is missing, so the volume will not be filled; it belongs beside nearwall, or "
        "NEARWALL_TETGEN names it");
  }
  report.forecast = forecast_of(settings, prepared, patches);
  check_thickness(settings, patches, report.forecast.box.diagonal());
  clock.note(describe(report.forecast));

  if (output) {
    mesh_wall(settings, prepared, patches, *output, clock, report);
  } else {
    clock.write_to(report);
  }
  report.peak_memory_bytes = peak_memory();
  return report;
}

}  // namespace nearwall

#include "pipeline/prepare.h"

#include "nearwall/geometry/angles.h"
#include "nearwall/surface/weld.h"
#include "pipeline/case_patches.h"
#include "pipeline/domain.h"
#include "pipeline/stage_clock.h"

namespace nearwall::pipeline {

mesh::SurfaceMesh read_wall(const Case& settings, ProgressSink& progress, std::size_t* n_read) {
  mesh::SurfaceMesh surface = staged(progress, "reading", [&] { return read_with_lengths(settings); });
  if (n_read) *n_read = surface.points.size();
  check_point_arrays(settings, surface);
  if (settings.surface.scale != 1) {
    for (Vec3& p : surface.points) p *= settings.surface.scale;
    for (mesh::PointArray& array : surface.point_arrays) {
      for (double& value : array.values) value *= settings.surface.scale;
    }
  }
  return staged(progress, "welding", [&] { return surface::weld(surface, settings.surface.weld.value_or(0)); });
}

namespace {

/// A ridge that meets a side of the domain does not end there.
void carry_ridges_on(const mesh::SidePlanes& planes, surface::Features& features) {
  if (planes.empty()) return;
  for (const VertexId v : features.kind.ids()) {
    if (planes.is_on_plane(v) && features.kind[v] == surface::PointKind::RidgeEnd) {
      features.kind[v] = surface::PointKind::Ridge;
    }
  }
}

}  // namespace

Prepared prepare(const Case& settings, ProgressSink& progress) {
  std::size_t n_read = 0;
  mesh::SurfaceMesh welded = read_wall(settings, progress, &n_read);
  const std::size_t n_merged = n_read - welded.points.size();
  const std::size_t n_faces_read = welded.faces.size();

  progress.begin_stage("admission");
  Case effective = settings;
  std::vector<std::string> notes;
  welded = with_flat_sides(std::move(welded), effective, notes);
  surface::Admission admission = surface::admit(std::move(welded), {settings.surface.fluid, settings.surface.repair});
  surface::OpenWall wall = open_wall(effective, admission);
  notes.insert(notes.end(), wall.notes.begin(), wall.notes.end());
  progress.end_stage();

  progress.begin_stage("features");
  mesh::Topology topology(wall.surface);
  surface::FeatureOptions options;
  options.ridge_angle = geometry::to_radians(settings.ridge_angle_deg);
  surface::Features features = surface::find_features(wall.surface, topology, options);
  carry_ridges_on(wall.planes, features);
  IdVector<FaceId, char> is_wetted(wall.surface.faces.size(), 1);
  IdVector<FaceId, FaceId> input_face(wall.surface.faces.size());
  bool has_outer = false;
  for (const FaceId f : is_wetted.ids()) {
    const FaceId closed = wall.face[f];
    if (!wall.is_cut_off.empty() && wall.is_cut_off[f]) is_wetted[f] = 0;
    has_outer |= !closed.is_valid();
    if (!closed.is_valid()) continue;
    if (is_wetted[f]) is_wetted[f] = admission.components[admission.face_component[closed]].is_wetted;
    const FaceId input = admission.input_face[closed];
    if (input.index() < n_faces_read) input_face[f] = input;  // else a cap that was made
  }
  const bool is_inside = has_outer || settings.surface.fluid == surface::FluidSide::Inside;
  require_domain(wall, topology, is_wetted, is_inside);
  progress.end_stage();
  return {std::move(effective),
          std::move(admission),
          std::move(wall),
          std::move(input_face),
          std::move(topology),
          std::move(features),
          std::move(is_wetted),
          is_inside,
          n_merged,
          std::move(notes)};
}

}  // namespace nearwall::pipeline

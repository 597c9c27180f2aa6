#include "pipeline/prepare.h"

#include "nearwall/geometry/angles.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/surface/weld.h"
#include "pipeline/stage_clock.h"

namespace nearwall::pipeline {

mesh::SurfaceMesh read_wall(const Case& settings, ProgressSink& progress, std::size_t* n_read) {
  mesh::SurfaceMesh surface =
      staged(progress, "reading", [&] { return io::read_surface(settings.surface_path(), point_arrays(settings)); });
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

Prepared prepare(const Case& settings, ProgressSink& progress) {
  std::size_t n_read = 0;
  mesh::SurfaceMesh welded = read_wall(settings, progress, &n_read);
  const std::size_t n_merged = n_read - welded.points.size();

  progress.begin_stage("admission");
  surface::Admission admission = surface::admit(std::move(welded), {settings.surface.fluid, settings.surface.repair});
  progress.end_stage();

  progress.begin_stage("features");
  mesh::Topology topology(admission.surface);
  surface::FeatureOptions options;
  options.ridge_angle = geometry::to_radians(settings.ridge_angle_deg);
  surface::Features features = surface::find_features(admission.surface, topology, options);
  IdVector<FaceId, char> is_wetted(admission.surface.faces.size(), 1);
  for (const FaceId f : is_wetted.ids()) {
    is_wetted[f] = admission.components[admission.face_component[f]].is_wetted;
  }
  progress.end_stage();
  return {std::move(admission), std::move(topology), std::move(features), std::move(is_wetted), n_merged};
}

}  // namespace nearwall::pipeline

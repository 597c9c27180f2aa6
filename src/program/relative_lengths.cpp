#include "program/relative_lengths.h"

#include <span>

#include "nearwall/geometry/box.h"
#include "nearwall/io/surface_reader.h"

namespace nearwall::program {

namespace {

void multiply(LayerSettings& layers, double factor) {
  if (layers.first_height) *layers.first_height *= factor;
  if (layers.total_thickness) *layers.total_thickness *= factor;
  for (double& height : layers.heights) height *= factor;
}

void multiply(VolumeSettings& volume, double factor) {
  FarFieldSettings& far_field = volume.far_field;
  for (auto* length : {&far_field.radius, &far_field.size}) {
    if (*length) **length *= factor;
  }
  for (auto* point : {&far_field.centre, &far_field.lower, &far_field.upper}) {
    if (*point) **point *= factor;
  }
  for (SymmetrySetting& plane : volume.symmetry) {
    if (plane.at) *plane.at *= factor;
  }
}

}  // namespace

void make_lengths_absolute(Case& settings) {
  const mesh::SurfaceMesh surface = io::read_surface(settings.surface_path());
  const geometry::Box box = geometry::bounding_box(std::span(surface.points.raw()));
  const double diagonal = box.diagonal() * settings.surface.scale;
  multiply(settings.layers, diagonal);
  for (PatchRule& rule : settings.patches) multiply(rule.layers, diagonal);
  multiply(settings.volume, diagonal);
}

}  // namespace nearwall::program

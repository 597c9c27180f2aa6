#pragma once

#include <functional>
#include <string>
#include <utility>

#include "layers/cut_wall.h"
#include "layers/vertex_field.h"
#include "tests/support/gallery.h"

namespace nearwall::layers {

/// Ten layers on each patch, as thick as asked for its name; 0: none.
inline GrowOptions ten_layers(const mesh::SurfaceMesh& surface,
                              const std::function<double(const std::string&)>& thickness) {
  GrowOptions options;
  for (const std::string& name : surface.patch_names) {
    PatchSchedule schedule;
    schedule.has_layers = thickness(name) > 0;
    if (schedule.has_layers) schedule.heights = growing_for_tests::geometric(thickness(name), 1.2, 10);
    options.schedules.push_back(schedule);
  }
  return options;
}

/// A wall, what is asked of it, and its lines before any limit.
struct Asked {
  Asked(mesh::SurfaceMesh surface, const std::function<double(const std::string&)>& thickness, bool inside = false)
      : wall(std::move(surface), inside),
        options(ten_layers(wall.surface(), thickness)),
        stacks(options.schedules),
        field(ask(wall.wall(), options, stacks)) {
    options.filter = surface::SmoothingFilter::None;
    plan = set_lines(wall.wall(), options, find_cuts(wall.wall(), options), field, normals, sweeps);
  }
  Asked(mesh::SurfaceMesh surface, double total, bool inside = false)
      : Asked(
            std::move(surface), [total](const std::string&) { return total; }, inside) {}

  growing_for_tests::TestWall wall;
  GrowOptions options;
  Stacks stacks;
  VertexField field;
  IdVector<VertexId, surface::PointNormal> normals;
  int sweeps = 0;
  LinePlan plan;
};

}  // namespace nearwall::layers

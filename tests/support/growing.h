#pragma once

#include <memory>
#include <utility>

#include "nearwall/certify/certificate.h"
#include "nearwall/layers/grow.h"
#include "nearwall/mesh/layer_mesh.h"

namespace nearwall::growing_for_tests {

/// A wall with all that growing needs, kept together so that references into it stay good.
class TestWall {
 public:
  explicit TestWall(mesh::SurfaceMesh surface, bool fluid_is_inside = false)
      : surface_(std::move(surface)),
        topology_(surface_),
        features_(surface::find_features(surface_, topology_)),
        is_wetted_(surface_.faces.size(), 1),
        fluid_is_inside_(fluid_is_inside) {}
  TestWall(const TestWall&) = delete;
  TestWall& operator=(const TestWall&) = delete;

  const mesh::SurfaceMesh& surface() const { return surface_; }
  const mesh::Topology& topology() const { return topology_; }
  IdVector<FaceId, char>& is_wetted() { return is_wetted_; }
  layers::Wall wall() const { return {surface_, topology_, features_, is_wetted_, fluid_is_inside_}; }

  certify::CertifiedWall certified_wall() const {
    auto component = mesh::connected_components(topology_);
    for (const FaceId f : component.ids()) {
      if (!is_wetted_[f]) component[f] = ComponentId();
    }
    return {surface_, std::move(component), fluid_is_inside_};
  }

 private:
  mesh::SurfaceMesh surface_;
  mesh::Topology topology_;
  surface::Features features_;
  IdVector<FaceId, char> is_wetted_;
  bool fluid_is_inside_;
};

/// The same stack on every patch.
inline layers::GrowOptions options_for(const mesh::SurfaceMesh& surface, std::vector<double> heights) {
  layers::GrowOptions options;
  layers::PatchSchedule schedule;
  schedule.heights = std::move(heights);
  options.schedules.assign(surface.patch_names.size(), schedule);
  return options;
}

/// n heights that grow by `growth` and sum to `thickness`.
inline std::vector<double> geometric(double thickness, double growth, int n) {
  std::vector<double> heights(static_cast<std::size_t>(n));
  double sum = 0, h = 1;
  for (double& height : heights) {
    height = h;
    sum += h;
    h *= growth;
  }
  for (double& height : heights) height *= thickness / sum;
  return heights;
}

}  // namespace nearwall::growing_for_tests

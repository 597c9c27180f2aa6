#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/certify/certificate.h"
#include "nearwall/layers/grow.h"
#include "nearwall/surface/features.h"
#include "tests/support/closed_surfaces.h"

/// Walls that end at planes.
namespace nearwall::open_walls_for_tests {

using namespace closed_surfaces_for_tests;

/// An open wall with all that growing needs, kept together so that references into it stay good.
class TestOpenWall {
 public:
  explicit TestOpenWall(surface::OpenWall open, bool fluid_is_inside = true)
      : open_(std::move(open)),
        topology_(open_.surface),
        features_(surface::find_features(open_.surface, topology_)),
        is_wetted_(open_.surface.faces.size(), 1),
        fluid_is_inside_(fluid_is_inside) {
    for (const VertexId v : features_.kind.ids()) {
      if (open_.planes.is_on_plane(v) && features_.kind[v] == surface::PointKind::RidgeEnd) {
        features_.kind[v] = surface::PointKind::Ridge;
      }
    }
  }
  TestOpenWall(const TestOpenWall&) = delete;
  TestOpenWall& operator=(const TestOpenWall&) = delete;

  const surface::OpenWall& open() const { return open_; }
  const mesh::SurfaceMesh& surface() const { return open_.surface; }
  const mesh::SidePlanes& planes() const { return open_.planes; }
  const mesh::Topology& topology() const { return topology_; }
  layers::Wall wall() const {
    return {open_.surface, topology_, features_, is_wetted_, fluid_is_inside_, &open_.planes};
  }
  certify::CertifiedWall certified_wall() const {
    return {open_.surface, layers::wetted_components(wall()), fluid_is_inside_, &open_.planes};
  }

  /// A stack of layers on the patches that are asked for; none on the others.
  layers::GrowOptions options(const std::vector<double>& heights, const std::set<std::string>& with_layers) const {
    layers::GrowOptions options;
    for (const std::string& name : open_.surface.patch_names) {
      layers::PatchSchedule schedule;
      schedule.has_layers = with_layers.contains(name);
      if (schedule.has_layers) schedule.heights = heights;
      options.schedules.push_back(schedule);
    }
    return options;
  }

 private:
  surface::OpenWall open_;
  mesh::Topology topology_;
  surface::Features features_;
  IdVector<FaceId, char> is_wetted_;
  bool fluid_is_inside_;
};

}  // namespace nearwall::open_walls_for_tests

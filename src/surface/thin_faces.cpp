#include "surface/thin_faces.h"

#include <algorithm>
#include <array>

#include "nearwall/geometry/angles.h"

namespace nearwall::surface {

namespace {

using mesh::Topology;

double widest_corner(const std::array<Vec3, 3>& t) {
  return std::max({geometry::corner_angle(t[0], t[1], t[2]), geometry::corner_angle(t[1], t[2], t[0]),
                   geometry::corner_angle(t[2], t[0], t[1])});
}

bool is_on_boundary(const Topology& topology, FaceId f) {
  for (int k = 0; k < 3; ++k) {
    if (!topology.twin(Topology::halfedge(f, k)).is_valid()) return true;
  }
  return false;
}

}  // namespace

std::vector<char> thin_boundary_faces(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                      double thin_angle) {
  if (topology.is_closed() || !(thin_angle < geometry::kPi)) return {};
  std::vector<FaceId> open;
  for (const FaceId f : surface.faces.ids()) {
    if (is_on_boundary(topology, f)) open.push_back(f);
  }
  std::vector<char> is_thin;
  while (!open.empty()) {
    const FaceId f = open.back();
    open.pop_back();
    if ((!is_thin.empty() && is_thin[f.index()]) || widest_corner(surface.triangle(f)) <= thin_angle) continue;
    is_thin.resize(surface.faces.size(), 0);
    is_thin[f.index()] = 1;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId twin = topology.twin(Topology::halfedge(f, k));
      if (twin.is_valid()) open.push_back(Topology::face(twin));
    }
  }
  return is_thin;
}

}  // namespace nearwall::surface

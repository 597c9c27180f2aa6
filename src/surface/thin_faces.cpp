#include "surface/thin_faces.h"

#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::surface {

namespace {

using mesh::Topology;

double widest_corner(const mesh::SurfaceMesh& surface, FaceId f) {
  const auto [a, b, c] = surface.triangle(f);
  return geometry::widest_corner(a, b, c);
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
    if ((!is_thin.empty() && is_thin[f.index()]) || widest_corner(surface, f) <= thin_angle) continue;
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

#include "stretch.h"

#include "nearwall/geometry/angles.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

}  // namespace

double stretch_of(const Wall& wall, VertexId v, const Vec3& direction) {
  double cosines = 0, angles = 0;
  for (const HalfedgeId h : wall.topology.fan(v)) {
    const FaceId f = Topology::face(h);
    const Vec3& apex = wall.surface.points[v];
    const double angle = geometry::corner_angle(apex, wall.surface.points[wall.topology.target(h)],
                                                wall.surface.points[wall.topology.origin(Topology::previous(h))]);
    cosines += angle * dot(direction, wall.features.face_normal[f]);
    angles += angle;
  }
  return cosines * kMaxStretch > angles ? angles / cosines : kMaxStretch;
}

}  // namespace nearwall::layers

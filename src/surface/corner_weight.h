#pragma once

#include <cmath>

#include "nearwall/core/vec3.h"
#include "nearwall/surface/normals.h"

namespace nearwall::surface {

/// The corner of a face at a vertex: what all weights are made of.
struct FaceCorner {
  double squared_b = 0;    ///< of the edge along which the corner begins
  double squared_c = 0;    ///< of the edge along which it ends, counterclockwise
  double squared_a = 0;    ///< of the opposite edge
  double sine = 0;         ///< b c sin(alpha): twice the area
  double cosine = 0;       ///< b c cos(alpha)
  double sine_from_z = 0;  ///< twice the area seen along the z axis

  double squared_bc() const { return squared_b * squared_c; }
  double angle() const { return std::atan2(sine, cosine); }
};

/// Corner between the edges `b` and `c`, with the opposite edge `a` and `area_vector` = b x c.
inline FaceCorner corner_between(const Vec3& b, const Vec3& c, const Vec3& a, const Vec3& area_vector) {
  return {squared_norm(b), squared_norm(c), squared_norm(a), norm(area_vector), dot(b, c), std::abs(area_vector.z())};
}

/// Weight of a face with an area. Constant factors are dropped where they are the same for all faces.
/// Source: Ubach et al. 2013, equations (9) to (21); Bohdal 2017, section 2.1. sin(alpha) = sine / (b c).
inline double corner_weight(Weight weight, const FaceCorner& corner) {
  switch (weight) {
    case Weight::Uniform:
      return 1.0;
    case Weight::Area:
      return corner.sine;
    case Weight::InverseArea:
      return 1.0 / corner.sine;
    case Weight::ProjectedArea:
      return corner.sine_from_z;
    case Weight::Angle:
      return corner.angle();
    case Weight::InverseRootEdges:
      return 1.0 / std::sqrt(std::sqrt(corner.squared_bc()));
    case Weight::InverseEdges:
      return 1.0 / std::sqrt(corner.squared_bc());
    case Weight::InverseSquaredEdges:
      return 1.0 / corner.squared_bc();
    case Weight::Max:
      return corner.sine / corner.squared_bc();
    case Weight::LittleMax: {
      const double edges = std::sqrt(corner.squared_bc());
      return (1.0 + corner.sine / edges) / edges;
    }
    case Weight::InverseDiameter:
      return corner.sine / std::sqrt(corner.squared_bc() * corner.squared_a);
    case Weight::AngleOverDiameter:
      return corner.angle() * corner.sine / std::sqrt(corner.squared_bc() * corner.squared_a);
    case Weight::InverseCircumArea:
      return corner.sine * corner.sine / (corner.squared_bc() * corner.squared_a);
    case Weight::AngleOverCircumArea:
      return corner.angle() * corner.sine * corner.sine / (corner.squared_bc() * corner.squared_a);
  }
  return 0.0;
}

}  // namespace nearwall::surface

#pragma once

#include <cmath>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/arctangent.h"
#include "nearwall/surface/normals.h"

namespace nearwall::surface {

/// The corner of a face at a vertex: what all weights are made of. Nothing is computed that is not asked for.
class FaceCorner {
 public:
  /// \param b, c  the edges at the vertex, counterclockwise    \param a  the opposite edge
  /// \param area_vector  b x c, not zero
  FaceCorner(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& area_vector)
      : a_(a), b_(b), c_(c), area_vector_(area_vector) {}

  double sine() const { return norm(area_vector_); }                                       ///< b c sin(alpha)
  double sine_from_z() const { return std::abs(area_vector_.z()); }                        ///< the same, seen along z
  double angle() const { return geometry::angle_from(sine(), dot(b_, c_)); }               ///< alpha
  double squared_bc() const { return squared_norm(b_) * squared_norm(c_); }                ///< (b c)^2
  double squared_abc() const { return squared_norm(a_) * squared_bc(); }                   ///< (a b c)^2
  double squared_curvature() const { return squared_norm(area_vector_) / squared_abc(); }  ///< (sin(alpha) / a)^2

 private:
  Vec3 a_, b_, c_, area_vector_;
};

/// Weight of a face with an area. Constant factors are dropped where they are the same for all faces.
/// Source: Ubach et al. 2013, equations (9) to (21); Bohdal 2017, section 2.1.
inline double corner_weight(Weight weight, const FaceCorner& corner) {
  switch (weight) {
    case Weight::Uniform:
      return 1.0;
    case Weight::Area:
      return corner.sine();
    case Weight::InverseArea:
      return 1.0 / corner.sine();
    case Weight::ProjectedArea:
      return corner.sine_from_z();
    case Weight::Angle:
      return corner.angle();
    case Weight::InverseRootEdges:
      return 1.0 / std::sqrt(std::sqrt(corner.squared_bc()));
    case Weight::InverseEdges:
      return 1.0 / std::sqrt(corner.squared_bc());
    case Weight::InverseSquaredEdges:
      return 1.0 / corner.squared_bc();
    case Weight::Max:
      return corner.sine() / corner.squared_bc();
    case Weight::LittleMax: {
      const double edges = std::sqrt(corner.squared_bc());
      return (1.0 + corner.sine() / edges) / edges;
    }
    case Weight::InverseDiameter:
      return std::sqrt(corner.squared_curvature());
    case Weight::AngleOverDiameter:
      return corner.angle() * std::sqrt(corner.squared_curvature());
    case Weight::InverseCircumArea:
      return corner.squared_curvature();
    case Weight::AngleOverCircumArea:
      return corner.angle() * corner.squared_curvature();
  }
  return 0.0;
}

}  // namespace nearwall::surface

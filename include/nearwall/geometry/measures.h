#pragma once

#include <array>
#include <span>

#include "nearwall/core/vec3.h"

namespace nearwall::geometry {

/// Area vector of a triangle: half the cross product, along its normal by the right-hand rule.
inline Vec3 triangle_area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a) * 0.5; }

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c);

/// Unit normal; zero for a triangle without area.
Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c);

/// Largest interior angle of a triangle [rad], in [0, pi].
double widest_corner(const Vec3& a, const Vec3& b, const Vec3& c);

/// Volumes of the elements' maps (tetrahedra linear, wedge faces and pyramid bases bilinear, hexahedra trilinear),
/// that is the integral of det J over the reference element. Positive for the node order of predicates/cells.h: bottom
/// face counterclockwise seen from the top (or apex), then the top. Source: docs/theory/cells.md.
double tetrahedron_volume(std::span<const Vec3, 4> p);
double pyramid_volume(std::span<const Vec3, 5> p);
double wedge_volume(std::span<const Vec3, 6> p);
double hexahedron_volume(std::span<const Vec3, 8> p);

/// Sum that loses no digits to cancellation between terms of different size (Neumaier 1974).
class CompensatedSum {
 public:
  void add(double v);
  double value() const { return sum_ + compensation_; }

 private:
  double sum_ = 0;
  double compensation_ = 0;
};

}  // namespace nearwall::geometry

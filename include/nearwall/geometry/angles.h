#pragma once

#include <numbers>

#include "nearwall/core/vec3.h"

namespace nearwall::geometry {

inline constexpr double kPi = std::numbers::pi;

constexpr double to_degrees(double radians) { return radians * (180.0 / kPi); }
constexpr double to_radians(double degrees) { return degrees * (kPi / 180.0); }

/// Angle between two vectors, in [0, pi]; 0 if one is zero. Accurate at 0 and pi, too, where arccos is not.
/// Lengths between 1e-70 and 1e70, whose fourth powers are in the range of doubles.
double angle_between(const Vec3& a, const Vec3& b);

/// Interior angle at `apex` of the triangle (apex, b, c), in [0, pi].
double corner_angle(const Vec3& apex, const Vec3& b, const Vec3& c);

/// Turn of an edge: signed angle between the unit normals of its two faces, in (-pi, pi].
/// \param left, right  unit normals of the faces on the left and on the right of the edge
/// \param along        direction of the edge, any length; the left face lies to its left seen from outside
/// \returns            0 flat, > 0 convex, < 0 concave (method: turn of an edge)
double edge_turn(const Vec3& left, const Vec3& right, const Vec3& along);

/// Unit vector at the fraction t of the great arc from a to b (unit vectors, not opposite): t = 0 gives a, 1 gives b.
Vec3 slerp(const Vec3& a, const Vec3& b, double t);

}  // namespace nearwall::geometry

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shapes/surface_builder.h"

namespace nearwall::shapes {

/// n vertices on the circle round `centre` through centre + a and centre + b (at a right angle, of equal length), from
/// a towards b; turned by `phase` of a point's distance.
Row add_circle(SurfaceBuilder& builder, const Vec3& centre, const Vec3& a, const Vec3& b, int n, double phase);

/// Parameters of points at equal lengths along the closed curve that `at` draws over [0, 1), for edges of about `size`,
/// at least kMinCircle; the first lies `phase` of an edge from the curve's beginning.
std::vector<double> closed_curve_parameters(const std::function<Vec3(double)>& at, double size, double phase);

/// Points on a circle of this radius for edges of about `size`, at least kMinCircle.
int n_on_circle(double radius, double size);

/// Fewest points on a circle, and round a tip.
inline constexpr int kMinCircle = 6;
/// Fewest edges with which a whole shape's largest circle is drawn.
inline constexpr int kMinRound = 12;

/// A point of a profile: `x` along the axis of revolution, `r` from it.
struct ProfilePoint {
  double x = 0;
  double r = 0;
};

/// A piece of a profile, bounded by ridges or patch edges. Consecutive pieces share an end point.
struct ProfilePiece {
  std::string patch;
  std::vector<ProfilePoint> points;
};

/// Distance between rows of a triangulation by nearly equilateral triangles of this edge length.
double row_distance(double size);

/// Straight piece of a profile, cut into rows for edges of about `size`.
ProfilePiece straight_piece(std::string patch, const ProfilePoint& from, const ProfilePoint& to, double size);
/// Piece of an ellipse round (x, 0) with half-axes a along the axis and b across, from the angle `begin` to `end`
/// [rad, 0 along the axis, pi/2 across], cut into equal lengths.
ProfilePiece elliptic_piece(std::string patch, double x, double a, double b, double begin, double end, double size);

/// A part of a turn about the x axis, from y towards z, in half turns. It begins and ends in coordinate planes.
struct Sector {
  double begin = 0;
  double span = 0;
};
inline constexpr Sector kRightHalf{-0.5, 1};  ///< y >= 0, from -z to z
inline constexpr Sector kQuarter{0, 0.5};     ///< y, z >= 0

/// A row round a sector of a circle about the x axis; its ends are in the sector's planes exactly. If `is_turned` the
/// points between are turned by half an edge.
Row add_arc(SurfaceBuilder& builder, const ProfilePoint& p, const Sector& sector, double size, bool is_turned);

/// `revolve` over kRightHalf or kQuarter only, closed by flat faces: a half has one in y = 0, a quarter one in z = 0
/// and one in y = 0. The profile begins and ends on the axis. \param caps  their patches in this order
void revolve_sector(SurfaceBuilder& builder, const std::vector<ProfilePiece>& profile, const Sector& sector,
                    const std::vector<std::string>& caps, double size);

/// Turns a profile about the x axis. It runs so that the outside is on its left in the (x, r) plane: for a closed body
/// from its low end on the axis to its high end on it. If `is_cyclic` the last piece ends where the first begins.
void revolve(SurfaceBuilder& builder, const std::vector<ProfilePiece>& profile, double size, bool is_cyclic = false);

}  // namespace nearwall::shapes

#pragma once

#include <vector>

#include "shapes/surface_builder.h"

namespace nearwall::shapes {

/// How an Ahmed body is built.
struct AhmedBody {
  double slant = 0;         ///< angle of the rear slant to the roof [rad]
  bool has_stilts = false;  ///< four, or two under a half
  bool has_feet = true;     ///< stilts are closed at the ground, z = 0
  bool is_half = false;     ///< y >= 0 only, open in y = 0
};

/// Where an Ahmed body is open.
struct AhmedOpenings {
  Row cut;                  ///< its outline in y = 0, counterclockwise seen along +y; of a half only
  std::vector<Row> stilts;  ///< the lower ends of stilts without feet, counterclockwise seen from above
};

/// Largest edge length of an Ahmed body for the size asked, 0 for its default [m].
double ahmed_size(double size);

/// Adds the body with its patches, normals outward.
AhmedOpenings add_ahmed_body(SurfaceBuilder& builder, const AhmedBody& body, double size);

/// Dimensions of the body that its surroundings depend on [m].
inline constexpr double kAhmedLength = 1.044;
inline constexpr double kAhmedWidth = 0.389;
inline constexpr double kAhmedHeight = 0.288;
inline constexpr double kAhmedClearance = 0.050;

}  // namespace nearwall::shapes

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shapes/surface_builder.h"
#include "shapes/wing_section.h"

namespace nearwall::shapes {

/// The right half (y >= 0) of a wing with straight edges, x along the chord, z up.
struct HalfWing {
  WingSection section;
  std::vector<double> t;  ///< parameters of the points along both sides of the section
  Vec3 root;              ///< leading edge in the plane y = 0
  double half_span = 0;   ///< of the flat tip; a rounded one adds half the thickness there
  double root_chord = 0;
  double tip_chord = 0;
  double sweep = 0;  ///< of the leading edge [rad]
  bool has_rounded_tip = false;
  std::string prefix;  ///< of the patch names upper, lower, tip, trailing-edge
  /// How far out the wing begins on the line from a root point to its tip point, 0 to 1; none: at the root.
  std::function<double(const Vec3& root, const Vec3& tip)> start;
};

/// A section of the wing's surface as rows: both sides from the leading to the trailing edge, and the base from the
/// upper to the lower side's end (one vertex if the trailing edge is sharp).
struct SectionRows {
  Row upper, lower, base;

  /// All round: upper side back, base, lower side forward. Clockwise seen along +y.
  Row loop() const { return loop_of({upper, base, reversed(lower)}); }
};

/// The edge length for a wing: the size asked for, but no more than a fraction of the shorter chord.
double wing_size(double size, double root_chord, double tip_chord);

/// Adds all of the half wing but for its open root. Its sides have one structured row of quadrangles, cut along their
/// shorter diagonals, for each stretch of about `size` along the span; the tip is a plane, or half a body of revolution
/// of the tip section about its chord.
/// \returns the section at the root
SectionRows add_half_wing(SurfaceBuilder& builder, const HalfWing& wing, double size);

}  // namespace nearwall::shapes

#pragma once

#include <functional>
#include <vector>

namespace nearwall::shapes {

/// A point in the plane of a wing section of unit chord.
struct SectionPoint {
  double x = 0;
  double z = 0;
};

/// Outline of a wing section of unit chord, leading edge at the origin, trailing edge round (1, 0). Both sides are
/// smooth curves over t in [0, 1] from the leading edge to the trailing edge, and x is about t².
struct WingSection {
  std::function<SectionPoint(double)> upper;
  std::function<SectionPoint(double)> lower;
  bool is_blunt = false;  ///< false: both sides end in the same point
};

/// NACA four-digit section. Source: Jacobs, Ward & Pinkerton, NACA Report 460 (1933); blunt as defined there, or with
/// the last coefficient of the thickness changed from -0.1015 to -0.1036 for a sharp trailing edge. \param digits  0 …
/// 9999: largest camber [%], its place [tenths], two of thickness [%]
WingSection naca_section(int digits, bool is_blunt);

/// The symmetric section "ONERA D" of the ONERA M6 wing: a cubic spline through the published ordinates. Source:
/// Schmitt & Charpin, AGARD AR-138 (1979), B1. The published section ends in a base of 0.14 % of the chord; the sharp
/// one takes that off gradually behind the greatest thickness, z - z_TE ((x - x_m) / (1 - x_m))².
WingSection onera_d_section(bool is_blunt);

/// Parameters 0 = t[0] < … < t[n] = 1 at which both sides of a section of unit chord are cut into edges: no longer than
/// `size`, shorter round the leading edge.
std::vector<double> section_parameters(const WingSection& section, double size);

}  // namespace nearwall::shapes

#include <cmath>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/wing.h"

namespace nearwall::shapes {
namespace {

/// Planform of the ONERA M6 wing. Source: Schmitt & Charpin, AGARD AR-138 (1979), B1. The trailing edge's sweep
/// of 15.8° follows from these.
constexpr double kM6HalfSpan = 1.1963;   // [m]
constexpr double kM6RootChord = 0.8059;  // [m]
constexpr double kM6Taper = 0.562;
constexpr double kM6SweepDeg = 30;
constexpr double kM6Size = 0.0145;  // [m], gives about 40,000 triangles

/// Default edge length of a wing, over its chord at the root.
constexpr double kDefaultSize = 0.03;

/// A wing from tip to tip, or its right half with a flat root.
mesh::SurfaceMesh make_wing(HalfWing wing, bool is_half, double size) {
  SurfaceBuilder builder;
  size = wing_size(size, wing.root_chord, wing.tip_chord);
  wing.t = section_parameters(wing.section, 2 * size / (wing.root_chord + wing.tip_chord));
  const SectionRows root = add_half_wing(builder, wing, size);
  if (is_half) {
    builder.fill(builder.patch("root"), {reversed(root.loop())}, plane_chart({0, 0, 0}, {0, -1, 0}), size);
  } else {
    builder.mirror(1);
  }
  return builder.finish();
}

mesh::SurfaceMesh make_naca(const Values& v, double size) {
  const double chord = v["chord"];
  HalfWing wing{.section = naca_section(v.integer("digits"), v.is_on("blunt")),
                .t = {},
                .root = {},
                .half_span = v["span"] / 2,
                .root_chord = chord,
                .tip_chord = chord * v["taper"],
                .sweep = geometry::to_radians(v["sweep"]),
                .has_rounded_tip = v.is_on("rounded-tip"),
                .prefix = "",
                .start = {}};
  return make_wing(std::move(wing), v.is_on("half"), size == 0 ? kDefaultSize * chord : size);
}

mesh::SurfaceMesh make_onera_m6(const Values& v, double size) {
  HalfWing wing{.section = onera_d_section(v.is_on("blunt")),
                .t = {},
                .root = {},
                .half_span = kM6HalfSpan,
                .root_chord = kM6RootChord,
                .tip_chord = kM6RootChord * kM6Taper,
                .sweep = geometry::to_radians(kM6SweepDeg),
                .has_rounded_tip = v.is_on("rounded-tip"),
                .prefix = "",
                .start = {}};
  return make_wing(std::move(wing), v.is_on("half"), size == 0 ? kM6Size : size);
}

ShapeParameter blunt() { return option("blunt", false, "1: the section's own blunt trailing edge; 0: a sharp one"); }
ShapeParameter rounded_tip() {
  return option("rounded-tip", true, "1: tips are half bodies of revolution; 0: flat tips");
}
ShapeParameter half() { return option("half", false, "1: the right half only, closed by a flat patch root"); }

}  // namespace

std::vector<Definition> wing_shapes() {
  return {
      {{"naca",
        "wing with a NACA four-digit section, closed at both tips; patches upper, lower, tip, trailing-edge, root",
        {integer("digits", 12, 1, 9999, "the section's digits, 12 for NACA 0012"),
         length("chord", 1, "chord at the root"), length("span", 4, "from tip to tip, without their rounding"),
         number("taper", 1, 0.1, 2, "chord at the tip over chord at the root"),
         angle("sweep", 0, -60, 70, "sweep of the leading edge"), blunt(), rounded_tip(), half()}},
       make_naca},
      {{"onera-m6",
        "ONERA M6 wing in metres, closed at both tips; patches upper, lower, tip, trailing-edge, root",
        {blunt(), rounded_tip(), half()}},
       make_onera_m6},
  };
}

}  // namespace nearwall::shapes

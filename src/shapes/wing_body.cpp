#include <cmath>
#include <string_view>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/revolution.h"
#include "shapes/sampling.h"
#include "shapes/wing.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;

/// The fuselage is a cylinder with elliptic ends of these lengths, over its radius.
constexpr double kNoseLength = 3;
constexpr double kTailLength = 5;

/// Default edge length, over the chord at the plane of symmetry.
constexpr double kDefaultSize = 0.035;

/// The wing's root keeps this distance from the fuselage's keel and top, over the radius.
constexpr double kClearOfSymmetry = 0.1;

constexpr std::string_view kOnTheCylinder =
    "the wing's root must lie on the sides of the fuselage's cylinder, from 3 radii behind its nose to 5 radii before "
    "its "
    "tail: change wing-position, wing-height, chord, fuselage-length or fuselage-radius";

/// The fuselage's outline in the plane of symmetry, in the direction of x.
struct Outline {
  Row keel, top;

  void add(const Row& half_circle) {
    keel.push_back(half_circle.front());
    top.push_back(half_circle.back());
  }
};

/// Stitches half circles along a profile in the direction of x; its first or last row is the one given.
/// \returns the outline of this end
Outline add_half_end(SurfaceBuilder& builder, PatchId patch, const std::vector<ProfilePoint>& profile, const Row& joint,
                     bool joint_is_last, double size) {
  const std::size_t n = profile.size();
  Outline outline;
  Row previous;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from_joint = joint_is_last ? n - 1 - i : i;
    const Row next = from_joint == 0 ? joint : add_arc(builder, profile[i], kRightHalf, size, from_joint % 2 == 1);
    if (i > 0) builder.stitch(patch, previous, next);
    outline.add(next);
    previous = next;
  }
  return outline;
}

/// Fraction of the way from root to tip at which a line leaves the cylinder of radius r about the x axis.
double leaves_cylinder(const Vec3& root, const Vec3& tip, double r) {
  const double dy = tip.y() - root.y(), dz = tip.z() - root.z();
  const double a = dy * dy + dz * dz, b = root.y() * dy + root.z() * dz;
  const double c = root.y() * root.y() + root.z() * root.z() - r * r;
  require(c < 0, kOnTheCylinder);
  return (std::sqrt(b * b - a * c) - b) / a;
}

HalfWing wing_of(const Values& v, double size) {
  const double r = v["fuselage-radius"], chord = v["chord"];
  const double z = v["wing-height"] * r;
  HalfWing wing{.section = naca_section(v.integer("digits"), v.is_on("blunt")),
                .t = {},
                .root = Vec3(v["wing-position"], 0, z),
                .half_span = v["span"] / 2,
                .root_chord = chord,
                .tip_chord = chord * v["taper"],
                .sweep = geometry::to_radians(v["sweep"]),
                .has_rounded_tip = v.is_on("rounded-tip"),
                .prefix = "wing-",
                .start = [r](const Vec3& root, const Vec3& tip) { return leaves_cylinder(root, tip, r); }};
  const double h = wing_size(size, wing.root_chord, wing.tip_chord);
  wing.t = section_parameters(wing.section, 2 * h / (wing.root_chord + wing.tip_chord));
  return wing;
}

mesh::SurfaceMesh make_wing_body(const Values& v, double size) {
  const double r = v["fuselage-radius"],
               h = std::min(size == 0 ? kDefaultSize * v["chord"] : size, 2 * kPi * r / kMinRound);
  const double begin = kNoseLength * r, end = v["fuselage-length"] - kTailLength * r;
  require(v["span"] / 2 > 1.5 * r,
          "the wing must reach out of the fuselage: give a larger span or smaller fuselage-radius");
  require(begin < end, kOnTheCylinder);

  SurfaceBuilder builder;
  const PatchId fuselage = builder.patch("fuselage");
  const HalfWing wing = wing_of(v, h);
  const SectionRows root = add_half_wing(builder, wing, wing_size(h, wing.root_chord, wing.tip_chord));
  for (const VertexId vertex : root.loop()) {
    const Vec3& p = builder.point(vertex);
    require(p.x() > begin + h && p.x() < end - h && std::abs(p.z()) < (1 - kClearOfSymmetry) * r, kOnTheCylinder);
  }
  const Row front = add_arc(builder, {begin, r}, kRightHalf, h, false),
            rear = add_arc(builder, {end, r}, kRightHalf, h, false);
  const Outline nose =
      add_half_end(builder, fuselage, elliptic_piece("", begin, begin, r, kPi, kPi / 2, h).points, front, true, h);
  const Outline tail = add_half_end(builder, fuselage,
                                    elliptic_piece("", end, kTailLength * r, r, kPi / 2, 0, h).points, rear, false, h);

  // The cylinder between, unrolled, with a hole where the wing is.
  const Chart unrolled{[r](const Vec3& p) {
                         return Point2{p.x(), r * std::atan2(p.z(), p.y())};
                       },
                       [r](const Point2& q) { return Vec3(q.u, r * std::cos(q.v / r), r * std::sin(q.v / r)); }};
  const Row top = builder.edge(front.back(), rear.back(), h), keel = builder.edge(front.front(), rear.front(), h);
  builder.fill(fuselage, {loop_of({front, top, reversed(rear), reversed(keel)}), root.loop()}, unrolled, h);
  if (v.is_on("half")) {
    builder.fill(builder.patch("symmetry"),
                 {loop_of({nose.keel, keel, tail.keel, reversed(tail.top), reversed(top), reversed(nose.top)})},
                 plane_chart({0, 0, 0}, {0, -1, 0}), h);
  } else {
    builder.mirror(1);
  }
  return builder.finish();
}

}  // namespace

std::vector<Definition> aircraft_shapes() {
  return {{{"wing-body",
            "wing on a fuselage of revolution, joined along their line of intersection; patches fuselage, wing-upper, "
            "wing-lower, wing-tip, wing-trailing-edge, symmetry",
            {length("fuselage-length", 8, "whole length of the fuselage, along x"),
             length("fuselage-radius", 0.5, "radius of the fuselage's cylinder"),
             integer("digits", 12, 1, 9999, "the wing section's four NACA digits, 12 for NACA 0012"),
             length("chord", 1.4, "chord in the plane of symmetry"), length("span", 7, "from tip to tip"),
             number("taper", 0.4, 0.1, 2, "chord at the tip over chord in the plane of symmetry"),
             angle("sweep", 25, -40, 60, "sweep of the leading edge"),
             length("wing-position", 2.6, "leading edge in the plane of symmetry, behind the nose"),
             number("wing-height", -0.3, -0.6, 0.6, "of the wing over the fuselage's axis, over the radius"),
             option("blunt", false, "1: the section's own blunt trailing edge; 0: a sharp one"),
             option("rounded-tip", true, "1: tips are half bodies of revolution; 0: flat tips"),
             option("half", false, "1: the right half only, closed by a flat patch symmetry in y = 0")}},
           make_wing_body}};
}

}  // namespace nearwall::shapes

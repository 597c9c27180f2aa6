#include <algorithm>
#include <cmath>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/geodesic.h"
#include "shapes/revolution.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;

/// Default edge length of round shapes, over the radius, and the largest one: below, circles are hardly round.
constexpr double kDefaultSize = 0.1;

double round_size(double size, double radius) {
  const double largest = 2 * kPi * radius / kMinRound;
  return size == 0 ? kDefaultSize * radius : std::min(size, largest);
}

mesh::SurfaceMesh make_sphere(const Values& v, double size) {
  const double r = v["radius"];
  const int subdivisions = v.integer("subdivisions");
  const int frequency = subdivisions > 0 ? 1 << subdivisions : geodesic_frequency(r, round_size(size, r));
  SurfaceBuilder builder;
  add_sphere(builder, "sphere", {0, 0, 0}, r, frequency);
  return builder.finish();
}

/// Rows at equal lengths along the largest meridian and points at equal lengths along the rows. They are joined as on
/// the unit sphere and stretched then: what does not meet itself there does not do so here, however flat the ellipsoid.
mesh::SurfaceMesh make_ellipsoid(const Values& v, double size) {
  const double a = v["length"] / 2, b = v["width"] / 2, c = v["height"] / 2, wide = std::max(b, c);
  const double h = round_size(size, std::min({a, b, c}));
  SurfaceBuilder builder;
  const PatchId patch = builder.patch("ellipsoid");
  Row previous;
  int k = 0;
  for (const ProfilePoint& p : elliptic_piece("", 0, a, wide, kPi, 0, h).points) {
    const double x = p.x / a, r = p.r / wide;
    Row row;
    if (r == 0) {
      row = {builder.add_point({x, 0, 0})};
    } else {
      const auto ellipse = [&](double t) {
        return Vec3(0, r * b * std::cos(2 * kPi * t), r * c * std::sin(2 * kPi * t));
      };
      for (const double t : closed_curve_parameters(ellipse, h, k++ % 2 == 0 ? 0 : 0.5)) {
        row.push_back(builder.add_point({x, r * std::cos(2 * kPi * t), r * std::sin(2 * kPi * t)}));
      }
    }
    if (!previous.empty()) builder.stitch_rings(patch, previous, row);
    previous = row;
  }
  builder.stretch({a, b, c});
  return builder.finish();
}

mesh::SurfaceMesh make_torus(const Values& v, double size) {
  const double big = v["radius"], small = v["tube-radius"];
  require(small < big, "tube-radius of a torus must be smaller than its radius");
  const double h = round_size(size, small);
  // An even number of rings, so that the turned ones alternate all the way round.
  const int n = 2 * n_segments(kPi * small, row_distance(h), kMinRound / 2);
  ProfilePiece tube{"torus", {}};
  for (int i = 0; i <= n; ++i) {
    const double angle = -2 * kPi * i / n;
    tube.points.push_back({small * std::cos(angle), big + small * std::sin(angle)});
  }
  SurfaceBuilder builder;
  revolve(builder, {tube}, h, true);
  return builder.finish();
}

mesh::SurfaceMesh make_cylinder(const Values& v, double size) {
  const double r = v["radius"], x = v["length"] / 2, h = round_size(size, r);
  SurfaceBuilder builder;
  revolve(builder,
          {straight_piece("front", {-x, 0}, {-x, r}, h), straight_piece("side", {-x, r}, {x, r}, h),
           straight_piece("base", {x, r}, {x, 0}, h)},
          h);
  return builder.finish();
}

mesh::SurfaceMesh make_quarter_cylinder(const Values& v, double size) {
  const double r = v["radius"], x = v["length"] / 2, h = round_size(size, r);
  SurfaceBuilder builder;
  revolve_sector(builder,
                 {straight_piece("front", {-x, 0}, {-x, r}, h), straight_piece("side", {-x, r}, {x, r}, h),
                  straight_piece("base", {x, r}, {x, 0}, h)},
                 kQuarter, {"symmetry-z", "symmetry-y"}, h);
  return builder.finish();
}

mesh::SurfaceMesh make_cone(const Values& v, double size) {
  const double x = v["length"], r = x * std::tan(geometry::to_radians(v["half-angle"])), h = round_size(size, r);
  SurfaceBuilder builder;
  revolve(builder, {straight_piece("cone", {0, 0}, {x, r}, h), straight_piece("base", {x, r}, {x, 0}, h)}, h);
  return builder.finish();
}

mesh::SurfaceMesh make_capsule(const Values& v, double size) {
  const double r = v["radius"], x = v["length"] / 2 - r, h = round_size(size, r);
  require(x > 0, "length of a capsule must be larger than twice its radius");
  SurfaceBuilder builder;
  revolve(builder,
          {elliptic_piece("nose", -x, r, r, kPi, kPi / 2, h), straight_piece("body", {-x, r}, {x, r}, h),
           elliptic_piece("tail", x, r, r, kPi / 2, 0, h)},
          h);
  return builder.finish();
}

}  // namespace

std::vector<Definition> round_shapes() {
  return {
      {{"sphere",
        "sphere as a geodesic triangulation; patch sphere",
        {length("radius", 1, "radius"),
         integer("subdivisions", 0, 0, 10, "n > 0: exactly 20 * 4^n triangles, whatever the size")}},
       make_sphere},
      {{"ellipsoid",
        "ellipsoid with its length along x; patch ellipsoid",
        {length("length", 4, "whole length, along x"), length("width", 1.5, "whole width, along y"),
         length("height", 1, "whole height, along z")}},
       make_ellipsoid},
      {{"torus",
        "torus about the x axis; patch torus",
        {length("radius", 1, "radius of the circle in the middle of the tube"),
         length("tube-radius", 0.3, "radius of the tube")}},
       make_torus},
      {{"cylinder",
        "cylinder along x; patches front, side, base",
        {length("radius", 0.5, "radius"), length("length", 2, "length")}},
       make_cylinder},
      {{"quarter-cylinder",
        "the quarter y, z >= 0 of a cylinder along x, closed; patches front, side, base, symmetry-y (in y = 0), "
        "symmetry-z (in z = 0)",
        {length("radius", 0.5, "radius"), length("length", 2, "length")}},
       make_quarter_cylinder},
      {{"cone",
        "cone along x with a sharp apex at the origin; patches cone, base",
        {length("length", 1, "distance of the apex from the base"),
         angle("half-angle", 20, 1, 80, "angle between axis and surface")}},
       make_cone},
      {{"capsule",
        "cylinder along x with hemispherical ends; patches nose, body, tail",
        {length("radius", 0.5, "radius"), length("length", 3, "whole length")}},
       make_capsule},
  };
}

}  // namespace nearwall::shapes

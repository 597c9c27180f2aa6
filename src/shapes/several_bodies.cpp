#include <algorithm>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/geodesic.h"
#include "shapes/prism.h"
#include "shapes/revolution.h"

namespace nearwall::shapes {
namespace {

constexpr double kDefaultSize = 0.1;

/// Longest edge on a sphere: its great circles keep kMinRound edges.
double largest_edge(double radius) { return 2 * geometry::kPi * radius / kMinRound; }

int sphere_frequency(double radius, double size) {
  return geodesic_frequency(radius, std::min(size, largest_edge(radius)));
}

/// The half y >= 0 of a sphere about the x axis, with a flat patch symmetry.
void add_half_sphere(SurfaceBuilder& builder, const char* patch, double x, double radius, double size) {
  const double h = std::min(size, largest_edge(radius));
  revolve_sector(builder, {elliptic_piece(patch, x, radius, radius, geometry::kPi, 0, h)}, kRightHalf, {"symmetry"}, h);
}

mesh::SurfaceMesh make_two_boxes(const Values& v, double size) {
  const double edge = v["edge"], gap = v["gap"] / 2, h = size == 0 ? kDefaultSize * edge : size;
  SurfaceBuilder builder;
  add_box(builder, {-gap - edge, -edge / 2, -edge / 2}, {-gap, edge / 2, edge / 2}, "first-", h);
  add_box(builder, {gap, -edge / 2, -edge / 2}, {gap + edge, edge / 2, edge / 2}, "second-", h);
  return builder.finish();
}

mesh::SurfaceMesh make_two_spheres(const Values& v, double size) {
  const double r1 = v["radius"], r2 = v["second-radius"], gap = v["gap"];
  const double h = size == 0 ? kDefaultSize * std::max(r1, r2) : size;
  SurfaceBuilder builder;
  if (v.is_on("half")) {
    add_half_sphere(builder, "first", 0, r1, h);
    add_half_sphere(builder, "second", r1 + gap + r2, r2, h);
  } else {
    add_sphere(builder, "first", {0, 0, 0}, r1, sphere_frequency(r1, h));
    add_sphere(builder, "second", {r1 + gap + r2, 0, 0}, r2, sphere_frequency(r2, h));
  }
  return builder.finish();
}

mesh::SurfaceMesh make_sphere_in_box(const Values& v, double size) {
  const double r = v["radius"], half = v["edge"] / 2;
  // The chords of the box keep off the sphere wherever it is; layers need some room, too.
  require(r <= 0.9 * half, "radius must be at most 0.9 times half the edge of the box");
  const double h = std::min(size == 0 ? kDefaultSize * r : size, largest_edge(r));
  SurfaceBuilder builder;
  add_sphere(builder, "sphere", {0, 0, 0}, r, geodesic_frequency(r, h), true);
  add_box(builder, {-half, -half, -half}, {half, half, half}, "", std::min(v["coarsening"] * h, half));
  return builder.finish();
}

mesh::SurfaceMesh make_concentric_spheres(const Values& v, double size) {
  const double outer = v["radius"], inner = v["inner-radius"], h = size == 0 ? kDefaultSize * outer : size;
  // The chords of the outer sphere must clear the inner one.
  require(inner <= 0.9 * outer, "inner-radius must be at most 0.9 times the radius");
  SurfaceBuilder builder;
  add_sphere(builder, "outer", {0, 0, 0}, outer, sphere_frequency(outer, h));
  add_sphere(builder, "inner", {0, 0, 0}, inner, sphere_frequency(inner, h), true);
  return builder.finish();
}

}  // namespace

std::vector<Definition> several_bodies() {
  return {
      {{"two-boxes",
        "two equal cubes side by side along x; patches first-x-min … second-z-max",
        {length("edge", 1, "edge of the cubes"), length("gap", 0.1, "distance between them")}},
       make_two_boxes},
      {{"two-spheres",
        "two spheres side by side along x, one of them small if so asked; patches first, second, symmetry",
        {length("radius", 1, "radius of the first"), length("second-radius", 0.2, "radius of the second"),
         length("gap", 0.1, "distance between them"),
         option("half", false, "1: the right halves only, closed by flat patches symmetry in y = 0")}},
       make_two_spheres},
      {{"concentric-spheres",
        "the space between two spheres (fluid = \"inside\"), or a hollow ball; patches outer, inner",
        {length("radius", 1, "radius of the outer sphere"), length("inner-radius", 0.5, "radius of the inner sphere")}},
       make_concentric_spheres},
      {{"sphere-in-box",
        "the space between a sphere and a cube round it (fluid = \"inside\"); patches sphere, x-min, x-max, y-min, "
        "y-max, "
        "z-min, z-max",
        {length("radius", 0.5, "radius of the sphere"), length("edge", 4, "edge of the cube"),
         number("coarsening", 4, 1, 100, "edge length of the cube's triangles over that of the sphere's")}},
       make_sphere_in_box},
  };
}

}  // namespace nearwall::shapes

#include <algorithm>

#include "nearwall/geometry/angles.h"
#include "shapes/definition.h"
#include "shapes/geodesic.h"
#include "shapes/prism.h"
#include "shapes/revolution.h"

namespace nearwall::shapes {
namespace {

constexpr double kDefaultSize = 0.1;

int sphere_frequency(double radius, double size) {
  return geodesic_frequency(radius, std::min(size, 2 * geometry::kPi * radius / kMinRound));
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
  add_sphere(builder, "first", {0, 0, 0}, r1, sphere_frequency(r1, h));
  add_sphere(builder, "second", {r1 + gap + r2, 0, 0}, r2, sphere_frequency(r2, h));
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
        "two spheres side by side along x, one of them small if so asked; patches first, second",
        {length("radius", 1, "radius of the first"), length("second-radius", 0.2, "radius of the second"),
         length("gap", 0.1, "distance between them")}},
       make_two_spheres},
      {{"concentric-spheres",
        "the space between two spheres (fluid = \"inside\"), or a hollow ball; patches outer, inner",
        {length("radius", 1, "radius of the outer sphere"), length("inner-radius", 0.5, "radius of the inner sphere")}},
       make_concentric_spheres},
  };
}

}  // namespace nearwall::shapes

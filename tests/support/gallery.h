#pragma once

#include <functional>
#include <string>
#include <vector>

#include "nearwall/geometry/box.h"
#include "nearwall/shapes/shapes.h"
#include "tests/support/growing.h"
#include "tests/support/shapes.h"

/// Shapes × schedules on which the properties of layers are tried.
namespace nearwall::gallery {

struct Shape {
  std::string name;
  std::function<mesh::SurfaceMesh()> make;
  bool fluid_is_inside = false;
};

inline mesh::SurfaceMesh catalogued(const std::string& name, const shapes::ParameterValues& parameters, double size) {
  return shapes::make_shape(name, parameters, size);
}

/// Coarse, so that a whole product of them is quick.
inline const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {
      {"tetrahedron", shapes_for_tests::tetrahedron},
      {"blind_corner", shapes_for_tests::blind_corner},
      {"cube", [] { return catalogued("cube", {}, 0.25); }},
      {"plate", [] { return catalogued("plate", {}, 0.1); }},
      {"wedge",
       [] {
         return catalogued("wedge", {{"angle", 20}}, 0.15);
       }},
      {"knife",
       [] {
         return catalogued("wedge", {{"angle", 2}}, 0.15);
       }},
      {"step", [] { return catalogued("step", {}, 0.2); }},
      {"groove", [] { return catalogued("groove", {}, 0.2); }},
      {"notch",
       [] {
         return catalogued("notch", {{"angle", 60}}, 0.2);
       }},
      {"narrow_notch",
       [] {
         return catalogued("notch", {{"angle", 10}}, 0.2);
       }},
      {"saddle_block", [] { return catalogued("saddle-block", {}, 0.15); }},
      {"block_on_floor", [] { return catalogued("block-on-floor", {}, 0.3); }},
      {"star", [] { return catalogued("star", {}, 0.15); }},
      {"deep_star",
       [] {
         return catalogued("star", {{"points", 12}, {"inner-radius", 0.15}, {"height", 2}}, 0.2);
       }},
      {"sphere", [] { return catalogued("sphere", {}, 0.3); }},
      {"torus", [] { return catalogued("torus", {}, 0.2); }},
      {"cone_tip",
       [] {
         return catalogued("cone", {{"half-angle", 5}}, 0.1);
       }},
      {"needle_triangles",
       [] {
         return shapes_for_tests::mapped(shapes_for_tests::sphere(3),
                                         [](const Vec3& p) { return Vec3(p.x(), p.y(), 1e-3 * p.z()); });
       }},
      {"capsule", [] { return catalogued("capsule", {}, 0.3); }},
      {"wing_with_sharp_trailing_edge",
       [] {
         return catalogued("naca", {{"span", 1.5}}, 0.15);
       }},
      {"gap",
       [] {
         return catalogued("two-boxes", {{"gap", 0.03}}, 0.2);
       }},
      {"hair_gap",
       [] {
         return catalogued("two-spheres", {{"gap", 1e-7}}, 0.25);
       }},
      {"small_body_before_a_large_one",
       [] {
         return catalogued("two-spheres", {{"second-radius", 0.01}, {"gap", 0.02}}, 0.3);
       }},
      {"concentric_spheres", [] { return catalogued("concentric-spheres", {}, 0.25); }, true},
      {"bend", [] { return catalogued("bend", {}, 0.3); }, true},
  };
  return all;
}

struct Schedule {
  std::string name;
  std::function<std::vector<double>(double diagonal)> heights;
};

inline const std::vector<Schedule>& schedules() {
  using growing_for_tests::geometric;
  static const std::vector<Schedule> all = {
      {"standard", [](double d) { return geometric(0.01 * d, 1.2, 20); }},
      {"one_layer", [](double d) { return geometric(0.005 * d, 1, 1); }},
      {"thin_as_rans", [](double d) { return geometric(1e-6 * d * 1181.88, 1.2, 30); }},
      {"thicker_than_the_body", [](double d) { return geometric(0.4 * d, 1.3, 8); }},
  };
  return all;
}

/// The surface as `grow` wants it: normals into the fluid.
inline mesh::SurfaceMesh into_the_fluid(const Shape& shape) {
  mesh::SurfaceMesh surface = shape.make();
  return shape.fluid_is_inside ? shapes_for_tests::flipped(std::move(surface)) : surface;
}

inline double diagonal(const mesh::SurfaceMesh& surface) {
  return geometry::bounding_box(surface.points.raw()).diagonal();
}

}  // namespace nearwall::gallery

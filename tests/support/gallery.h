#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/box.h"
#include "nearwall/shapes/shapes.h"
#include "tests/support/growing.h"
#include "tests/support/monsters.h"
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

/// A shape of the catalogue, with a name that says what is special.
inline Shape catalogue_shape(std::string name, const std::string& shape, const shapes::ParameterValues& parameters,
                             double size, bool fluid_is_inside = false) {
  return {std::move(name), [=] { return catalogued(shape, parameters, size); }, fluid_is_inside};
}

/// Bodies of all kinds. Coarse, as all shapes here are, so that a whole product of them is quick.
inline std::vector<Shape> common_shapes() {
  using namespace shapes_for_tests;
  return {
      {"tetrahedron", tetrahedron},
      {"blind_corner", blind_corner},
      catalogue_shape("cube", "cube", {}, 0.25),
      catalogue_shape("plate", "plate", {}, 0.1),
      catalogue_shape("wedge", "wedge", {{"angle", 20}}, 0.15),
      catalogue_shape("knife", "wedge", {{"angle", 2}}, 0.15),
      catalogue_shape("step", "step", {}, 0.2),
      catalogue_shape("groove", "groove", {}, 0.2),
      catalogue_shape("notch", "notch", {{"angle", 60}}, 0.2),
      catalogue_shape("narrow_notch", "notch", {{"angle", 10}}, 0.2),
      catalogue_shape("saddle_block", "saddle-block", {}, 0.15),
      catalogue_shape("block_on_floor", "block-on-floor", {}, 0.3),
      catalogue_shape("star", "star", {}, 0.15),
      catalogue_shape("deep_star", "star", {{"points", 12}, {"inner-radius", 0.15}, {"height", 2}}, 0.2),
      catalogue_shape("sphere", "sphere", {}, 0.3),
      catalogue_shape("torus", "torus", {}, 0.2),
      catalogue_shape("cone_tip", "cone", {{"half-angle", 5}}, 0.1),
      {"needle_triangles",
       [] { return mapped(sphere(3), [](const Vec3& p) { return Vec3(p.x(), p.y(), 1e-3 * p.z()); }); }},
      catalogue_shape("capsule", "capsule", {}, 0.3),
      catalogue_shape("wing_with_sharp_trailing_edge", "naca", {{"span", 1.5}}, 0.15),
      catalogue_shape("gap", "two-boxes", {{"gap", 0.03}}, 0.2),
      catalogue_shape("hair_gap", "two-spheres", {{"gap", 1e-7}}, 0.25),
      catalogue_shape("small_body_before_a_large_one", "two-spheres", {{"second-radius", 0.01}, {"gap", 0.02}}, 0.3),
      catalogue_shape("concentric_spheres", "concentric-spheres", {}, 0.25, true),
      catalogue_shape("bend", "bend", {}, 0.3, true),
  };
}

/// Special ridges: knife edges, notches, ridges that fade, bend or change sign.
inline std::vector<Shape> ridge_shapes() {
  return {
      catalogue_shape("wedge_of_5", "wedge", {{"angle", 5}}, 0.2),
      catalogue_shape("wedge_of_10", "wedge", {{"angle", 10}}, 0.2),
      catalogue_shape("wedge_of_60", "wedge", {{"angle", 60}}, 0.2),
      catalogue_shape("notch_of_20", "notch", {{"angle", 20}}, 0.25),
      catalogue_shape("notch_of_120", "notch", {{"angle", 120}}, 0.25),
      catalogue_shape("knife_plate", "knife-plate", {}, 0.2),
      catalogue_shape("sharpest_knife_plate", "knife-plate", {{"length", 1.5}, {"angle", 1}}, 0.25),
      catalogue_shape("delta_wing", "delta-wing", {}, 0.15),
      catalogue_shape("kinked_wing", "kinked-wing", {}, 0.25),
      catalogue_shape("much_kinked_wing", "kinked-wing", {{"kink", 55}, {"angle", 5}}, 0.25),
      catalogue_shape("cut_off_wing_tip", "naca", {{"span", 1.2}, {"rounded-tip", 0}}, 0.2),
      catalogue_shape("twisted_roof", "twisted-roof", {}, 0.25),
      catalogue_shape("kinked_roof", "kinked-roof", {}, 0.3),
      catalogue_shape("steep_kinked_roof", "kinked-roof", {{"turn", 110}, {"height", 1.5}}, 0.3),
      catalogue_shape("fading_ridge", "fading-ridge", {}, 0.3),
      catalogue_shape("fading_ridge_on_saddle", "fading-ridge", {{"saddle", 1}, {"turn", 140}}, 0.3),
      catalogue_shape("ski_jump", "ski-jump", {{"lip-radius", 0.5}}, 0.25),
      catalogue_shape("steep_ski_jump", "ski-jump", {{"lip-angle", 80}, {"lip-radius", 0}}, 0.25),
      catalogue_shape("fin_on_plate", "fin-on-plate", {}, 0.3),
      catalogue_shape("thin_fin_on_plate", "fin-on-plate", {{"angle", 3}, {"sweep", -50}}, 0.3),
      catalogue_shape("fin_on_sphere", "fin-on-sphere", {}, 0.3),
  };
}

/// Special corners: mixed signs, many ridges, tips, and such that no direction sees.
inline std::vector<Shape> corner_shapes() {
  std::vector<Shape> all = {
      catalogue_shape("pit", "pit", {}, 0.4),
      catalogue_shape("two_convex_one_concave", "octants", {{"pattern", 7}}, 0.35),
      catalogue_shape("one_convex_two_concave", "octants", {{"pattern", 248}}, 0.35),
      catalogue_shape("three_concave", "octants", {{"pattern", 127}}, 0.35),
      catalogue_shape("three_and_three", "octants", {{"pattern", 23}}, 0.35),
      catalogue_shape("blind_octants", "octants", {{"pattern", 139}}, 0.35),
      catalogue_shape("blind_octants_mirrored", "octants", {{"pattern", 141}}, 1),
      catalogue_shape("blind_octants_from_inside", "octants", {{"pattern", 139}}, 0.35, true),
      catalogue_shape("ski_jump_corner", "ski-jump-corner", {}, 0.25),
      catalogue_shape("steep_ski_jump_corner", "ski-jump-corner", {{"lip-angle", 80}}, 0.25),
      catalogue_shape("omni_saddle", "omni-saddle", {}, 0.4),
      catalogue_shape("omni_saddle_of_3", "omni-saddle", {{"arms", 3}, {"arm-width", 0.3}}, 0.5),
      catalogue_shape("omni_saddle_of_6", "omni-saddle", {{"arms", 6}, {"tip-distance", 0.2}}, 0.5),
      catalogue_shape("omni_saddle_from_inside", "omni-saddle", {}, 0.5, true),
      catalogue_shape("saddle_of_ridges", "crown", {{"points", 2}, {"ridge-slope", 60}, {"valley-slope", 60}}, 0.5),
      catalogue_shape("needle_of_3_sides", "pyramid", {{"sides", 3}, {"half-angle", 3}}, 0.2),
      catalogue_shape("needle_of_5_sides", "pyramid", {{"sides", 5}, {"half-angle", 15}}, 0.2),
  };
  for (const int n : {3, 4, 5, 6, 8}) {
    all.push_back(catalogue_shape("crown_of_" + std::to_string(n), "crown",
                                  {{"points", n}, {"ridge-slope", 50}, {"valley-slope", 55}}, 0.5));
  }
  for (const int half_angle : {1, 2, 10, 30}) {
    all.push_back(catalogue_shape("cone_of_" + std::to_string(half_angle), "cone", {{"half-angle", half_angle}}, 0.2));
  }
  return all;
}

/// Several bodies close together, bodies in bodies, and dense meshes beside coarse ones.
inline std::vector<Shape> crowded_shapes() {
  using namespace shapes_for_tests;
  return {
      catalogue_shape("thin_gap", "two-spheres", {{"gap", 1e-3}, {"second-radius", 0.7}}, 0.3),
      catalogue_shape("hair_gap_of_boxes", "two-boxes", {{"gap", 1e-7}}, 0.35),
      {"sphere_a_hair_above_cube", [] { return sphere_above_cube(1e-7); }},
      {"cylinder_above_block", [] { return cylinder_above_block(1e-3); }},
      {"crossed_edges", [] { return crossed_edges(1e-3); }},
      {"edges_crossed_by_a_hair", [] { return crossed_edges(1e-7); }},
      {"corner_above_cube", [] { return corner_above_cube(1e-3); }},
      {"ball_in_ring", ball_in_ring},
      {"bodies_in_a_ball", [] { return bodies_in_a_ball(); }, true},
      {"swarm", swarm},
      {"dense_side", dense_side},
      {"dense_spot", dense_spot},
      {"dense_before_coarse", dense_before_coarse},
  };
}

/// All of them.
inline const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = [] {
    std::vector<Shape> result;
    for (const auto& group : {common_shapes(), ridge_shapes(), corner_shapes(), crowded_shapes()}) {
      result.insert(result.end(), group.begin(), group.end());
    }
    return result;
  }();
  return all;
}

/// One or two of each kind, for products that all of them would make too long.
inline std::vector<Shape> few_shapes() {
  std::vector<Shape> few;
  for (const char* name : {"cube",
                           "knife",
                           "narrow_notch",
                           "star",
                           "torus",
                           "cone_tip",
                           "wing_with_sharp_trailing_edge",
                           "gap",
                           "concentric_spheres",
                           "kinked_wing",
                           "kinked_roof",
                           "fading_ridge_on_saddle",
                           "fin_on_sphere",
                           "one_convex_two_concave",
                           "blind_octants",
                           "omni_saddle",
                           "crown_of_5",
                           "needle_of_3_sides",
                           "ball_in_ring",
                           "dense_spot"}) {
    const auto found = std::find_if(shapes().begin(), shapes().end(), [&](const Shape& s) { return s.name == name; });
    if (found == shapes().end()) throw InputError(std::string("the gallery has no shape ") + name);
    few.push_back(*found);
  }
  return few;
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

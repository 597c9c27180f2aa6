#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "nearwall/shapes/shapes.h"
#include "nearwall/volume/outer_boundary.h"
#include "tests/support/moved.h"
#include "tests/support/open_walls.h"

/// Domains bounded by planes, on which the properties of layers and volumes are tried.
namespace nearwall::open_shapes {

using namespace open_walls_for_tests;

struct OpenShape {
  std::string name;
  std::function<surface::OpenWall()> make;
  std::set<std::string> with_layers;  ///< patches
};

/// A far field of a few hundred triangles round a wall, cut by the planes that the wall ends at and by others.
inline surface::OpenWall in_far_field(surface::OpenWall wall, const std::vector<volume::SymmetryPlane>& more = {}) {
  const geometry::Box box = geometry::bounding_box(wall.surface.points.raw());
  volume::FarField far;
  far.planes = more;
  for (const mesh::SidePlane& plane : wall.planes.planes) {
    const double sign = plane.normal[plane.axis];
    far.planes.push_back({plane.axis, plane.offset * sign, sign > 0 ? 1 : -1});
  }
  far.centre = box.centre();
  for (const auto& plane : far.planes) far.centre[plane.axis] = plane.position;
  far.radius = 3 * box.diagonal();
  far.size = far.radius;
  volume::add_far_field(far, wall);
  return wall;
}

/// Part of a body of the catalogue, cut at patches that are planes of symmetry.
inline surface::OpenWall cut_body(const std::string& name, const shapes::ParameterValues& parameters, double size,
                                  const std::vector<std::string>& cuts) {
  Roles roles;
  for (const std::string& cut : cuts) roles[cut] = SideRole::Symmetry;
  return in_far_field(Closed(shapes::make_shape(name, parameters, size), roles, FluidSide::Outside).open());
}

/// A lumen of the catalogue that is open at some patches; others have neither layers nor a role.
inline surface::OpenWall duct(const std::string& name, const shapes::ParameterValues& parameters, double size,
                              const std::vector<std::string>& openings, const std::set<std::string>& bare = {}) {
  Roles roles;
  for (const std::string& opening : openings) roles[opening] = SideRole::Opening;
  return Closed(shapes::make_shape(name, parameters, size), roles, FluidSide::Inside, bare).open();
}

/// A room over the unit square: its floor rises along x, its walls lean out by the tangent given. The ceiling is bare.
inline mesh::SurfaceMesh closed_room(int level, double rise, double lean) {
  mesh::SurfaceMesh surface = shapes_for_tests::box({0, 0, 0}, {1, 1, 1});
  for (int i = 0; i < level; ++i) surface = shapes_for_tests::subdivided(surface);
  paint(surface, "ceiling", [](const Vec3& p) { return p.z() == 1; });
  paint(surface, "sides", [](const Vec3& p) { return p.z() > 0 && p.z() < 1; });
  return shapes_for_tests::mapped(std::move(surface), [&](const Vec3& p) {
    const double z = p.z() + rise * p.x() * (1 - p.z());
    return Vec3(p.x() + lean * z * (2 * p.x() - 1), p.y(), z);
  });
}

inline surface::OpenWall room(int level, double rise = 0, double lean = 0) {
  return Closed(closed_room(level, rise, lean), {{"sides", SideRole::Opening}}, FluidSide::Inside, {"ceiling"}).open();
}

/// The room with a floor as high as a function of x says.
template <class Height>
surface::OpenWall room_over(int level, const Height& height) {
  return Closed(shapes_for_tests::mapped(
                    closed_room(level, 0, 0),
                    [&](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() + height(p.x()) * (1 - p.z())); }),
                {{"sides", SideRole::Opening}}, FluidSide::Inside, {"ceiling"})
      .open();
}

/// A sphere of which the plane y = 0 leaves the part beyond a parallel of latitude.
inline surface::OpenWall sphere_cut_at(double latitude) {
  const double at = std::sin(latitude);
  mesh::SurfaceMesh cap = shapes_for_tests::mapped(shapes_for_tests::sphere(3), [&](const Vec3& p) {
    if (p.y() <= 0) return Vec3(p.x() * std::cos(latitude), 0, p.z() * std::cos(latitude));
    // The half above becomes the part above the parallel.
    const double angle = latitude + std::asin(p.y()) * (1 - 2 * latitude / geometry::kPi);
    const double shrink = std::cos(angle) / std::hypot(p.x(), p.z());
    const bool is_pole = std::hypot(p.x(), p.z()) == 0;
    return is_pole ? Vec3(0, 1 - at, 0) : Vec3(p.x() * shrink, std::sin(angle) - at, p.z() * shrink);
  });
  paint(cap, "cut", [](const Vec3& p) { return p.y() == 0; });
  return in_far_field(Closed(cap, {{"cut", SideRole::Symmetry}}, FluidSide::Outside).open());
}

/// The room turned so that none of its planes lies along an axis.
inline surface::OpenWall turned_room(int level) {
  const gallery::Rotation rotate(5);
  return Closed(shapes_for_tests::mapped(closed_room(level, 0, 0), rotate), {{"sides", SideRole::Opening}},
                FluidSide::Inside, {"ceiling"})
      .open();
}

inline std::vector<OpenShape> shapes_with_planes() {
  return {
      {"room", [] { return room(3); }, {"wall"}},
      {"room_with_a_ramp", [] { return room(3, 0.3); }, {"wall"}},
      {"room_with_leaning_walls", [] { return room(3, 0, 0.25); }, {"wall"}},
      {"room_with_inclining_walls", [] { return room(3, 0, -0.25); }, {"wall"}},
      {"turned_room", [] { return turned_room(3); }, {"wall"}},
      {"room_with_a_knife_edge",
       [] { return room_over(3, [](double x) { return std::max(0.0, 0.5 - 4 * std::abs(x - 0.5)); }); },
       {"wall"}},
      {"room_with_a_notch",
       [] { return room_over(3, [](double x) { return std::min(0.0, 4 * std::abs(x - 0.5) - 0.5); }); },
       {"wall"}},
      {"room_with_waves",
       [] { return room_over(4, [](double x) { return 0.1 * std::sin(4 * geometry::kPi * x); }); },
       {"wall"}},
      {"sphere_cut_north", [] { return sphere_cut_at(0.6); }, {"wall"}},
      {"sphere_cut_south", [] { return sphere_cut_at(-0.6); }, {"wall"}},
      {"bend",
       [] {
         return duct("bend", {}, 0.3, {"inlet", "outlet"});
       },
       {"wall"}},
      {"bend_with_oblique_outlet",
       [] {
         return duct("bend", {{"angle", 30}}, 0.3, {"inlet", "outlet"});
       },
       {"wall"}},
      {"vessel",
       [] {
         return duct("vessel", {}, 0.2, {"inlet", "outlet-1", "outlet-2"});
       },
       {"wall"}},
      {"half_spheres",
       [] {
         return cut_body("two-spheres", {{"half", 1}, {"gap", 0.1}}, 0.25, {"symmetry"});
       },
       {"first", "second"}},
      {"quarter_cylinder",
       [] {
         return cut_body("quarter-cylinder", {}, 0.15, {"symmetry-y", "symmetry-z"});
       },
       {"front", "side", "base"}},
      {"body_off_its_three_planes",
       [] {
         const auto body = Closed(shapes_for_tests::sphere(2), {}, FluidSide::Outside).open();
         return in_far_field(body, {{0, -2, 1}, {1, 1.5, -1}, {2, -3, 1}});
       },
       {"wall"}},
      {"half_wing",
       [] {
         return cut_body("onera-m6", {{"half", 1}}, 0.1, {"root"});
       },
       {"upper", "lower", "tip", "trailing-edge"}},
      {"car_in_a_tunnel",
       [] {
         return duct("ahmed-tunnel", {}, 0.25, {"inlet", "outlet", "symmetry", "side"}, {"top"});
       },
       {"front", "roof", "slant", "base", "side-right", "underbody", "stilts", "floor"}},
      {"half_wing_body",
       [] {
         return cut_body("wing-body", {{"half", 1}}, 0.3, {"symmetry"});
       },
       {"fuselage", "wing-upper", "wing-lower", "wing-tip"}},
  };
}

/// Diagonal of the patches with layers.
inline double size_of(const mesh::SurfaceMesh& surface, const std::set<std::string>& patches) {
  geometry::Box box;
  for (const FaceId f : surface.faces.ids()) {
    if (!patches.contains(surface.patch_names[surface.face_patch[f]])) continue;
    for (const Vec3& p : surface.triangle(f)) box.include(p);
  }
  return box.diagonal();
}

}  // namespace nearwall::open_shapes

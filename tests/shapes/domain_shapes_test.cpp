// Shapes with planes on which a flow ends: halves, quarters, caps, tunnels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/shapes/shapes.h"
#include "tests/shapes/surface_measures.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;
using geometry::to_radians;
using mesh::SurfaceMesh;

/// Points of a patch.
std::vector<Vec3> points_of(const SurfaceMesh& s, std::string_view patch) {
  std::vector<Vec3> points;
  for (const FaceId f : s.faces.ids()) {
    if (s.patch_names[s.face_patch[f]] != patch) continue;
    for (const VertexId v : s.faces[f]) points.push_back(s.points[v]);
  }
  return points;
}

/// A patch whose points all have this coordinate, bit for bit.
void expect_in_plane(const SurfaceMesh& s, std::string_view patch, int axis, double position) {
  const std::vector<Vec3> points = points_of(s, patch);
  EXPECT_FALSE(points.empty()) << patch;
  EXPECT_EQ(std::count_if(points.begin(), points.end(), [&](const Vec3& p) { return p[axis] != position; }), 0)
      << patch;
}

/// Nothing lies on the negative side of a coordinate plane, and all that lies in it belongs to its patch.
void expect_cut(const SurfaceMesh& s, std::string_view patch, int axis) {
  expect_in_plane(s, patch, axis, 0);
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    EXPECT_GE(std::min({a[axis], b[axis], c[axis]}), 0);
    const bool is_in_plane = a[axis] == 0 && b[axis] == 0 && c[axis] == 0;
    EXPECT_EQ(is_in_plane, s.patch_names[s.face_patch[f]] == patch);
  }
}

TEST(Half, IsFlatInItsPlaneBitForBit) {
  for (const char* name : {"naca", "onera-m6"}) {
    for (const double size : {0.02, 0.05}) {
      for (const double blunt : {0, 1}) {
        for (const double rounded : {0, 1}) {
          expect_cut(make_shape(name, {{"half", 1}, {"blunt", blunt}, {"rounded-tip", rounded}}, size), "root", 1);
        }
      }
    }
  }
  for (const double size : {0.0, 0.1, 0.3}) {
    expect_cut(make_shape("wing-body", {{"half", 1}}, size), "symmetry", 1);
    expect_cut(make_shape("two-spheres", {{"half", 1}}, size), "symmetry", 1);
  }
}

TEST(Half, IsHalfOfTheWhole) {
  for (const char* name : {"naca", "onera-m6", "wing-body"}) {
    const double whole = volume(make_shape(name));
    EXPECT_NEAR(volume(make_shape(name, {{"half", 1}})), whole / 2, 1e-13 * whole) << name;
  }
}

TEST(HalfWingBody, HasTheFuselagesOutlineInItsPlane) {
  // Half an ellipse of half axes 3 and 1 radii, a rectangle, half an ellipse of 5 and 1.
  const SurfaceMesh s = make_shape("wing-body", {{"half", 1}}, 0.05);
  const double expected = 0.5 * kPi * 1.5 * 0.5 + (8 - 8 * 0.5) * 1 + 0.5 * kPi * 2.5 * 0.5;
  EXPECT_NEAR(patch_area(s, "symmetry"), expected, 1e-3 * expected);
  EXPECT_EQ(patches(s), (std::set<std::string>{"fuselage", "wing-upper", "wing-lower", "wing-tip", "symmetry"}));
}

TEST(HalfTwoSpheres, KeepTheirGapAndTheirVolume) {
  const ParameterValues parameters = {{"half", 1}, {"radius", 1}, {"second-radius", 0.5}, {"gap", 0.25}};
  const SurfaceMesh s = make_shape("two-spheres", parameters, 0.05);
  double left = 0, right = 10;
  for (const Vec3& p : points_of(s, "first")) {
    EXPECT_NEAR(norm(p), 1, 1e-15);
    left = std::max(left, p.x());
  }
  for (const Vec3& p : points_of(s, "second")) right = std::min(right, p.x());
  EXPECT_EQ(right - left, 0.25);
  EXPECT_NEAR(volume(s), 2 * kPi / 3 * (1 + 0.125), 0.01);
}

/// Chords cut off the square of the size.
TEST(QuarterCylinder, TendsToAQuarterOfTheCylinder) {
  const double smooth = kPi * 0.25 * 2 / 4;
  const double coarse = smooth - volume(make_shape("quarter-cylinder", {}, 0.06));
  const double fine = smooth - volume(make_shape("quarter-cylinder", {}, 0.03));
  EXPECT_GT(coarse, 0);
  EXPECT_NEAR(fine / coarse, 0.25, 0.08);
}

TEST(QuarterCylinder, HasBothPlanesAndTheLineBetweenThem) {
  for (const double size : {0.0, 0.03, 0.2}) {
    const SurfaceMesh s = make_shape("quarter-cylinder", {}, size);
    expect_cut(s, "symmetry-y", 1);
    expect_cut(s, "symmetry-z", 2);
    EXPECT_NEAR(patch_area(s, "symmetry-y"), 0.5 * 2, 1e-13);
    EXPECT_NEAR(patch_area(s, "symmetry-z"), 0.5 * 2, 1e-13);
    EXPECT_EQ(patches(s), (std::set<std::string>{"front", "side", "base", "symmetry-y", "symmetry-z"}));
    for (const Vec3& p : points_of(s, "side")) EXPECT_NEAR(std::hypot(p.y(), p.z()), 0.5, 1e-15);
  }
}

TEST(SphereInBox, EnclosesTheSpaceBetween) {
  const SurfaceMesh s = make_shape("sphere-in-box", {}, 0.02);
  const double ball = 4 * kPi / 3 * 0.125;
  EXPECT_NEAR(volume(s), 64 - ball, 2e-3 * ball);
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, static_cast<char>('x' + axis));
    expect_in_plane(s, name + "-min", axis, -2);
    expect_in_plane(s, name + "-max", axis, 2);
  }
  EXPECT_THROW(make_shape("sphere-in-box", {{"radius", 1.9}}), InputError);
}

TEST(SphereInBox, IsAsCoarseAtTheBoxAsAsked) {
  const auto mean_area = [](const SurfaceMesh& s, std::string_view patch) {
    return patch_area(s, patch) / (static_cast<double>(points_of(s, patch).size()) / 3);
  };
  const SurfaceMesh s = make_shape("sphere-in-box", {{"coarsening", 5}}, 0.04);
  EXPECT_NEAR(std::sqrt(mean_area(s, "x-min") / mean_area(s, "sphere")), 5, 0.5);
}

TEST(Bend, HasFlatCapsBitForBitWhereTheyFaceAnAxis) {
  for (const double size : {0.0, 0.05, 0.2}) {
    expect_in_plane(make_shape("bend", {}, size), "inlet", 0, -1);
    expect_in_plane(make_shape("bend", {}, size), "outlet", 2, 1.5 + 2);
    expect_in_plane(make_shape("bend", {{"angle", 180}}, size), "outlet", 0, -2);
  }
  for (const Vec3& p : points_of(make_shape("bend", {{"angle", 30}}), "outlet")) {
    const Vec3 along(std::cos(kPi / 6), 0, std::sin(kPi / 6));
    EXPECT_NEAR(dot(p - Vec3(0, 0, 1.5), along), 2, 1e-14);
  }
}

/// Largest turn between two neighbouring triangles of a patch [deg].
double largest_turn_deg(const SurfaceMesh& s, std::string_view patch) {
  const mesh::Topology topology(s);
  const auto normal = [&s](FaceId f) {
    const auto [a, b, c] = s.triangle(f);
    return geometry::triangle_normal(a, b, c);
  };
  const auto is_inside = [&](FaceId f) { return s.patch_names[s.face_patch[f]] == patch; };
  double largest = 0;
  for (const FaceId f : s.faces.ids()) {
    for (int k = 0; k < 3; ++k) {
      const FaceId g = mesh::Topology::face(topology.twin(mesh::Topology::halfedge(f, k)));
      if (is_inside(f) && is_inside(g)) largest = std::max(largest, geometry::angle_between(normal(f), normal(g)));
    }
  }
  return geometry::to_degrees(largest);
}

TEST(Vessel, HasFlatRoundCaps) {
  const SurfaceMesh s = make_shape("vessel", {}, 0.04);
  EXPECT_EQ(patches(s), (std::set<std::string>{"wall", "inlet", "outlet-1", "outlet-2"}));
  expect_in_plane(s, "inlet", 0, -2);
  EXPECT_NEAR(patch_area(s, "inlet"), kPi * 0.25, 2e-3);
  const struct {
    const char* name;
    double heading;
  } outlets[] = {{"outlet-1", to_radians(35)}, {"outlet-2", -to_radians(35)}};
  for (const auto& [name, heading] : outlets) {
    const Vec3 along(std::cos(heading), 0, std::sin(heading));
    EXPECT_NEAR(patch_area(s, name), kPi * 0.16, 2e-3);
    for (const Vec3& p : points_of(s, name)) {
      EXPECT_NEAR(dot(p, along), 2.5, 1e-14);
      EXPECT_LE(norm(p - along * 2.5), 0.4 + 1e-14);
    }
  }
}

TEST(Vessel, HasCapsFlatBitForBitWhereTheyFaceAnAxis) {
  const SurfaceMesh s = make_shape("vessel", {{"angle", 180}});
  expect_in_plane(s, "outlet-1", 2, 2.5);
  expect_in_plane(s, "outlet-2", 2, -2.5);
}

/// A longer tube is a longer cylinder: the junction stays as it is.
TEST(Vessel, GrowsByCylinders) {
  const auto grown = [](const char* name, double by) {
    return volume(make_shape("vessel", {{name, 2.5 + by}}, 0.05)) - volume(make_shape("vessel", {{name, 2.5}}, 0.05));
  };
  EXPECT_NEAR(grown("inlet-length", 1), kPi * 0.25, 5e-3);
  EXPECT_NEAR(grown("outlet-length", 1), 2 * kPi * 0.16, 5e-3);
}

/// Turns between triangles of a smooth surface tend to zero as their size.
TEST(Vessel, IsSmoothAtItsJunction) {
  for (const double angle : {40, 70, 180}) {
    const double coarse = largest_turn_deg(make_shape("vessel", {{"angle", angle}}, 0.1), "wall");
    const double fine = largest_turn_deg(make_shape("vessel", {{"angle", angle}}, 0.025), "wall");
    EXPECT_LT(fine, 0.45 * coarse) << angle;
  }
}

TEST(Vessel, RefusesTubesThatEndInTheJunction) {
  EXPECT_THROW(make_shape("vessel", {{"inlet-length", 0.5}}), InputError);
  EXPECT_THROW(make_shape("vessel", {{"outlet-length", 1}, {"angle", 40}}), InputError);
}

TEST(AhmedTunnel, HasEachSideInItsPlaneBitForBit) {
  for (const double size : {0.02, 0.05}) {
    for (const double stilts : {0, 1}) {
      const SurfaceMesh s = make_shape("ahmed-tunnel", {{"stilts", stilts}}, size);
      expect_cut(s, "symmetry", 1);
      expect_in_plane(s, "floor", 2, 0);
      expect_in_plane(s, "top", 2, 1.4);
      expect_in_plane(s, "side", 1, 1.87 / 2);
      expect_in_plane(s, "inlet", 0, -2.1);
      expect_in_plane(s, "outlet", 0, 1.044 + 4.2);
    }
  }
}

TEST(AhmedTunnel, EnclosesTheTunnelWithoutTheCar) {
  const double tunnel = (2.1 + 1.044 + 4.2) * 1.4 * 1.87 / 2;
  const double car = volume(make_shape("ahmed", {}, 0.02)) / 2;
  EXPECT_NEAR(volume(make_shape("ahmed-tunnel", {}, 0.02)), tunnel - car, 1e-4 * car);
  const double without = volume(make_shape("ahmed-tunnel", {}, 0.02));
  const double with = volume(make_shape("ahmed-tunnel", {{"stilts", 1}}, 0.02));
  // Two stilts of 30 mm diameter and 50 mm height, with 12 edges round or more.
  EXPECT_LT(without - with, 2 * kPi * 0.015 * 0.015 * 0.05);
  EXPECT_GT(without - with, 2 * 6 * std::sin(kPi / 6) * 0.015 * 0.015 * 0.05);
}

TEST(AhmedTunnel, HasTheCarsOutlineAsAHoleInItsPlane) {
  const SurfaceMesh s = make_shape("ahmed-tunnel", {}, 0.01);
  const double slant = to_radians(25);
  const double outline =
      1.044 * 0.288 - 2 * (1 - kPi / 4) * 0.01 - 0.5 * 0.222 * std::sin(slant) * 0.222 * std::cos(slant);
  EXPECT_NEAR(patch_area(s, "symmetry"), (2.1 + 1.044 + 4.2) * 1.4 - outline, 1e-4);
  EXPECT_NEAR(patch_area(s, "floor"), (2.1 + 1.044 + 4.2) * 1.87 / 2, 1e-12);
  EXPECT_NEAR(patch_area(s, "slant"), 0.222 * 0.389 / 2, 1e-12);
  EXPECT_EQ(patches(s), (std::set<std::string>{"front", "roof", "slant", "base", "side-right", "underbody", "floor",
                                               "inlet", "outlet", "side", "top", "symmetry"}));
}

TEST(AhmedTunnel, IsFineBelowTheCarAndCoarseFarFromIt) {
  const SurfaceMesh s = make_shape("ahmed-tunnel", {}, 0.02);
  double longest_below = 0, longest = 0;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    const double edge = std::max({distance(a, b), distance(b, c), distance(c, a)});
    longest = std::max(longest, edge);
    const Vec3 m = (a + b + c) / 3;
    const bool is_below = m.z() == 0 && m.x() > 0 && m.x() < 1.044 && m.y() < 0.389 / 2;
    if (is_below) longest_below = std::max(longest_below, edge);
  }
  EXPECT_LT(longest_below, 1.6 * 0.02);
  EXPECT_GT(longest, 0.15);
  EXPECT_LT(longest, 2 * 0.15);
}

TEST(AhmedTunnel, RefusesATunnelThatTouchesTheCar) {
  EXPECT_THROW(make_shape("ahmed-tunnel", {{"width", 0.4}}), InputError);
  EXPECT_THROW(make_shape("ahmed-tunnel", {{"height", 0.35}}), InputError);
  EXPECT_THROW(make_shape("ahmed-tunnel", {{"upstream", 0.1}}), InputError);
}

}  // namespace
}  // namespace nearwall::shapes

#include "nearwall/surface/patch_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "tests/support/shapes.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;
using geometry::kPi;
using geometry::to_radians;
using mesh::SurfaceMesh;
using mesh::Topology;

/// A surface with all that its patch normals need.
struct Body {
  explicit Body(SurfaceMesh mesh)
      : surface(std::move(mesh)), topology(surface), features(find_features(surface, topology)) {}

  PatchNormals patches(const NormalOptions& options = {}) const {
    return patch_normals(surface, topology, features, Separation::DiscretePatches, options);
  }
  PatchNormals groups(double multi_angle_deg = 100) const {
    return patch_normals(surface, topology, features, Separation::Groups, {}, {to_radians(multi_angle_deg)});
  }
  VertexId at(const Vec3& p) const {
    for (const VertexId v : surface.points.ids()) {
      if (distance(surface.points[v], p) < 1e-12) return v;
    }
    ADD_FAILURE() << "no such point";
    return VertexId(0);
  }

  SurfaceMesh surface;
  Topology topology;
  Features features;
};

std::set<Vec3> directions(std::span<const PointNormal> normals) {
  std::set<Vec3> all;
  for (const PointNormal& normal : normals) all.insert(normal.direction);
  return all;
}

int n_outer_coordinates(const Vec3& p) {
  int n = 0;
  for (int axis = 0; axis < 3; ++axis) n += std::abs(p[axis]) == 0.5 ? 1 : 0;
  return n;
}

/// Roof whose two sides meet in a convex ridge along y = 1/2, which turns more and more with x from a flat start.
SurfaceMesh fading_roof() {
  return shapes::height_field(8, [](double x, double y) {
    const double along = std::max(0.0, x - 0.5);
    return -9 * along * along * std::abs(y - 0.5);
  });
}

TEST(PatchNormals, AreThoseOfTheSidesOfACube) {
  const Body cube(shapes::subdivided(shapes::subdivided(shapes::cube())));
  const PatchNormals patches = cube.patches();
  for (const VertexId v : cube.surface.points.ids()) {
    const Vec3& p = cube.surface.points[v];
    std::set<Vec3> sides;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 normal;
      normal[axis] = p[axis] > 0 ? 1 : -1;
      if (std::abs(p[axis]) == 0.5) sides.insert(normal);
    }
    EXPECT_EQ(patches.n_groups(v), static_cast<std::size_t>(n_outer_coordinates(p)));
    EXPECT_EQ(directions(patches.of(v)), sides);
  }
}

TEST(PatchNormals, HoldEachCornerAgainstItsOwnSideOfACube) {
  const Body cube(shapes::subdivided(shapes::cube()));
  const PatchNormals patches = cube.patches();
  for (const HalfedgeId h : cube.features.turn.ids()) {
    EXPECT_EQ(patches.at(h).direction, cube.features.face_normal[Topology::face(h)]);
    EXPECT_EQ(patches.at(h).max_angle, 0);
    const VertexId v = cube.topology.origin(h);
    EXPECT_GE(patches.group_of_corner[h], patches.offset[v]);
    EXPECT_LT(patches.group_of_corner[h], patches.offset[VertexId(v.index() + 1)]);
  }
}

TEST(PatchNormals, DivideACubeIntoGroupsOnlyBelowItsTurn) {
  const Body cube(shapes::subdivided(shapes::subdivided(shapes::cube())));
  const PatchNormals whole = cube.groups(100), divided = cube.groups(80);
  for (const VertexId v : cube.surface.points.ids()) {
    EXPECT_EQ(whole.n_groups(v), 1u);
    EXPECT_EQ(divided.n_groups(v), static_cast<std::size_t>(n_outer_coordinates(cube.surface.points[v])));
  }
}

TEST(PatchNormals, TakeTheTurnItselfAsNotExceeded) {
  const Body cube(shapes::cube());
  EXPECT_EQ(cube.groups(90).n_groups(VertexId(0)), 1u);
  EXPECT_EQ(cube.groups(90 - 1e-9).n_groups(VertexId(0)), 3u);
}

TEST(PatchNormals, DivideATrailingEdgeInTwoAndItsEndsByAllRidges) {
  // No direction sees the three faces at an end of the edge under less than 85 degrees.
  const Body wedge(shapes::subdivided(shapes::subdivided(shapes::wedge(to_radians(10)))));
  const PatchNormals groups = wedge.groups();
  for (const VertexId v : wedge.surface.points.ids()) {
    const Vec3& p = wedge.surface.points[v];
    if (p.x() != 0 || p.y() != 0) continue;
    EXPECT_EQ(groups.n_groups(v), p.z() == 0 || p.z() == 1 ? 3u : 2u);
  }
  const Vec3 above(-std::sin(to_radians(5)), std::cos(to_radians(5)), 0);
  const auto normals = groups.of(wedge.at({0, 0, 0.5}));
  ASSERT_EQ(normals.size(), 2u);
  EXPECT_NEAR(std::max(normals[0].direction.y(), normals[1].direction.y()), above.y(), 1e-15);
  EXPECT_NEAR(std::min(normals[0].direction.y(), normals[1].direction.y()), -above.y(), 1e-15);
  EXPECT_NEAR(normals[0].max_angle, 0, 1e-7);
}

TEST(PatchNormals, TakeTheLargestTurnForAllOfARidge) {
  // The edge opens by 90 degrees at z = 0 and by 65 at z = 1.
  const auto narrowed = [](const Vec3& p) {
    return Vec3(p.x(), p.y() * (1 + p.z() * (std::tan(to_radians(32.5)) - 1)), p.z());
  };
  const Body wedge(shapes::mapped(shapes::subdivided(shapes::subdivided(shapes::wedge(kPi / 2))), narrowed));
  double smallest = kPi, largest = 0;
  for (const HalfedgeId h : wedge.features.turn.ids()) {
    const Vec3 &a = wedge.surface.points[wedge.topology.origin(h)], &b = wedge.surface.points[wedge.topology.target(h)];
    if (a.x() != 0 || b.x() != 0 || a.y() != 0 || b.y() != 0) continue;
    smallest = std::min(smallest, wedge.features.turn[h]);
    largest = std::max(largest, wedge.features.turn[h]);
  }
  ASSERT_LT(smallest, to_radians(95));
  ASSERT_GT(largest, to_radians(110));
  const PatchNormals divided = wedge.groups(100), whole = wedge.groups(geometry::to_degrees(largest) + 1e-6);
  for (const double z : {0.25, 0.5, 0.75}) {
    EXPECT_EQ(divided.n_groups(wedge.at({0, 0, z})), 2u) << z;
    EXPECT_EQ(whole.n_groups(wedge.at({0, 0, z})), 1u) << z;
  }
}

TEST(PatchNormals, FollowARidgeThatClosesUp) {
  const Body cone(shapes::cone(40, 0.2));
  const PatchNormals groups = cone.groups();
  for (const VertexId v : cone.surface.points.ids()) {
    EXPECT_EQ(groups.n_groups(v), cone.features.kind[v] == PointKind::Ridge ? 2u : 1u);
  }
}

TEST(PatchNormals, HaveOneGroupWhereARidgeEndsAndTwoWhereABoundaryCutsIt) {
  const Body roof(fading_roof());
  const PatchNormals groups = roof.groups(), patches = roof.patches();
  for (const VertexId v : roof.surface.points.ids()) {
    const Vec3& p = roof.surface.points[v];
    const bool is_cut = p.y() == 0.5 && p.x() == 1;
    const bool is_divided = is_cut || (p.y() == 0.5 && roof.features.kind[v] == PointKind::Ridge);
    EXPECT_EQ(groups.n_groups(v), is_divided ? 2u : 1u) << p.x() << ' ' << p.y();
    EXPECT_EQ(patches.n_groups(v), is_divided ? 2u : 1u) << p.x() << ' ' << p.y();
  }
  EXPECT_EQ(std::count(roof.features.kind.begin(), roof.features.kind.end(), PointKind::RidgeEnd), 2);
}

TEST(PatchNormals, AreNeverDividedByConcaveRidges) {
  const Body hollow(shapes::subdivided(shapes::flipped(shapes::cube())));
  const PatchNormals groups = hollow.groups(80), patches = hollow.patches();
  for (const VertexId v : hollow.surface.points.ids()) {
    EXPECT_EQ(groups.n_groups(v), 1u);
    EXPECT_EQ(patches.n_groups(v), static_cast<std::size_t>(n_outer_coordinates(hollow.surface.points[v])));
  }
}

TEST(PatchNormals, KeepTheTwoWallsOfAConcaveRidgeTogether) {
  const Body step(shapes::l_step());
  const PatchNormals groups = step.groups(80);
  const auto normals = groups.of(step.at({1, 1, 0}));
  ASSERT_EQ(normals.size(), 2u);
  const bool is_first_cap = normals[0].direction.z() < -0.5;
  EXPECT_EQ(normals[is_first_cap ? 0 : 1].direction, Vec3(0, 0, -1));
  EXPECT_NEAR(distance(normals[is_first_cap ? 1 : 0].direction, Vec3(1, 1, 0) / std::sqrt(2.0)), 0, 1e-15);
}

TEST(PatchNormals, DivideWhereNothingSeesAllFacesWhateverTheTurn) {
  const Body body(shapes::blind_corner());
  const VertexId blind = body.at({0, 0, 0});
  ASSERT_FALSE(point_normals(body.surface, body.topology, body.features)[blind].is_visible);
  const auto several = ridges_with_several_lines(body.surface, body.topology, body.features);
  const PatchNormals groups = body.groups();
  for (const HalfedgeId h : body.topology.fan(blind)) {
    EXPECT_EQ(several[h] != 0, body.features.is_ridge[h] && body.features.turn[h] > 0);
  }
  EXPECT_GT(groups.n_groups(blind), 1u);
  for (const HalfedgeId h : several.ids()) {
    const bool is_at_blind = body.topology.origin(h) == blind || body.topology.target(h) == blind;
    EXPECT_TRUE(is_at_blind || !several[h]);
  }
}

TEST(PatchNormals, NumberThePatchesAsDiscretePatchesDoes) {
  for (const SurfaceMesh& surface : {shapes::subdivided(shapes::cube()), shapes::l_step(), shapes::blind_corner(),
                                     shapes::cone(12, 2), shapes::subdivided(shapes::wedge(0.1)), fading_roof(),
                                     shapes::plate(3), shapes::sphere(1), shapes::tetrahedron()}) {
    const Body body(surface);
    const PatchNormals patches = body.patches();
    for (const VertexId v : body.surface.points.ids()) {
      const std::vector<int> expected = discrete_patches(body.topology, body.features, v);
      const auto fan = body.topology.fan(v);
      ASSERT_EQ(patches.n_groups(v), static_cast<std::size_t>(*std::max_element(expected.begin(), expected.end())) + 1);
      for (std::size_t i = 0; i < fan.size(); ++i) {
        EXPECT_EQ(patches.group_of_corner[fan[i]] - patches.offset[v], static_cast<std::uint32_t>(expected[i]));
      }
    }
  }
}

TEST(PatchNormals, AreThePointNormalsWhereFacesAreNotDivided) {
  const Body sphere(shapes::sphere(2));
  for (const NormalMethod method : {NormalMethod::MostVisible, NormalMethod::Angle, NormalMethod::Max}) {
    const NormalOptions options{.method = method};
    const PatchNormals patches = sphere.patches(options);
    const auto normals = point_normals(sphere.surface, sphere.topology, sphere.features, options);
    for (const VertexId v : sphere.surface.points.ids()) {
      ASSERT_EQ(patches.n_groups(v), 1u);
      EXPECT_EQ(patches.of(v)[0].direction, normals[v].direction);
    }
  }
}

TEST(PatchNormals, SeeAllFacesOfTheirGroup) {
  // Each group of this body, blind as a whole at one vertex, can be seen.
  const Body body(shapes::subdivided(shapes::blind_corner()));
  const PatchNormals patches = body.patches();
  for (const HalfedgeId h : body.features.turn.ids()) {
    EXPECT_TRUE(patches.at(h).is_visible);
    EXPECT_GT(dot(patches.at(h).direction, body.features.face_normal[Topology::face(h)]), 0.9);
  }
}

TEST(PatchNormals, GiveAVertexWithoutFacesNoGroup) {
  SurfaceMesh surface = shapes::cube();
  surface.points.push_back({3, 3, 3});
  const PatchNormals patches = Body(surface).patches();
  EXPECT_EQ(patches.n_groups(VertexId(8)), 0u);
  EXPECT_EQ(patches.normal.size(), 24u);
}

TEST(PatchNormals, AreTheSameAtAnyNumberOfThreads) {
  const Body body(shapes::subdivided(shapes::subdivided(shapes::subdivided(shapes::subdivided(shapes::l_step())))));
  const auto on = [&](int n_threads) {
    const ThreadLimit limit(n_threads);
    return body.groups(80);
  };
  const PatchNormals one = on(1), two = on(2);
  EXPECT_EQ(one.offset, two.offset);
  EXPECT_EQ(one.group_of_corner, two.group_of_corner);
  for (std::size_t i = 0; i < one.normal.size(); ++i) EXPECT_EQ(one.normal[i].direction, two.normal[i].direction);
}

TEST(PatchNormals, RefuseAnglesOutOfRangeAndMethodsThatNeedMoreThanARun) {
  const Body cube(shapes::cube());
  for (const double angle : {0.0, 180.0, -1.0, std::nan("")}) EXPECT_THROW(cube.groups(angle), InputError);
  for (const NormalMethod method : {NormalMethod::Nielson, NormalMethod::MostNormal, NormalMethod::Hardy}) {
    EXPECT_THROW(cube.patches({.method = method}), InputError);
  }
  for (const double thin_angle : {-1.0, 7.0, std::nan("")}) {
    EXPECT_THROW(cube.patches({.thin_angle = thin_angle}), InputError);
  }
}

}  // namespace
}  // namespace nearwall::surface

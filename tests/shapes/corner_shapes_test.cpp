// What the corners of shapes are like that exist for their corners.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "nearwall/core/errors.h"
#include "tests/shapes/special_places.h"
#include "tests/shapes/surface_measures.h"
#include "tests/support/shapes.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;
using geometry::to_degrees;
using geometry::to_radians;
using surface::PointKind;
using testing::Each;
using testing::SizeIs;

constexpr double kExact = 1e-9;  // [deg]

TEST(Pit, IsTheReverseOfABlockOnAFloor) {
  const Place pit("pit", {}, 0.25), block("block-on-floor", {}, 0.25);
  // The bottom of the pit is the top of the block seen from inside, its mouth the block's foot.
  const RidgesAt ground = pit.ridges_at({0.5, 0.5, 0.4}), top = block.ridges_at({0.5, 0.5, 1});
  EXPECT_THAT(ground.convex, SizeIs(0));
  EXPECT_THAT(ground.concave, SizeIs(3));
  EXPECT_THAT(top.convex, SizeIs(3));
  const RidgesAt mouth = pit.ridges_at({0.5, 0.5, 1.4}), foot = block.ridges_at({0.5, 0.5, 0});
  EXPECT_THAT(mouth.convex, SizeIs(2));
  EXPECT_THAT(mouth.concave, SizeIs(1));
  EXPECT_THAT(foot.convex, SizeIs(1));
  EXPECT_THAT(foot.concave, SizeIs(2));
  EXPECT_EQ(pit.n_blind(), 0u);
  EXPECT_NEAR(volume(pit.surface), 9 * 1.4 - 1, 1e-12);
}

/// The octants filled by a pattern, as unit cubes.
std::vector<std::array<int, 3>> cubes_of(unsigned pattern) {
  std::vector<std::array<int, 3>> cubes;
  for (int octant = 0; octant < 8; ++octant) {
    if ((pattern >> octant & 1u) != 0) cubes.push_back({octant % 2 - 1, octant / 2 % 2 - 1, octant / 4 - 1});
  }
  return cubes;
}

bool is_manifold(const mesh::SurfaceMesh& surface) {
  try {
    return mesh::Topology(surface).is_closed();
  } catch (const GeometryError&) {
    return false;
  }
}

/// What is round the centre, from the octants alone: four of them lie round each half axis, and an axis with faces
/// that look both ways along it has no direction that sees them all.
struct Centre {
  std::size_t n_convex = 0, n_concave = 0;
  bool is_visible = true;

  explicit Centre(unsigned pattern) {
    const auto filled = [&](unsigned octant) { return (pattern >> octant & 1u) != 0; };
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned along = 1u << axis, across = 1u << (axis + 1) % 3, up = 1u << (axis + 2) % 3;
      bool looks_forth = false, looks_back = false;
      for (const unsigned side : {0u, along}) {
        const int n = filled(side) + filled(side | across) + filled(side | up) + filled(side | across | up);
        n_convex += n == 1;
        n_concave += n == 3;
      }
      for (const unsigned octant : {0u, across, up, across | up}) {
        looks_forth = looks_forth || (filled(octant) && !filled(octant | along));
        looks_back = looks_back || (!filled(octant) && filled(octant | along));
      }
      is_visible = is_visible && !(looks_forth && looks_back);
    }
  }
};

TEST(Octants, MakeEveryManifoldCornerOfCubes) {
  int n_blind = 0;
  for (unsigned pattern = 1; pattern < 255; ++pattern) {
    const ParameterValues parameters{{"pattern", pattern}};
    if (!is_manifold(shapes_for_tests::voxels(cubes_of(pattern)))) {
      EXPECT_THROW(make_shape("octants", parameters, 1), InputError) << pattern;
      continue;
    }
    const Place place("octants", parameters, 1);
    EXPECT_NEAR(volume(place.surface), static_cast<double>(cubes_of(pattern).size()), 1e-14) << pattern;
    const Centre expected(pattern);
    const VertexId centre = place.vertex_at({0, 0, 0});
    const RidgesAt ridges = place.ridges_at(centre);
    EXPECT_THAT(ridges.convex, SizeIs(expected.n_convex)) << pattern;
    EXPECT_THAT(ridges.concave, SizeIs(expected.n_concave)) << pattern;
    EXPECT_EQ(place.best_view(centre).has_value(), expected.is_visible) << pattern;
    n_blind += !expected.is_visible;
  }
  // Chains of four cubes round the centre, of either hand, in all positions.
  EXPECT_EQ(n_blind, 24);
}

TEST(Octants, HaveCornersOfMixedSign) {
  const RidgesAt two_and_one = Place("octants", {{"pattern", 7}}, 0.5).ridges_at({0, 0, 0});
  EXPECT_THAT(two_and_one.convex, SizeIs(2));
  EXPECT_THAT(two_and_one.concave, SizeIs(1));
  const RidgesAt one_and_two = Place("octants", {{"pattern", 248}}, 0.5).ridges_at({0, 0, 0});
  EXPECT_THAT(one_and_two.convex, SizeIs(1));
  EXPECT_THAT(one_and_two.concave, SizeIs(2));
}

/// Turn at the ridges of a corner on which ridges of slope a and valleys of slope -b alternate, n of each [deg]: the
/// angle between a face's normal and its mirror image.
double crown_turn(int n, double a, double b, bool at_ridge) {
  const double between = kPi / n;
  const Vec3 ridge(1, 0, std::tan(a)), valley(std::cos(between), std::sin(between), -std::tan(b));
  const Vec3 normal = normalized(cross(ridge, valley));
  const Vec3 across = at_ridge ? Vec3(0, 1, 0) : Vec3(-std::sin(between), std::cos(between), 0);
  return to_degrees(2 * std::asin(std::abs(dot(normal, across))));
}

TEST(Crown, AlternatesRidgesAndValleys) {
  for (int n = 2; n <= 8; ++n) {
    for (const double slope : {40.0, 60.0}) {
      const Place crown("crown", {{"points", n}, {"ridge-slope", slope}, {"valley-slope", 45}, {"height", 3}}, 0.5);
      const VertexId apex = crown.vertex_at({0, 0, 3});
      const RidgesAt ridges = crown.ridges_at(apex);
      const double convex = crown_turn(n, to_radians(slope), to_radians(45), true);
      const double concave = crown_turn(n, to_radians(slope), to_radians(45), false);
      EXPECT_THAT(ridges.convex, SizeIs(n));
      EXPECT_THAT(ridges.convex, Each(testing::DoubleNear(convex, kExact)));
      EXPECT_THAT(ridges.concave, SizeIs(n));
      EXPECT_THAT(ridges.concave, Each(testing::DoubleNear(concave, kExact)));
      EXPECT_EQ(crown.features.kind[apex], PointKind::Corner);
      EXPECT_TRUE(crown.best_view(apex).has_value()) << "a height field is seen from above";
    }
  }
}

TEST(Star, AlternatesRidgesAndValleysAtItsApex) {
  for (int n = 3; n <= 8; ++n) {
    const Place star("star", {{"points", n}, {"inner-radius", 0.12}, {"height", 1}}, 0.3);
    const RidgesAt ridges = star.ridges_at({0, 0, 1});
    EXPECT_THAT(ridges.convex, SizeIs(n));
    EXPECT_THAT(ridges.concave, SizeIs(n));
  }
}

TEST(Pyramid, HasSharpRidgesAtItsApex) {
  for (const int n : {3, 4, 6}) {
    for (const double half_angle : {1.0, 10.0, 30.0}) {
      const Place pyramid("pyramid", {{"sides", n}, {"half-angle", half_angle}}, 0.3);
      const VertexId apex = pyramid.vertex_at({0, 0, 0});
      EXPECT_THAT(pyramid.ridges_at(apex).convex, SizeIs(n));
      // Against the axis one sees all sides under the complement of their angle with it.
      const double side = std::atan(std::tan(to_radians(half_angle)) * std::cos(kPi / n));
      EXPECT_NEAR(pyramid.best_view(apex).value(), 90 - to_degrees(side), 1e-6);
    }
  }
}

TEST(Cone, IsSeenFromItsAxisUnderASteepAngle) {
  for (const double half_angle : {1.0, 2.0, 5.0, 10.0, 20.0, 30.0}) {
    const Place cone("cone", {{"half-angle", half_angle}}, 0.02);
    const VertexId apex = cone.vertex_at({0, 0, 0});
    const auto n = static_cast<double>(cone.topology.fan(apex).size());
    const double side = std::atan(std::tan(to_radians(half_angle)) * std::cos(kPi / n));
    EXPECT_NEAR(cone.best_view(apex).value(), 90 - to_degrees(side), 1e-6);
  }
}

/// Turn at an arm's tip: the angle between its two sides, both through the centre and a lower corner [deg].
double tip_turn(double half, double tip) {
  const Vec3 right = cross(Vec3(1, -half, -1), Vec3(tip, 0, -1)), left = cross(Vec3(1, half, -1), Vec3(tip, 0, -1));
  return 180 - to_degrees(std::acos(dot(normalized(right), normalized(left))));
}

TEST(OmniSaddle, HasACentreThatNoDirectionSees) {
  for (const int arms : {2, 3, 4, 6}) {
    const ParameterValues parameters{{"arms", arms}, {"arm-width", 0.3}, {"tip-distance", 0.4}};
    const Place saddle("omni-saddle", parameters, 0.25);
    const VertexId centre = saddle.vertex_at({0, 0, 0});
    EXPECT_EQ(saddle.surface.points[centre], Vec3());
    EXPECT_FALSE(saddle.best_view(centre).has_value());
    EXPECT_EQ(saddle.n_blind(), 1u) << "and no other vertex is blind";
    std::vector<double> sharp = saddle.ridges_at(centre).convex;
    std::erase_if(sharp, [](double turn) { return turn < 100; });
    EXPECT_THAT(sharp, SizeIs(arms));
    EXPECT_THAT(sharp, Each(testing::DoubleNear(tip_turn(0.15, 0.4), kExact)));
  }
}

TEST(SkiJump, HasASharperEdgeTheSteeperItsLip) {
  for (const double rise : {20.0, 50.0, 80.0}) {
    const Place kinked("ski-jump", {{"lip-angle", rise}, {"lip-radius", 0}}, 0.2);
    const Place rounded("ski-jump", {{"lip-angle", rise}, {"lip-radius", 0.5}}, 0.2);
    const double z = 0.5 + 0.4 * std::sin(to_radians(rise));
    for (const Place* place : {&kinked, &rounded}) {
      place->for_each_edge([&](const Vec3& middle, double turn) {
        if (middle.x() < 2 - 1e-9 || middle.z() < z - 1e-9) return;
        EXPECT_NEAR(turn, 90 + rise, kExact);
      });
    }
    EXPECT_EQ(kinked.features.n_concave > 0, rise > 40);
    EXPECT_EQ(rounded.features.n_concave, 0u) << "an arc is no ridge";
  }
}

TEST(SkiJumpCorner, BendsAConvexRidgeUp) {
  const Place place("ski-jump-corner", {}, 0.2);
  const VertexId corner = place.vertex_at({2, 0, 0.5});
  const RidgesAt ridges = place.ridges_at(corner);
  const double back = 0.4 * std::cos(to_radians(50)), up = 0.4 * std::sin(to_radians(50));
  const Vec3 lip = normalized(cross(Vec3(0, 0.5, up), Vec3(-back, 0.5, 0)));
  ASSERT_THAT(ridges.convex, SizeIs(2));
  EXPECT_NEAR(std::min(ridges.convex[0], ridges.convex[1]), 90, kExact);
  EXPECT_NEAR(std::max(ridges.convex[0], ridges.convex[1]), to_degrees(std::acos(lip.x())), kExact);
  ASSERT_THAT(ridges.concave, SizeIs(1));
  EXPECT_NEAR(ridges.concave[0], to_degrees(std::acos(lip.z())), kExact);
  EXPECT_EQ(place.features.kind[corner], PointKind::Corner);
  EXPECT_TRUE(place.best_view(corner).has_value());
}

}  // namespace
}  // namespace nearwall::shapes

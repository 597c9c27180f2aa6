#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/surface/normals.h"
#include "tests/surface/most_normal_reference.h"

namespace nearwall::surface {
namespace {

using fans::Random;
using rings::Points;

constexpr double kPi = std::numbers::pi;
constexpr double kRightAngle = kPi / 2;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::optional<NormalNormal> most_normal(const Points& ring) { return most_normal_normal({0, 0, 0}, ring); }

std::optional<VisibleNormal> most_visible(const Points& ring) {
  Points normals;
  for (std::size_t k = 0; k < ring.size(); ++k) normals.push_back(cross(ring[k], ring[(k + 1) % ring.size()]));
  return most_visible_normal(normals);
}

const Points kConcaveBox = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Points kConvexBox = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
/// The fluid is above the floor and outside the block, which fills the octant x, y, z > 0.
const Points kBlockOnFloor = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};
const Points kBlockOnFloorReversed(kBlockOnFloor.rbegin(), kBlockOnFloor.rend());

TEST(MostNormalNormal, KeepsTheDistancesOfTheCornersOfTheLiterature) {
  const double diagonal = std::asin(1 / std::sqrt(3.0));
  const auto expect = [](const Points& ring, double distance, double worst_angle, bool is_in_cone) {
    const auto normal = most_normal(ring);
    ASSERT_TRUE(normal);
    EXPECT_NEAR(normal->min_distance, distance, 1e-15);
    EXPECT_EQ(normal->in_visibility_cone, is_in_cone);
    EXPECT_NEAR(most_visible(ring)->max_angle, worst_angle, 1e-15);
  };
  expect(kConcaveBox, diagonal, kRightAngle - diagonal, true);               // 35.264 degrees
  expect(kConvexBox, kRightAngle + diagonal, kRightAngle - diagonal, true);  // 125.264
  expect({{1, 0, -1}, {0, 1, -1}, {-1, 0, -1}, {0, -1, -1}}, 0.75 * kPi, std::acos(std::sqrt(1.0 / 3)), true);  // 135
  expect(kBlockOnFloor, 0.25 * kPi, kRightAngle - diagonal, true);                                              // 45
  expect(kBlockOnFloorReversed, kRightAngle, kRightAngle - diagonal, false);                                    // 90
}

TEST(MostNormalNormal, IsTheMostVisibleOneAtConvexPyramids) {
  const Points ring = {{1, 0, -1}, {0, 1, -1}, {-1, 0, -1}, {0, -1, -1}};
  EXPECT_NEAR(distance(most_normal(ring)->direction, most_visible(ring)->direction), 0, 1e-15);
}

TEST(MostNormalNormal, TakesTheEndNearestToTheMostVisibleOneOfACurveOfMaximisers) {
  // At a block on a floor all directions at 45 degrees to the floor and far enough from the block's ridges are equally
  // far; the most visible normal looks away from the block's vertical ridge, over the curve's middle.
  Random random(1);
  const auto normal = most_normal(kBlockOnFloor);
  EXPECT_NEAR(distance(normal->direction, Vec3(-0.5, -0.5, std::sqrt(0.5))), 0, 1e-15);
  const Vec3 visible = most_visible(kBlockOnFloor)->direction;
  const rings::Arcs arcs(kBlockOnFloor, visible);
  int n_as_far = 0;
  for (int i = 0; i < 3600; ++i) {
    const double turn = geometry::to_radians(0.1 * i);
    const Vec3 x(std::cos(turn) * std::sqrt(0.5), std::sin(turn) * std::sqrt(0.5), std::sqrt(0.5));
    if (arcs.value(fans::to_long(x)) < 0.25L * std::numbers::pi_v<long double> - 1e-12L) continue;
    ++n_as_far;
    EXPECT_GE(distance(x, visible), distance(normal->direction, visible) - 1e-12);
  }
  EXPECT_GT(n_as_far, 600);
}

TEST(MostNormalNormal, TakesTheNearestOfNearlyAsGoodOnesAtABlockSlightlyOut) {
  const Points ring = {{-0x1.97cc0e99dc6d1p-1, -0x1.6f94d497a69c7p-3, 0x1.27a2df2712b15p-1},
                       {-0x1.0508f240df194p-3, 0x1.f7744b7c2c234p-1, 0x1.09e7a7793e3d2p-3},
                       {0x1.dabfb34d0f548p-2, 0x1.e8304fe5eecbcp-1, 0x1.df2dff3b97702p-1},
                       {0x1.2ea21635b5eafp-1, -0x1.e87f72b517c5fp-6, 0x1.9cb4155bec2b6p-1},
                       {0x1.97cc0e9a409e2p-1, 0x1.6f94d49ea016bp-3, -0x1.27a2df2654a87p-1},
                       {-0x1.2ea2163679968p-1, 0x1.e87f72d2ecd73p-6, -0x1.9cb4155c9117fp-1}};
  const auto normal = most_normal(ring);
  ASSERT_TRUE(normal);
  const Vec3 visible = most_visible(ring)->direction;
  const rings::Arcs arcs(ring, visible);
  const Vec3 a = normalized(ring[0]), floor = normalized(cross(ring[4], ring[5])), b = cross(floor, a);
  double nearest = 4;
  int n_as_far = 0;
  for (int k = 0; k < 40 * 720; ++k) {
    const double turn = geometry::to_radians(0.5 * (k / 40)), rise = kPi / 4 + 1e-11 * (k % 40 - 20);
    const Vec3 x = (a * std::cos(turn) + b * std::sin(turn)) * std::cos(rise) + floor * std::sin(rise);
    if (arcs.value(fans::to_long(x)) < normal->min_distance) continue;
    ++n_as_far;
    nearest = std::min(nearest, distance(x, visible));
  }
  EXPECT_GT(n_as_far, 100);
  EXPECT_LE(distance(normal->direction, visible), nearest + 1e-6);
}

TEST(MostNormalNormal, TakesTheNearestOfAllThatIsSquareToOppositeNeighbours) {
  const Points ring = {{-0x1.e5eaca5074dd8p-4, 0x1.9b31501ee3049p+0, -0x1.5c569b162634cp+1},
                       {0x1.ec5397fbdcefcp+1, 0x1.c52d0d6c0b80fp-1, -0x1.d99a79e89c0cp+0},
                       {0x1.8f220ed59269p+1, 0x1.2854b3a92919p-6, -0x1.5946a2626269cp+1},
                       {0x1.b943f3e5edc23p+1, -0x1.36865ac25c288p+1, -0x1.eb46f9b90a418p-2},
                       {0x1.448bf9e8fb24ap+0, -0x1.351ac6503ae52p+1, 0x1.47de50ae7072p+1},
                       {0x1.e5eaca5074dd8p-4, -0x1.9b31501ee3049p+0, 0x1.5c569b162634cp+1},
                       {0x1.b1837de338b7p-1, -0x1.7a78386f03d1p-1, 0x1.c8d000843a988p+1},
                       {-0x1.d7f0094711ac2p+0, 0x1.f06fbe4f43423p+0, 0x1.f5b7fd87a46a8p+0},
                       {-0x1.510f2882dac9cp-2, 0x1.38d70429ae7abp+1, -0x1.1bddc32b41218p+1}};
  const Vec3 ridge = ring[0];
  const auto normal = most_normal(ring);
  ASSERT_TRUE(normal);
  EXPECT_NEAR(normal->min_distance, kRightAngle, 1e-10);
  const Vec3 visible = most_visible(ring)->direction;
  const rings::Arcs arcs(ring, visible);
  const Vec3 a = normalized(cross(ridge, {1, 0, 0})), b = normalized(cross(ridge, a));
  int n_as_far = 0;
  for (int k = 0; k < 3600; ++k) {
    const double turn = geometry::to_radians(0.1 * k);
    const Vec3 x = a * std::cos(turn) + b * std::sin(turn);
    if (arcs.value(fans::to_long(x)) < kRightAngle - 1e-12) continue;
    ++n_as_far;
    EXPECT_LE(distance(normal->direction, visible), distance(x, visible) + 1e-12);
  }
  EXPECT_GT(n_as_far, 100);
}

TEST(MostNormalNormal, IsTheMostVisibleOneOnARidgeAndAFlat) {
  // Nothing is farther than a right angle from both ends of a straight ridge, and all that is square to it is as far.
  const Points ridge = {{1, 0, 0}, {0, 1, -1}, {-1, 0, 0}, {0, -1, -1}};
  EXPECT_NEAR(most_normal(ridge)->min_distance, kRightAngle, 1e-15);
  EXPECT_NEAR(distance(most_normal(ridge)->direction, Vec3(0, 0, 1)), 0, 1e-15);
  for (int n = 3; n <= 12; ++n) {
    std::vector<rings::Polar> flat;
    for (int i = 0; i < n; ++i) flat.push_back({2 * kPi * i / n, kRightAngle});
    const Points ring = rings::ring_of(flat, {0, 0, 1}, {1, 0, 0});
    EXPECT_NEAR(most_normal(ring)->min_distance, kRightAngle, 1e-15) << n;
    EXPECT_NEAR(distance(most_normal(ring)->direction, Vec3(0, 0, 1)), 0, 1e-15) << n;
  }
}

TEST(MostNormalNormal, LooksAlongTheAxisOfRegularPyramids) {
  Random random(2);
  for (int n = 3; n <= 12; ++n) {
    for (const double polar : {0.1, 0.7, 1.5, 1.7, 2.4, 3.0}) {
      std::vector<rings::Polar> polars;
      for (int i = 0; i < n; ++i) polars.push_back({2 * kPi * i / n, polar});
      const Vec3 axis = random.direction();
      const auto normal = most_normal(rings::ring_of(polars, axis, random.direction()));
      ASSERT_TRUE(normal);
      // To the middle of the arcs where the edges rise, to the edges where they fall.
      const double expected = polar > kRightAngle ? polar : std::atan(std::tan(polar) * std::cos(kPi / n));
      EXPECT_NEAR(normal->min_distance, expected, 2e-15) << n << ' ' << polar;
      EXPECT_NEAR(distance(normal->direction, axis), 0, 1e-14) << n << ' ' << polar;
      EXPECT_TRUE(normal->in_visibility_cone);
    }
  }
}

TEST(MostNormalNormal, IsNoneWhereNothingSeesAllFaces) {
  EXPECT_FALSE(most_normal({}));
  EXPECT_FALSE(most_normal({{1, 0, 0}, {0, 1, 0}}));
  const Points star = {{1, 0, 0}, {0, 1, 0.1}, {-1, 0, -0.2}, {0, -1, 0.3}, {0.5, -0.5, 1}};
  ASSERT_TRUE(most_normal(star));
  EXPECT_FALSE(most_normal({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}}));
  // Opposite neighbours span no face, and a neighbour in the apex spans none with either of its own.
  EXPECT_FALSE(most_normal({{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}));
  EXPECT_FALSE(most_normal({{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}}));
}

TEST(MostNormalNormal, IsNoneWhereOnlyRoundedNormalsLeaveACone) {
  // In fractions of these numbers zero is in the hull of the faces' normals, by less than their rounding.
  const std::vector<Vec3> ring = {{0x1.99feeb659b5a0p-4, -0x1.fd6d7bd018abfp-1, 0x1.f06f35e7bf400p-10},
                                  {0x1.81ecfde895852p-3, 0x1.5537b8d67f280p-6, 0x1.f6b6da0721218p-1},
                                  {0x1.f435729f231b1p-1, 0x1.91192b98101c0p-4, -0x1.8441944dc3dd3p-3},
                                  {0x1.e2c2d8aec5bf6p-1, 0x1.1a663f225a3c2p-2, -0x1.7e9684a230066p-3},
                                  {0x1.dd6688ec4a99ap-1, 0x1.3d8cb9531ae6ap-2, -0x1.7bf6bfbf01658p-3},
                                  {-0x1.ec160c884caabp-3, -0x1.efd3de8b660bep-1, 0x1.1104e95acee0cp-4},
                                  {-0x1.ff52be973ec40p-7, -0x1.ffc9a8fd99a57p-1, 0x1.8c7170c95bfc6p-6}};
  EXPECT_FALSE(most_normal_normal({0, 0, 0}, ring));
}

TEST(MostNormalNormal, IsNoneForRingsThatDoNotGoRoundOnce) {
  Points twice;
  for (int i = 0; i < 10; ++i) {
    const double turn = 4 * kPi * i / 10, height = 0.2 * std::sin(0.5 * turn);
    twice.emplace_back(std::cos(turn), std::sin(turn), height);
  }
  ASSERT_TRUE(most_visible(twice));
  EXPECT_FALSE(most_normal(twice));
}

TEST(MostNormalNormal, RefusesWhatIsNotFinite) {
  EXPECT_THROW(most_normal({{1, 0, 0}, {0, kInfinity, 0}, {0, 0, 1}}), InputError);
  EXPECT_THROW(most_normal({{1, 0, 0}, {0, std::nan(""), 0}}), InputError);
  EXPECT_THROW(most_normal_normal({0, kInfinity, 0}, kConcaveBox), InputError);
}

TEST(MostNormalNormal, PassesOverFacesWithoutArea) {
  const Points doubled = {{1, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1}, {0, 0, 1}, {4, 0, 0}};
  EXPECT_EQ(most_normal(doubled)->direction, most_normal(kConcaveBox)->direction);
}

TEST(MostNormalNormal, EndsWhereNeighboursAreOppositeButForRounding) {
  // Nothing is farther from both than a right angle, and rounding raised the best distance again and again.
  const Points ring = {
      {0, 3, -1}, {0, 3, -1.28}, {0.4, 3, -2}, {0x1.ae35ea8b77e1ep-3, -0x1.96c445468fcb2p-2, -0x1.c9658722c490cp-1},
      {1, 0, -1}, {0.6, -1, 1},  {1, 0, 1},    {-0x1.ae35ea8b77e1cp-3, 0x1.96c445468fcb2p-2, 0x1.c9658722c490cp-1}};
  ASSERT_TRUE(most_normal(ring));
  EXPECT_NEAR(most_normal(ring)->min_distance, kRightAngle, 1e-9);
  const Points original = {
      {0x1.329f27d64a898p-3, 0x1.8e01d8ab1a273p+1, -0x1.1c9e83d45fd36p-1},
      {0x1.c1026dc0f9860p-6, 0x1.7225d61896d64p+1, -0x1.4786a0c889d25p+0},
      {0x1.c984044bf17dcp-2, 0x1.4619b00c62fd7p+1, -0x1.d1bce2941e602p+0},
      {0x1.ae35ea8b77e1ep-3, -0x1.96c445468fcb2p-2, -0x1.c9658722c490cp-1},
      {0x1.1eabbff423070p+0, 0x1.d56a49aaa9bbep-2, -0x1.76ce5574cd58fp-1},
      {0x1.36f79180e48c2p-1, -0x1.1b9c8a50be4dep+0, 0x1.4556d4ec7d0e8p-1},
      {0x1.02bd754069c59p-1, 0x1.069a95bf0898dp-3, 0x1.b4e822315adefp-1},
      {-0x1.ae35ea8b77e1cp-3, 0x1.96c445468fcb2p-2, 0x1.c9658722c490cp-1},
  };
  const auto normal = most_normal(original);
  ASSERT_TRUE(normal);
  Random random(6);
  const rings::Arcs arcs(original, most_visible(original)->direction);
  EXPECT_LE(static_cast<double>(arcs.best(random, 60, 6).second), normal->min_distance + 1e-9);
}

TEST(MostNormalNormal, KeepsItsDigitsWhereNeighboursAreNearlyOpposite) {
  // A ridge or valley along p, bent by very little: the face between p and q = -p + bend d has the normal p x d.
  const Vec3 p(3, 1, 2), d(0, 1, -1);
  const auto expect = [&](const Vec3& apex, const Vec3& r, double bend, const Vec3& turned) {
    const Vec3 q = d * bend - p;
    const auto normal = most_normal_normal(apex, Points{apex + p, apex + q, apex + r});
    ASSERT_TRUE(normal) << bend;
    const auto visible = most_visible_normal(Points{cross(p, turned), cross(q, r), cross(r, p)});
    // Nowhere reflex: the nearest face is one whose plane is seen worst.
    EXPECT_NEAR(normal->min_distance, kRightAngle - visible->max_angle, 1e-14) << bend;
    EXPECT_NEAR(distance(normal->direction, visible->direction), 0, 1e-14) << bend;
  };
  for (const int exponent : {-10, -20, -30, -40}) {
    expect({0, 0, 0}, {-1, 1, 2}, std::ldexp(1, exponent), d);
    expect({1000, -500, 250}, {-1, 1, 2}, std::ldexp(1, exponent), d);
  }
  expect({0, 0, 0}, {-1, 1, 2}, 0x1p-50, d);
  // An apex so near the origin that edges are not doubles: (p - a) x (q - a) = p x (bend d - 2 a), but for a * bend.
  const Vec3 w(1, -1, 2);
  expect(w * 0x1p-56, {-1, 1, 2}, 0x1p-50, d - w * 0x1p-5);
}

TEST(MostNormalNormal, GoesRoundOnceWhereNeighboursAreOppositeToTheLastDigit) {
  const Points ring = {{0x1.34f302f2935f9p+103, -0x1.7a8d75f178216p+102, -0x1.b8d2c133439ddp+102},
                       {0x1.1ccdcc15fe512p+299, -0x1.1782c5d1641b2p+299, -0x1.d21a910159069p+298},
                       {0x1.26f2ea17d8b21p+48, -0x1.158f1b42f1cb9p+49, -0x1.3ce53c2183723p+48},
                       {-0x1.759887dbf1a68p-98, -0x1.635366bf6f161p-98, 0x1.919cf47aa3604p-100},
                       {-0x1.b49b4390fac48p+327, -0x1.e0f950c201d5bp+326, 0x1.4e121ec9b9e5fp+326},
                       {-0x1.dc9daba6abee8p-290, 0x1.23ff17a356f84p-290, 0x1.540767f790239p-290}};
  const auto normal = most_normal(ring);
  ASSERT_TRUE(normal);
  EXPECT_TRUE(normal->in_visibility_cone);
}

TEST(MostNormalNormal, StaysInHolesAsThinAsNeedles) {
  Random random(8);
  int n_found = 0;
  for (int i = 0; i < 200; ++i) {
    const double width = std::pow(10, random.uniform(-8.5, -7));
    const Points ring = rings::star(random, 40, [&](int) { return width * random.uniform(0.3, 1); });
    const auto normal = most_normal(ring);
    if (!normal) continue;  // rounding of the points has closed the thinnest cones
    ++n_found;
    EXPECT_LT(normal->min_distance, width) << i;
  }
  EXPECT_GT(n_found, 150);
}

TEST(MostNormalNormal, EndsSoonInLargeStarsAllOfWhoseTipsAreAsNear) {
  for (const int n : {64, 1000}) {
    std::vector<rings::Polar> polars;
    for (int i = 0; i < n; ++i) polars.push_back({2 * kPi * i / n, i % 2 == 0 ? 0.4 : 2.6});
    const auto normal = most_normal(rings::ring_of(polars, {0, 0, 1}, {1, 0, 0}));
    ASSERT_TRUE(normal);
    EXPECT_NEAR(normal->min_distance, 0.4, 1e-15);
    EXPECT_NEAR(distance(normal->direction, {0, 0, 1}), 0, 1e-15);
  }
}

/// One kind of ring, from mild to wild.
struct Kind {
  const char* name;
  Points (*make)(Random&, int n);
};

double power(Random& random, double low, double high) { return std::pow(10, random.uniform(low, high)); }

const Kind kKinds[] = {
    {"mild", [](Random& r, int n) { return rings::star(r, n, [&](int) { return r.uniform(1.2, 1.9); }); }},
    {"wild", [](Random& r, int n) { return rings::star(r, n, [&](int) { return r.uniform(0.05, 3.0); }); }},
    {"concave", [](Random& r, int n) { return rings::star(r, n, [&](int) { return r.uniform(0.6, 1.5); }); }},
    {"nearly_flat",
     [](Random& r, int n) {
       const double height = power(r, -8, -2);
       return rings::star(r, n, [&](int) { return kRightAngle + height * r.uniform(-1, 1); });
     }},
    {"nearly_closed",
     [](Random& r, int n) {
       const double width = power(r, -6, -1);
       return rings::star(r, n, [&](int) { return width * r.uniform(0.3, 1); });
     }},
    {"spike",
     [](Random& r, int n) {
       const double width = power(r, -6, -1);
       return rings::star(r, n, [&](int) { return kPi - width * r.uniform(0.3, 1); });
     }},
    {"half_spike",
     [](Random& r, int n) {
       const double width = power(r, -6, -1);
       return rings::star(r, n, [&](int i) { return i % 2 == 0 ? kPi - width : r.uniform(0.5, 2.5); });
     }},
    {"alternating",
     [](Random& r, int n) {
       const double low = r.uniform(0.1, 1.5), high = r.uniform(1.5, 2.9);
       return rings::star(r, n, [&](int i) { return i % 2 == 0 ? low : high; });
     }},
    {"nearly_round",
     [](Random& r, int n) {
       const double noise = power(r, -12, -2), polar = r.uniform(0.3, 2.5);
       return rings::star(r, n, [&](int) { return polar + noise * r.uniform(-1, 1); });
     }},
    {"regular_star",
     [](Random& r, int n) {
       const double low = r.uniform(0.2, 2.8), high = r.uniform(0.2, 2.8);
       std::vector<rings::Polar> polars;
       for (int i = 0; i < n + n % 2; ++i) polars.push_back({2 * kPi * i / (n + n % 2), i % 2 == 0 ? low : high});
       return rings::ring_of(polars, r.direction(), r.direction());
     }},
    {"split_faces",
     [](Random& r, int n) { return rings::split(r, rings::star(r, n, [&](int) { return r.uniform(0.4, 2.7); })); }},
    {"trailing_edge", [](Random& r, int n) { return rings::trailing_edge(r, n, power(r, -6, -0.5)); }},
    {"blocks", [](Random& r, int n) { return rings::turned(r, rings::of_blocks(r, n)); }},
};

class MostNormalNormalOf : public testing::TestWithParam<Kind> {};

TEST_P(MostNormalNormalOf, IsAsFarAsAnySearchFindsAndNoNearerThanItSays) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Points ring = GetParam().make(random, random.integer(3, i % 4 == 0 ? 24 : 9));
    const auto normal = most_normal(ring);
    ASSERT_TRUE(normal) << i;
    EXPECT_NEAR(norm(normal->direction), 1, 1e-15) << i;
    const rings::Arcs arcs(ring, most_visible(ring)->direction);
    const fans::Long x = fans::to_long(normal->direction);
    EXPECT_NEAR(static_cast<double>(arcs.value(x)), normal->min_distance, 5e-14) << i;
    EXPECT_LE(static_cast<double>(arcs.best(random, 40, 4).second), normal->min_distance + 2e-10) << i;
    for (const long double radius : {1e-2L, 1e-5L, 1e-8L}) {
      EXPECT_LE(static_cast<double>(arcs.best_near(x, radius, 48)), normal->min_distance + 1.1e-10)
          << i << ' ' << radius;
    }
  }
}

TEST_P(MostNormalNormalOf, DependsNeitherOnTheStartOfTheRingNorOnTheScale) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    Points ring = GetParam().make(random, random.integer(3, 12));
    const auto normal = most_normal(ring);
    ASSERT_TRUE(normal);
    Points scaled, cycled;
    for (const Vec3& p : ring) scaled.push_back(p * 0x1p-400), cycled.emplace_back(p.y(), p.z(), p.x());
    const Vec3 d = normal->direction;
    EXPECT_EQ(most_normal(scaled)->direction, d);
    EXPECT_EQ(most_normal(scaled)->min_distance, normal->min_distance);
    EXPECT_NEAR(most_normal(cycled)->min_distance, normal->min_distance, 1e-13);
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2), ring.end());
    EXPECT_NEAR(most_normal(ring)->min_distance, normal->min_distance, 1.1e-10);
  }
}

TEST_P(MostNormalNormalOf, IsNoneForTheRingReversedUnlessThatHasAFluidOfItsOwn) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    Points ring = GetParam().make(random, random.integer(3, 12));
    std::reverse(ring.begin(), ring.end());
    EXPECT_EQ(most_normal(ring).has_value(), most_visible(ring).has_value());
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, MostNormalNormalOf, testing::ValuesIn(kKinds),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

}  // namespace
}  // namespace nearwall::surface

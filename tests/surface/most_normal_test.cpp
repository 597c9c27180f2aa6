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

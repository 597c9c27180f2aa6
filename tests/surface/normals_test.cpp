#include "nearwall/surface/normals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/predicates/orientation.h"
#include "tests/support/shapes.h"
#include "tests/surface/fans.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;
using fans::Random;

constexpr double kPi = std::numbers::pi;
constexpr double kRightAngle = kPi / 2;

bool sees(const Vec3& direction, const std::vector<Vec3>& normals) {
  return std::all_of(normals.begin(), normals.end(), [&](const Vec3& n) {
    return predicates::sign_of_dot(n, direction) == predicates::Sign::Positive;
  });
}

TEST(MostVisibleNormal, LooksAlongTheDiagonalOfACubesCorner) {
  const auto normal = most_visible_normal(std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  ASSERT_TRUE(normal);
  EXPECT_NEAR(geometry::to_degrees(normal->max_angle), 54.735610317245346, 1e-13);
  EXPECT_NEAR(distance(normal->direction, Vec3(1, 1, 1) / std::sqrt(3.0)), 0, 1e-15);
}

TEST(MostVisibleNormal, HalvesATrailingEdgeWhateverTheNumberOfFacesOnItsSides) {
  for (const double opening : {1.0, 0.1, 1e-3, 1e-6, 1e-9}) {
    const double half = opening / 2;
    std::vector<Vec3> normals(4, {-std::sin(half), std::cos(half), 0});
    normals.insert(normals.end(), 3, {-std::sin(half), -std::cos(half), 0});
    const auto normal = most_visible_normal(normals);
    ASSERT_TRUE(normal) << opening;
    EXPECT_NEAR(normal->max_angle, kRightAngle - half, 1e-15) << opening;
    EXPECT_TRUE(sees(normal->direction, normals)) << opening;
  }
}

TEST(MostVisibleNormal, LooksAlongTheAxisOfASquarePyramid) {
  for (const double slope : {1e-9, 0.3, 1.0, 1.57}) {
    const double s = std::sin(slope), c = std::cos(slope);
    const auto normal = most_visible_normal(std::vector<Vec3>{{s, 0, c}, {0, s, c}, {-s, 0, c}, {0, -s, c}});
    ASSERT_TRUE(normal) << slope;
    EXPECT_NEAR(normal->max_angle, slope, 2e-16) << slope;
  }
}

TEST(MostVisibleNormal, IsTheNormalOfASingleFaceOrOfEqualOnes) {
  for (const std::size_t n : {1, 2, 7}) {
    const auto normal = most_visible_normal(std::vector<Vec3>(n, Vec3(0, -3, 4)));
    ASSERT_TRUE(normal);
    EXPECT_NEAR(distance(normal->direction, {0, -0.6, 0.8}), 0, 1e-15);
    EXPECT_LE(normal->max_angle, 1e-15);
  }
}

TEST(MostVisibleNormal, PassesOverZeroVectors) {
  const auto normal = most_visible_normal(std::vector<Vec3>{{0, 0, 0}, {0, 2, 0}, {0, 0, 0}});
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal->direction, Vec3(0, 1, 0));
}

TEST(MostVisibleNormal, IsNoneWithoutNormals) {
  EXPECT_FALSE(most_visible_normal({}));
  EXPECT_FALSE(most_visible_normal(std::vector<Vec3>{{0, 0, 0}}));
}

TEST(MostVisibleNormal, IsNoneForARegularTetrahedronThoughEachTripleHasACone) {
  const std::vector<Vec3> normals = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_FALSE(most_visible_normal(normals));
  EXPECT_TRUE(most_visible_normal(std::span(normals).first(3)));
}

TEST(MostVisibleNormal, IsNoneForOppositeFaces) {
  EXPECT_FALSE(most_visible_normal(std::vector<Vec3>{{1, 2, 3}, {-2, -4, -6}}));
  EXPECT_FALSE(most_visible_normal(std::vector<Vec3>{{0.1, 0.2, 0.3}, {0, 0, 1}, {-0.1, -0.2, -0.3}}));
}

TEST(MostVisibleNormal, RefusesWhatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(most_visible_normal(std::vector<Vec3>{{1, 0, 0}, {0, infinity, 0}}), InputError);
  EXPECT_THROW(most_visible_normal(std::vector<Vec3>{{1, std::nan(""), 0}}), InputError);
}

TEST(MostVisibleNormal, ExistsExactlyIfZeroIsNotInTheHull) {
  Random random(1);
  int n_none = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<fans::Whole> whole;
    std::vector<Vec3> normals;
    const int n = random.integer(2, 7), bound = random.integer(1, 3);
    while (static_cast<int>(normals.size()) < n) {
      const fans::Whole a = {random.integer(-bound, bound), random.integer(-bound, bound), random.integer(-1, bound)};
      if (a == fans::Whole{}) continue;
      whole.push_back(a);
      normals.emplace_back(static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2]));
    }
    const auto normal = most_visible_normal(normals);
    const bool is_none = fans::hull_holds_zero(whole);
    ASSERT_EQ(!normal, is_none) << trial;
    ASSERT_TRUE(!normal || sees(normal->direction, normals)) << trial;
    n_none += is_none;
  }
  EXPECT_GT(n_none, 4000);
  EXPECT_LT(n_none, 16000);
}

TEST(MostVisibleNormal, ExistsExactlyInConesFarThinnerThanRounding) {
  // The three add up to (0, 0, a + b + c), zero or not: a direction sees all if and only if it is not.
  for (const double t : {1e-10, 1e-17, 0x1p-200, 0x1p-1000}) {
    const auto normals = [&](double a, double b, double c) {
      return std::vector<Vec3>{{2, 0, a * t}, {-1, 1, b * t}, {-1, -1, c * t}};
    };
    EXPECT_TRUE(most_visible_normal(normals(1, 1, 1))) << t;
    EXPECT_TRUE(most_visible_normal(normals(5, -2, -2))) << t;
    EXPECT_FALSE(most_visible_normal(normals(4, -2, -2))) << t;
    EXPECT_TRUE(most_visible_normal(normals(3, -2, -2))) << t;
    const auto up = most_visible_normal(normals(1, 1, 1));
    EXPECT_LT(up->max_angle, kRightAngle);
    EXPECT_TRUE(sees(up->direction, normals(1, 1, 1))) << t;
  }
}

struct Family {
  std::string name;
  std::function<std::vector<Vec3>(Random&, int n)> make;
};
void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

double opening(Random& random) { return std::pow(10.0, random.uniform(-6, -0.5)); }

const std::vector<Family> kFamilies = {
    {"Anywhere",
     [](Random& r, int n) {
       return fans::round_axis(
           r, n, [&](int) { return r.uniform(0, 1.8); }, [&](int) { return r.uniform(0, 2 * kPi); });
     }},
    {"NearAGreatCircle",
     [](Random& r, int n) {
       const double open = opening(r);
       return fans::round_axis(
           r, n, [&](int) { return kRightAngle - open * r.uniform(0.1, 1); },
           [&](int) { return r.uniform(0, 2 * kPi); });
     }},
    {"OnOneCircle",
     [](Random& r, int n) {
       const double polar = kRightAngle - opening(r);
       return fans::round_axis(
           r, n, [&](int) { return polar; }, [&](int) { return r.uniform(0, 2 * kPi); });
     }},
    {"RegularPolygon",
     [](Random& r, int n) {
       const double polar = kRightAngle - opening(r);
       return fans::round_axis(
           r, n, [&](int) { return polar; }, [&](int i) { return 2 * kPi * i / n; });
     }},
    {"NearlyCoplanar",
     [](Random& r, int n) {
       const double size = std::pow(10.0, r.uniform(-9, -1));
       return fans::round_axis(
           r, n, [&](int) { return size * r.uniform(0, 1); }, [&](int) { return r.uniform(0, 2 * kPi); });
     }},
    {"TrailingEdge",
     [](Random& r, int n) {
       const double polar = kRightAngle - opening(r), spread = std::pow(10.0, r.uniform(-12, -3));
       return fans::round_axis(
           r, n, [&](int) { return polar; }, [&](int i) { return kPi * (i % 7 >= 4) + spread * r.uniform(-1, 1); });
     }},
    {"ThreeBundles",
     [](Random& r, int n) {
       const double spread = std::pow(10.0, r.uniform(-12, -2));
       return fans::round_axis(
           r, n, [&](int) { return kRightAngle - 1e-6; },
           [&](int i) { return 2 * kPi / 3 * (i % 3) + spread * r.uniform(-1, 1); });
     }},
    {"ManyDuplicates",
     [](Random& r, int n) {
       auto normals = fans::round_axis(
           r, n, [&](int) { return r.uniform(0.3, 1.5); }, [&](int) { return r.uniform(0, 2 * kPi); });
       for (std::size_t i = 3; i < normals.size(); ++i) normals[i] = normals[i % 3] * r.integer(1, 3);
       return normals;
     }},
};

class MostVisibleNormalOfFans : public testing::TestWithParam<Family> {};

TEST_P(MostVisibleNormalOfFans, IsAsGoodAsTheBestOfAllPairsAndTriples) {
  Random random(2);
  for (int trial = 0; trial < 400; ++trial) {
    const std::vector<Vec3> normals = GetParam().make(random, trial % 100 == 99 ? 64 : 3 + trial % 18);
    const long double best = fans::smallest_worst_angle(normals);
    const auto normal = most_visible_normal(normals);
    if (!normal) {
      EXPECT_GT(best, kRightAngle - 1e-14) << trial;
      continue;
    }
    const long double reached = fans::worst_angle(fans::to_long(normal->direction), normals);
    EXPECT_LT(reached, best + 1e-14L) << trial << ", best " << best;
    EXPECT_NEAR(static_cast<double>(reached), normal->max_angle, 2e-15) << trial;
    EXPECT_NEAR(norm(normal->direction), 1, 5e-16);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MostVisibleNormalOfFans, testing::ValuesIn(kFamilies),
                         [](const auto& family) { return family.param.name; });

TEST(MostVisibleNormal, IsTheSameBitsOnPermutedAxesAndScaledVectors) {
  Random random(3);
  for (const Family& family : kFamilies) {
    for (int trial = 0; trial < 60; ++trial) {
      std::vector<Vec3> normals = family.make(random, 3 + trial % 12);
      const auto normal = most_visible_normal(normals);
      if (!normal) continue;
      std::array<int, 3> axis = {0, 1, 2};
      do {
        std::vector<Vec3> permuted;
        for (const Vec3& n : normals) {
          permuted.push_back(Vec3(n[axis[0]], n[axis[1]], n[axis[2]]) * std::ldexp(1.0, random.integer(-300, 300)));
        }
        const auto other = most_visible_normal(permuted);
        ASSERT_TRUE(other);
        const Vec3& d = normal->direction;
        ASSERT_EQ(other->direction, Vec3(d[axis[0]], d[axis[1]], d[axis[2]])) << family.name << trial;
        ASSERT_EQ(other->max_angle, normal->max_angle);
      } while (std::next_permutation(axis.begin(), axis.end()));
    }
  }
}

TEST(MostVisibleNormal, DoesNotDependOnTheOrderOfTheFaces) {
  Random random(4);
  for (const Family& family : kFamilies) {
    std::vector<Vec3> normals = family.make(random, 9);
    const auto normal = most_visible_normal(normals);
    for (int turn = 0; turn < 9 && normal; ++turn) {
      std::rotate(normals.begin(), normals.begin() + 2, normals.end());
      const auto other = most_visible_normal(normals);
      ASSERT_TRUE(other) << family.name;
      EXPECT_NEAR(other->max_angle, normal->max_angle, 2e-15) << family.name;
    }
  }
}

TEST(MostVisibleNormal, HoldsForTheTipOfAConeOfTenThousandFaces) {
  std::vector<Vec3> normals;
  for (int i = 0; i < 10000; ++i) {
    const double azimuth = 2 * kPi * i / 10000;
    normals.emplace_back(0.96 * std::cos(azimuth), 0.96 * std::sin(azimuth), 0.28);
  }
  const auto normal = most_visible_normal(normals);
  ASSERT_TRUE(normal);
  EXPECT_NEAR(normal->max_angle, std::acos(0.28), 1e-14);
  EXPECT_NEAR(distance(normal->direction, {0, 0, 1}), 0, 1e-14);
}

}  // namespace
}  // namespace nearwall::surface

#include "nearwall/surface/iterative_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "nearwall/core/errors.h"
#include "nearwall/predicates/orientation.h"
#include "tests/surface/fans.h"

namespace nearwall::surface {
namespace {

using fans::Random;
using geometry::to_degrees;
using geometry::to_radians;

constexpr double kPi = std::numbers::pi;
constexpr double kRightAngle = kPi / 2;

bool sees(const Vec3& direction, const std::vector<Vec3>& normals) {
  return std::all_of(normals.begin(), normals.end(), [&](const Vec3& n) {
    return predicates::sign_of_dot(n, direction) == predicates::Sign::Positive;
  });
}

/// Four faces above and three below a wing, their normals at the angle `half` from the middle.
std::vector<Vec3> trailing_edge(double half) {
  std::vector<Vec3> normals(4, {std::cos(half), std::sin(half), 0});
  normals.insert(normals.end(), 3, {std::cos(half), -std::sin(half), 0});
  return normals;
}

/// tan(a) / a: how far the mean of two normals turns if their weights follow the angles.
double gain(double half) { return std::tan(half) / half; }

std::vector<Vec3> scattered(Random& random, int n, double widest) {
  return fans::round_axis(
      random, n, [&](int) { return widest * std::sqrt(random.uniform(0, 1)); },
      [&](int) { return random.uniform(0, 2 * kPi); });
}

TEST(KallinderisNormal, IsTheMostVisibleOneOfTwoFaces) {
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Vec3> normals = {random.direction(), random.direction() * 7.0};
    const auto normal = kallinderis_normal(normals);
    ASSERT_TRUE(normal);
    EXPECT_NEAR(normal->max_angle, most_visible_normal(normals)->max_angle, 1e-15);
  }
}

TEST(KallinderisNormal, LooksAlongTheAxisOfASquarePyramid) {
  for (const double slope : {1e-9, 0.3, 1.0, 1.57}) {
    const double s = std::sin(slope), c = std::cos(slope);
    const auto normal = kallinderis_normal(std::vector<Vec3>{{s, 0, c}, {0, s, c}, {-s, 0, c}, {0, -s, c}});
    ASSERT_TRUE(normal) << slope;
    EXPECT_NEAR(normal->max_angle, slope, 3e-16) << slope;
  }
}

TEST(KallinderisNormal, MissesTheBestOneAtACubesCorner) {
  // The plane x = y: z restricts it to the directions between z and the middle of x and y.
  const auto normal = kallinderis_normal(std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  ASSERT_TRUE(normal);
  EXPECT_NEAR(distance(normal->direction, {0.5, 0.5, std::sqrt(0.5)}), 0, 1e-15);
  EXPECT_NEAR(to_degrees(normal->max_angle), 60, 1e-13);
}

TEST(KallinderisNormal, HalvesATrailingEdge) {
  for (const double opening : {1.0, 0.1, 1e-3, 1e-6, 1e-9}) {
    const auto normal = kallinderis_normal(trailing_edge(kRightAngle - opening / 2));
    ASSERT_TRUE(normal) << opening;
    EXPECT_NEAR(normal->max_angle, kRightAngle - opening / 2, 1e-15) << opening;
  }
}

TEST(KallinderisNormal, IsTheNormalOfASingleFaceOrOfEqualOnes) {
  for (const std::size_t n : {1, 2, 30}) {
    const auto normal = kallinderis_normal(std::vector<Vec3>(n, Vec3(0, -3, 4)));
    ASSERT_TRUE(normal);
    EXPECT_NEAR(distance(normal->direction, {0, -0.6, 0.8}), 0, 1e-15);
  }
}

TEST(KallinderisNormal, IsNoneWhereOnlyDirectionsOutsideItsPlaneSeeAllFaces) {
  const double wide = to_radians(85), side = std::sqrt(0.75);
  const auto leaning = [&](double angle) { return Vec3(0.5, side * std::sin(angle), side * std::cos(angle)); };
  const std::vector<Vec3> normals = {{std::sin(wide), 0, std::cos(wide)},
                                     {-std::sin(wide), 0, std::cos(wide)},
                                     leaning(to_radians(92)),
                                     leaning(to_radians(-89))};
  EXPECT_TRUE(sees({0.07, 0, 1}, normals));
  EXPECT_FALSE(kallinderis_normal(normals));
}

TEST(KallinderisNormal, IsNoneWhereNothingSeesAllFaces) {
  EXPECT_FALSE(kallinderis_normal({}));
  EXPECT_FALSE(kallinderis_normal(std::vector<Vec3>{{0, 0, 0}}));
  EXPECT_FALSE(kallinderis_normal(std::vector<Vec3>{{1, 2, 3}, {-2, -4, -6}}));
  EXPECT_FALSE(kallinderis_normal(std::vector<Vec3>{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}));
}

TEST(KallinderisNormal, IsInTheMiddleOfWhatTheBisectingPlaneSees) {
  Random random(2);
  int n_some = 0, n_none = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Vec3> normals = scattered(random, 3 + trial % 9, trial % 2 == 0 ? 1.2 : 1.7);
    for (Vec3& n : normals) n = normalized(n);
    Vec3 a, b;
    for (const Vec3& p : normals) {
      for (const Vec3& q : normals) {
        if (distance(p, q) > distance(a, b)) a = p, b = q;
      }
    }
    const Vec3 up = normalized(a + b), along = normalized(cross(a, b));
    constexpr int kSteps = 4000;
    double first = kPi, last = -kPi;
    for (int k = -kSteps; k < kSteps; ++k) {
      const double angle = kPi * (k + 0.5) / kSteps;
      if (!sees(up * std::cos(angle) + along * std::sin(angle), normals)) continue;
      first = std::min(first, angle);
      last = std::max(last, angle);
    }
    const auto normal = kallinderis_normal(normals);
    if (first > last) {
      EXPECT_FALSE(normal) << trial;
      ++n_none;
      continue;
    }
    ASSERT_TRUE(normal) << trial;
    EXPECT_TRUE(sees(normal->direction, normals)) << trial;
    const double found = std::atan2(dot(normal->direction, along), dot(normal->direction, up));
    EXPECT_NEAR(std::abs(found), std::abs(0.5 * (first + last)), kPi / kSteps) << trial;
    EXPECT_NEAR(dot(normal->direction, a - b), 0, 1e-14) << trial;
    ++n_some;
  }
  EXPECT_GT(n_some, 150);
  EXPECT_GT(n_none, 10);
}

TEST(KallinderisNormal, SeesAllFacesAndIsNeverBetterThanTheMostVisibleOne) {
  Random random(3);
  int n_worse = 0, n_found = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const std::vector<Vec3> normals = scattered(random, 3 + trial % 25, random.uniform(0.1, 1.6));
    const auto normal = kallinderis_normal(normals);
    const auto best = most_visible_normal(normals);
    if (!normal) continue;
    ++n_found;
    ASSERT_TRUE(best && sees(normal->direction, normals)) << trial;
    ASSERT_GE(normal->max_angle, best->max_angle - 1e-14) << trial;
    ASSERT_NEAR(static_cast<double>(fans::worst_angle(fans::to_long(normal->direction), normals)), normal->max_angle,
                2e-15);
    n_worse += normal->max_angle > best->max_angle + 1e-3;
  }
  EXPECT_GT(n_found, 1500);
  EXPECT_GT(n_worse, n_found / 2);
}

using Method = IterativeNormal (*)(std::span<const Vec3>, const IterationOptions&);
struct Named {
  const char* name;
  Method method;
};
void PrintTo(const Named& named, std::ostream* out) { *out << named.name; }

class Iteration : public testing::TestWithParam<Named> {
 protected:
  static IterativeNormal run(const std::vector<Vec3>& normals, const IterationOptions& options = {}) {
    return GetParam().method(normals, options);
  }
};

INSTANTIATE_TEST_SUITE_P(All, Iteration,
                         testing::Values(Named{"Multiplied", iterative_normal}, Named{"Corrected", pirzadeh_normal}),
                         [](const auto& named) { return named.param.name; });

TEST_P(Iteration, HalvesATrailingEdgeWithFourFacesOverThree) {
  for (const double half : {0.1, 10.0, 45.0, 66.0, 67.5, 80.0, 85.0, 88.0, 89.0, 89.5}) {
    const IterativeNormal normal = run(trailing_edge(to_radians(half)));
    EXPECT_TRUE(normal.has_converged) << half;
    EXPECT_NEAR(normal.max_angle, to_radians(half), 1e-4) << half;
    EXPECT_LE(normal.n_iterations, 40) << half;
  }
}

TEST_P(Iteration, ComesWithinItsToleranceOfTheMostVisibleNormal) {
  Random random(4);
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    for (int trial = 0; trial < 200; ++trial) {
      const std::vector<Vec3> normals = scattered(random, 2 + trial % 5, 1.0);
      const IterativeNormal normal = run(normals, {.tolerance = tolerance, .max_iterations = 100000});
      ASSERT_TRUE(normal.has_converged) << trial;
      const double best = most_visible_normal(normals)->max_angle;
      ASSERT_LE(normal.max_angle, best + tolerance) << trial;
      ASSERT_GE(normal.max_angle, best - 1e-14) << trial;
    }
  }
}

TEST_P(Iteration, NeverClaimsToHaveConvergedTooEarly) {
  Random random(5);
  int n_converged = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const std::vector<Vec3> normals = scattered(random, 3 + trial % 30, random.uniform(0.01, 1.6));
    const IterativeNormal normal = run(normals, {.max_iterations = random.integer(0, 60)});
    if (!normal.has_converged) continue;
    ++n_converged;
    const auto best = most_visible_normal(normals);
    ASSERT_LE(normal.max_angle, (best ? best->max_angle : kRightAngle) + 1e-4 + 1e-14) << trial;
  }
  EXPECT_GT(n_converged, 50);
}

TEST_P(Iteration, StartsWithThePlainMean) {
  const std::vector<Vec3> normals = {{2, 0, 0}, {0, 1, 0}, {0, 3, 0}};
  const IterativeNormal normal = run(normals, {.max_iterations = 0});
  EXPECT_FALSE(normal.has_converged);
  EXPECT_EQ(normal.n_iterations, 0);
  EXPECT_NEAR(distance(normal.direction, Vec3(1, 2, 0) / std::sqrt(5.0)), 0, 1e-15);
  EXPECT_NEAR(normal.max_angle, std::atan(2.0), 1e-15);
}

TEST_P(Iteration, NeedsNoStepWhereTheMeanIsTheAnswer) {
  for (const std::size_t n : {1, 2, 30}) {
    const IterativeNormal normal = run(std::vector<Vec3>(n, Vec3(0, -3, 4)));
    EXPECT_TRUE(normal.has_converged);
    EXPECT_EQ(normal.n_iterations, 0);
    EXPECT_NEAR(distance(normal.direction, {0, -0.6, 0.8}), 0, 1e-15);
  }
  const IterativeNormal corner = run({{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_TRUE(corner.has_converged);
  EXPECT_EQ(corner.n_iterations, 0);
  EXPECT_NEAR(to_degrees(corner.max_angle), 54.735610317245346, 1e-13);
}

TEST_P(Iteration, DoesNotConvergeWhereNothingSeesAllFaces) {
  const std::vector<std::vector<Vec3>> blind = {{{1, 2, 3}, {-2, -4, -6}},
                                                {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                                {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, 1}},
                                                {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 1, -1}, {0, -1, -1}}};
  for (const auto& normals : blind) {
    const IterativeNormal normal = run(normals);
    EXPECT_GE(normal.max_angle, kRightAngle);
    EXPECT_NEAR(norm(normal.direction), 1, 1e-15);
  }
  EXPECT_FALSE(run(blind[1]).has_converged);
  EXPECT_FALSE(run(blind[2]).has_converged);
}

TEST(PirzadehNormal, ConvergesToARightAngleWhereThatIsTheSmallest) {
  const auto normal = pirzadeh_normal(std::vector<Vec3>{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}});
  EXPECT_TRUE(normal.has_converged);
  EXPECT_NEAR(normal.max_angle, kRightAngle, 1e-15);
  EXPECT_GE(normal.max_angle, kRightAngle);
}

TEST_P(Iteration, HasNoDirectionWithoutNormals) {
  for (const std::vector<Vec3>& none : {std::vector<Vec3>{}, std::vector<Vec3>{{0, 0, 0}}}) {
    const IterativeNormal normal = run(none);
    EXPECT_EQ(normal.direction, Vec3());
    EXPECT_FALSE(normal.has_converged);
    EXPECT_EQ(normal.max_angle, kRightAngle);
  }
}

TEST_P(Iteration, RefusesWhatIsNotFiniteAndOptionsOutOfRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Vec3> normals = {{1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(run({{1, 0, 0}, {0, infinity, 0}}), InputError);
  EXPECT_THROW(run({{1, std::nan(""), 0}}), InputError);
  try {
    run({{1, 0, 0}, {0, infinity, 0.5}});
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("found (0, inf, 0.5) at place 1"), std::string::npos) << error.what();
  }
  EXPECT_THROW(run(normals, {.relaxation = 0.0}), InputError);
  EXPECT_THROW(run(normals, {.relaxation = infinity}), InputError);
  EXPECT_THROW(run(normals, {.tolerance = 0.0}), InputError);
  EXPECT_THROW(run(normals, {.tolerance = std::nan("")}), InputError);
  EXPECT_THROW(run(normals, {.max_iterations = -1}), InputError);
}

TEST(IterativeNormal, ConvergesWithAFixedRelaxationOnlyBelowItsLimit) {
  for (const double half : {45.0, 66.0, 68.0, 75.0, 80.0, 85.0}) {
    const double angle = to_radians(half), limit = 4 / (2 + gain(angle));
    const auto run = [&](double relaxation) {
      return iterative_normal(trailing_edge(angle),
                              {.relaxation = relaxation, .tolerance = 1e-8, .max_iterations = 4000});
    };
    EXPECT_TRUE(run(0.97 * limit).has_converged) << half;
    EXPECT_FALSE(run(1.03 * limit).has_converged) << half;
  }
}

TEST(IterativeNormal, ConvergesUndampedUpToAHalfAngleOf66Point78Degrees) {
  // There tan(a) = 2 a.
  const auto run = [](double half) {
    return iterative_normal(trailing_edge(to_radians(half)),
                            {.relaxation = 1.0, .tolerance = 1e-8, .max_iterations = 4000});
  };
  EXPECT_TRUE(run(66.5).has_converged);
  EXPECT_FALSE(run(67.1).has_converged);
}

TEST(PirzadehNormal, ConvergesWithAFixedRelaxationOnlyBelowItsLimit) {
  for (const double half : {10.0, 45.0, 66.0, 75.0, 85.0}) {
    const double angle = to_radians(half), limit = 2 / (7 * gain(angle));
    const auto run = [&](double relaxation) {
      return pirzadeh_normal(trailing_edge(angle),
                             {.relaxation = relaxation, .tolerance = 1e-8, .max_iterations = 4000});
    };
    EXPECT_TRUE(run(0.98 * limit).has_converged) << half;
    EXPECT_FALSE(run(1.02 * limit).has_converged) << half;
  }
}

TEST(EarlierNormals, AreTheSameBitsOnPermutedAxesAndScaledVectors) {
  Random random(6);
  for (int trial = 0; trial < 120; ++trial) {
    const std::vector<Vec3> normals = scattered(random, 2 + trial % 30, random.uniform(0.1, 1.4));
    const auto bisector = kallinderis_normal(normals);
    const IterativeNormal multiplied = iterative_normal(normals), corrected = pirzadeh_normal(normals);
    std::array<int, 3> axis = {0, 1, 2};
    do {
      const auto permuted = [&](const Vec3& v) { return Vec3(v[axis[0]], v[axis[1]], v[axis[2]]); };
      std::vector<Vec3> other;
      for (const Vec3& n : normals) other.push_back(permuted(n) * std::ldexp(1.0, random.integer(-300, 300)));
      const auto other_bisector = kallinderis_normal(other);
      ASSERT_EQ(bisector.has_value(), other_bisector.has_value());
      if (bisector) {
        ASSERT_EQ(other_bisector->direction, permuted(bisector->direction)) << trial;
      }
      const IterativeNormal a = iterative_normal(other), b = pirzadeh_normal(other);
      ASSERT_EQ(a.direction, permuted(multiplied.direction)) << trial;
      ASSERT_EQ(a.n_iterations, multiplied.n_iterations);
      ASSERT_EQ(b.direction, permuted(corrected.direction)) << trial;
      ASSERT_EQ(b.max_angle, corrected.max_angle);
    } while (std::next_permutation(axis.begin(), axis.end()));
  }
}

}  // namespace
}  // namespace nearwall::surface

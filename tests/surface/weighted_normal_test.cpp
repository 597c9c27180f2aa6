#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "nearwall/core/errors.h"
#include "nearwall/surface/normals.h"
#include "tests/surface/fans.h"

namespace nearwall::surface {
namespace {

using fans::Random;

constexpr double kPi = std::numbers::pi;

/// The formulas of docs/normals.md in long double, from the lengths of the edges.
long double weight_by_formula(Weight weight, long double a, long double b, long double c, long double alpha,
                              long double projected_area) {
  const long double sine = std::sin(alpha), area = b * c * sine / 2;
  switch (weight) {
    case Weight::Uniform:
      return 1;
    case Weight::Area:
      return area;
    case Weight::InverseArea:
      return 1 / area;
    case Weight::ProjectedArea:
      return projected_area;
    case Weight::Angle:
      return alpha;
    case Weight::InverseRootEdges:
      return 1 / std::sqrt(b * c);
    case Weight::InverseEdges:
      return 1 / (b * c);
    case Weight::InverseSquaredEdges:
      return 1 / (b * c * b * c);
    case Weight::Max:
      return sine / (b * c);
    case Weight::LittleMax:
      return (1 + sine) / (2 * b * c);
    case Weight::InverseDiameter:
      return sine / a;
    case Weight::AngleOverDiameter:
      return alpha * sine / a;
    case Weight::InverseCircumArea:
      return sine / a * (sine / a);
    case Weight::AngleOverCircumArea:
      return alpha * (sine / a) * (sine / a);
  }
  return 0;
}

fans::Long weighted_by_formula(Weight weight, const Vec3& apex, const std::vector<Vec3>& ring, std::size_t n_faces) {
  fans::Long sum{0, 0, 0};
  for (std::size_t k = 0; k < n_faces; ++k) {
    const fans::Long p = fans::to_long(ring[k]), q = fans::to_long(ring[(k + 1) % ring.size()]);
    const fans::Long b = p - fans::to_long(apex), c = q - fans::to_long(apex), a = q - p, n = fans::cross(b, c);
    const long double size = std::sqrt(dot(n, n));
    const long double w = weight_by_formula(weight, std::sqrt(dot(a, a)), std::sqrt(dot(b, b)), std::sqrt(dot(c, c)),
                                            fans::angle(b, c), std::abs(n.z) / 2) /
                          size;
    sum = sum + fans::Long{n.x * w, n.y * w, n.z * w};
  }
  return fans::unit(sum);
}

class WeightedNormalOf : public testing::TestWithParam<int> {};

TEST_P(WeightedNormalOf, FollowsItsFormulaTo1e13OnThinFacesToo) {
  const auto weight = static_cast<Weight>(GetParam());
  Random random(31);
  for (int trial = 0; trial < 500; ++trial) {
    const int n = random.integer(3, 12);
    const double thinness = std::pow(10.0, random.uniform(-5, 0)), size = std::pow(2.0, random.integer(-40, 40));
    const Vec3 apex = random.direction() * size;
    const Vec3 axis = random.direction(), x = normalized(cross(axis, random.direction())), y = cross(axis, x);
    std::vector<Vec3> ring;
    double azimuth = 0;
    for (int k = 0; k < n; ++k) {
      const double r = size * std::pow(10.0, random.uniform(-1, 1));
      ring.push_back(apex + (x * std::cos(azimuth) + y * std::sin(azimuth) - axis * random.uniform(-0.5, 0.5)) * r);
      // Thin faces beside wide ones, in an open fan.
      azimuth += k % 2 == 0 ? thinness : 5.0 / n;
    }
    const Vec3 normal = weighted_normal(weight, apex, ring, false);
    const fans::Long expected = weighted_by_formula(weight, apex, ring, ring.size() - 1);
    ASSERT_LT(fans::angle(fans::to_long(normal), expected), 1e-13L) << trial << " " << thinness;
  }
}

TEST_P(WeightedNormalOf, IsRightTo1e13InCornersThatDoublesHardlyTellFromLines) {
  const auto weight = static_cast<Weight>(GetParam());
  Random random(33);
  const auto whole = [&](std::int64_t below) {
    return std::int64_t{random.integer(0, (1 << 30) - 1)} * (below >> 30) + random.integer(0, 1 << 20) - below / 2;
  };
  for (int trial = 0; trial < 500; ++trial) {
    // Coordinates that doubles hold exactly, while the edges b and b + r may have a bit more. |r| / |b| is 1e-15 to 1.
    const std::int64_t large = std::int64_t{1} << 54, small = std::int64_t{1} << 6;
    fans::Whole apex{}, p{}, r{}, b{};
    for (std::size_t k = 0; k < 3; ++k) {
      apex[k] = whole(large), p[k] = whole(large) >> random.integer(0, 50);
      r[k] = random.integer(-static_cast<int>(small), static_cast<int>(small)), b[k] = p[k] - apex[k];
    }
    const fans::Whole exact = fans::cross(b, r);  // below 2^62
    const auto point = [](const fans::Whole& at) {
      return Vec3(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]));
    };
    const Vec3 p_at = point(p), q_at = point({p[0] + r[0], p[1] + r[1], p[2] + r[2]});
    const Vec3 normal = weighted_normal(weight, point(apex), std::vector<Vec3>{p_at, q_at}, false);
    ASSERT_LT(distance(normal, normalized(point(exact))), 1e-13) << trial;
  }
}

std::string weight_name(const testing::TestParamInfo<int>& parameter) {
  constexpr std::array kNames = {"Uniform",
                                 "Area",
                                 "InverseArea",
                                 "ProjectedArea",
                                 "Angle",
                                 "InverseRootEdges",
                                 "InverseEdges",
                                 "InverseSquaredEdges",
                                 "Max",
                                 "LittleMax",
                                 "InverseDiameter",
                                 "AngleOverDiameter",
                                 "InverseCircumArea",
                                 "AngleOverCircumArea"};
  return kNames[static_cast<std::size_t>(parameter.param)];
}
INSTANTIATE_TEST_SUITE_P(AllWeights, WeightedNormalOf, testing::Range(0, 14), weight_name);

TEST(WeightedNormal, ByMaxIsExactOnSpheresHoweverTheFanLies) {
  Random random(32);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 apex = random.direction(), x = normalized(cross(apex, random.direction())), y = cross(apex, x);
    std::vector<Vec3> ring;
    const int n = random.integer(3, 9);
    for (int k = 0; k < n; ++k) {
      const double azimuth = 2 * kPi * (k + random.uniform(0, 0.9)) / n, polar = random.uniform(0.05, 1.5);
      ring.push_back(apex * std::cos(polar) + (x * std::cos(azimuth) + y * std::sin(azimuth)) * std::sin(polar));
    }
    EXPECT_NEAR(distance(weighted_normal(Weight::Max, apex, ring), apex), 0, 1e-14);
  }
}

TEST(WeightedNormal, IsTheSameBitsFromTheSmallestDoublesToTheLargest) {
  const std::vector<Vec3> ring = {{1, 0, 0.5}, {-0.25, 1, 0}, {-0.25, 0.99609375, 0}, {0, -1, 1}};
  const Vec3 expected = weighted_normal(Weight::Max, {0, 0, 0}, ring);
  for (const int exponent : {-1060, -1000, 1000, 1023}) {
    std::vector<Vec3> scaled = ring;
    for (Vec3& p : scaled) p *= std::ldexp(1.0, exponent);
    EXPECT_EQ(weighted_normal(Weight::Max, {0, 0, 0}, scaled), expected) << exponent;
  }
}

TEST(WeightedNormal, PassesOverFacesWithoutArea) {
  const std::vector<Vec3> plain = {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0.5}};
  std::vector<Vec3> with_spike = plain;
  with_spike.insert(with_spike.begin() + 1, {2, 0, 0});
  // The face between (1, 0, 0) and (2, 0, 0) has no area; uniform weights do not feel how long an edge is.
  EXPECT_NEAR(distance(weighted_normal(Weight::Uniform, {0, 0, 0}, with_spike),
                       weighted_normal(Weight::Uniform, {0, 0, 0}, plain)),
              0, 1e-15);
  for (int weight = 0; weight < 14; ++weight) {
    EXPECT_NEAR(norm(weighted_normal(static_cast<Weight>(weight), {0, 0, 0}, with_spike)), 1, 1e-15);
  }
}

TEST(WeightedNormal, RefusesWhatIsNotFinite) {
  const std::vector<Vec3> ring = {{1, 0, 0}, {0, std::nan(""), 0}, {0, 0, 1}};
  EXPECT_THROW(weighted_normal(Weight::Angle, {0, 0, 0}, ring), InputError);
}

TEST(WeightedNormal, ByAngleDoesNotSeeHowASideIsCut) {
  // A cube's corner: one side in one triangle, one in two, one in four.
  const std::vector<Vec3> ring = {{1, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 3}, {1, 0, 1}, {3, 0, 1}};
  const Vec3 expected = Vec3(1, 1, 1) / std::sqrt(3.0);
  EXPECT_NEAR(distance(weighted_normal(Weight::Angle, {0, 0, 0}, ring), expected), 0, 1e-15);
}

TEST(WeightedNormal, OfAnOpenRingLeavesOutTheLastFace) {
  const std::vector<Vec3> ring = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Vec3 expected = Vec3(1, 0, 1) / std::sqrt(2.0);
  EXPECT_NEAR(distance(weighted_normal(Weight::Angle, {0, 0, 0}, ring, false), expected), 0, 1e-15);
  EXPECT_EQ(weighted_normal(Weight::Angle, {0, 0, 0}, std::span(ring).first(1), false), Vec3());
}

}  // namespace
}  // namespace nearwall::surface

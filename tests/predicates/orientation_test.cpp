#include "nearwall/predicates/orientation.h"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "tests/predicates/points.h"
#include "tests/predicates/reference.h"

namespace nearwall::predicates {
namespace {

using points_for_tests::Kind;
using points_for_tests::Points;

class OverAllKinds : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(, OverAllKinds, testing::ValuesIn(points_for_tests::kAllKinds),
                         [](const auto& kind) { return points_for_tests::name_of(kind.param); });

constexpr int kRounds = 20000;

TEST(Orientation, IsPositiveOnTheSideOfTheNormal) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orientation(a, b, c, Vec3(0.3, 0.3, 1e-300)), Sign::Positive);
  EXPECT_EQ(orientation(a, b, c, Vec3(0.3, 0.3, -1e-300)), Sign::Negative);
  EXPECT_EQ(orientation(a, b, c, Vec3(5, 7, 0)), Sign::Zero);
}

TEST_P(OverAllKinds, OrientationAgreesWithIntegers) {
  Points points(GetParam());
  std::array<int, 3> seen{};
  for (int i = 0; i < kRounds; ++i) {
    const auto [a, b, c, d] = points.next_array<4>();
    const int expected = reference::orientation(a, b, c, d);
    ASSERT_EQ(static_cast<int>(orientation(a, b, c, d)), expected) << "round " << i;
    ++seen[static_cast<std::size_t>(expected + 1)];
  }
  EXPECT_GT(seen[0], kRounds / 10);
  EXPECT_GT(seen[2], kRounds / 10);
  if (GetParam() == Kind::SmallIntegers || GetParam() == Kind::FarAway) {
    EXPECT_GT(seen[1], 0);
  }
}

TEST_P(OverAllKinds, OrientationChangesSignWithEverySwap) {
  Points points(GetParam(), 2);
  for (int i = 0; i < kRounds / 4; ++i) {
    const auto [a, b, c, d] = points.next_array<4>();
    const int sign = static_cast<int>(orientation(a, b, c, d));
    ASSERT_EQ(static_cast<int>(orientation(b, a, c, d)), -sign);
    ASSERT_EQ(static_cast<int>(orientation(a, c, b, d)), -sign);
    ASSERT_EQ(static_cast<int>(orientation(d, b, c, a)), -sign);
  }
}

TEST_P(OverAllKinds, ProductsOfVectorsAgreeWithIntegers) {
  Points points(GetParam(), 3);
  for (int i = 0; i < kRounds; ++i) {
    const auto [a, b, c] = points.next_array<3>();
    const auto p = reference::as_integers(std::array{a, b, c});
    ASSERT_EQ(static_cast<int>(sign_of_determinant(a, b, c)), sgn(reference::dot(reference::cross(p[0], p[1]), p[2])));
    ASSERT_EQ(static_cast<int>(sign_of_dot(a, b)), sgn(reference::dot(p[0], p[1])));
    // Rounded to be perpendicular: the sign is that of the rounding.
    const Vec3 n = cross(a, b);
    if (!is_finite(n)) continue;
    const auto q = reference::as_integers(std::array{a, n});
    ASSERT_EQ(static_cast<int>(sign_of_dot(a, n)), sgn(reference::dot(q[0], q[1])));
  }
}

TEST_P(OverAllKinds, DegenerateTrianglesAgreeWithIntegers) {
  Points points(GetParam(), 4);
  int n_degenerate = 0;
  for (int i = 0; i < kRounds; ++i) {
    auto [a, b, c] = points.next_array<3>();
    if (i % 2 == 0) c = 0.5 * (a + b);  // on the line, or next to it by rounding
    if (i % 4 == 1) c = b;
    const auto p = reference::as_integers(std::array{a, b, c});
    const reference::Point n = reference::cross(p[1] - p[0], p[2] - p[0]);
    const bool expected = n.x == 0 && n.y == 0 && n.z == 0;
    ASSERT_EQ(is_degenerate(a, b, c), expected) << "round " << i;
    n_degenerate += expected ? 1 : 0;
  }
  EXPECT_GT(n_degenerate, 0);
  EXPECT_LT(n_degenerate, kRounds);
}

TEST(Orientation, SeesWhatDoublesLose) {
  // The determinant is 2^-106, far below the rounding of its terms.
  const double e = 0x1p-53;
  const Vec3 o(0, 0, 0), a(1.0 - e, 1, 0), b(1, 1.0 + 2 * e, 0), z(0, 0, 1);
  // (1 - e)(1 + 2 e) - 1 = e - 2 e^2 > 0
  EXPECT_EQ(orientation(o, a, b, z), Sign::Positive);
  EXPECT_EQ(orientation(o, Vec3(1.0 - 2 * e, 1, 0), b, z), Sign::Negative);  // -4 e^2
}

TEST(Orientation, SurvivesTheEndsOfTheRange) {
  const double big = std::numeric_limits<double>::max(), small = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(orientation({-big, -big, -big}, {big, -big, -big}, {-big, big, -big}, {-big, -big, big}), Sign::Positive);
  EXPECT_EQ(orientation({0, 0, 0}, {small, 0, 0}, {0, small, 0}, {0, 0, small}), Sign::Positive);
  EXPECT_EQ(orientation({0, 0, 0}, {big, 0, 0}, {0, small, 0}, {0, small, -small}), Sign::Negative);
}

TEST(Orientation, RefusesWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(orientation({nan, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), InputError);
  EXPECT_THROW(orientation({0, 0, 0}, {inf, 0, 0}, {0, 1, 0}, {0, 0, 1}), InputError);
  EXPECT_THROW(sign_of_dot({nan, 0, 0}, {1, 0, 0}), InputError);
}

}  // namespace
}  // namespace nearwall::predicates

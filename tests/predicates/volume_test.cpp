#include "nearwall/predicates/volume.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "tests/predicates/points.h"
#include "tests/predicates/reference.h"

namespace nearwall::predicates {
namespace {

using points_for_tests::Kind;
using points_for_tests::Points;

EnclosedVolume within(const std::vector<Triangle>& triangles) {
  return enclosed_volume(triangles.size(), [&](std::size_t i) { return triangles[i]; });
}

/// Positive in volume if d lies on the side of the triangle (a, b, c) to which its normal points.
std::vector<Triangle> tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

class VolumeOverAllKinds : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(, VolumeOverAllKinds, testing::ValuesIn(points_for_tests::kAllKinds),
                         [](const auto& kind) { return points_for_tests::name_of(kind.param); });

TEST_P(VolumeOverAllKinds, HasTheSignOfATetrahedronsOrientation) {
  Points points(GetParam());
  for (int i = 0; i < 5000; ++i) {
    const auto [a, b, c, d] = points.next_array<4>();
    ASSERT_EQ(static_cast<int>(within(tetrahedron(a, b, c, d)).sign), reference::orientation(a, b, c, d))
        << "round " << i;
  }
}

TEST(EnclosedVolume, IsThatOfTwoTetrahedraTogether) {
  auto triangles = tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  EXPECT_DOUBLE_EQ(within(triangles).value, 1.0 / 6);
  const auto cavity = tetrahedron({5, 0, 0}, {5, 2, 0}, {7, 0, 0}, {5, 0, 2});
  triangles.insert(triangles.end(), cavity.begin(), cavity.end());
  EXPECT_DOUBLE_EQ(within(triangles).value, (1.0 - 8.0) / 6);
  EXPECT_EQ(within(triangles).sign, Sign::Negative);
}

TEST(EnclosedVolume, IsDecidedOnPlatesAThousandthOfARoundingThick) {
  // Corners of a slanted square, one of them moved by one unit in the last place: the volume is far below the rounding
  // of its terms.
  const Vec3 a(0.1, 0.2, 0.3), b(1.1, 0.3, 0.7), c(1.2, 1.3, 0.9), d(0.2, 1.2, std::nextafter(0.5, 1.0));
  const Sign side = orientation(a, b, c, d);
  ASSERT_NE(side, Sign::Zero);
  EXPECT_LT(std::abs(within(tetrahedron(a, b, c, d)).value), 1e-15);
  EXPECT_EQ(within(tetrahedron(a, b, c, d)).sign, side);
  EXPECT_NE(within(tetrahedron(a, c, b, d)).sign, side);
}

TEST(EnclosedVolume, IsDecidedWhereProductsUnderflow) {
  // All products of three edges round to zero or to the last bit of a double.
  const double s = 0x1p-359;
  const Vec3 a(0, 0, 0), b(s, 0, s), c(0, s, s), d(s, s, 2 * s), above(s, s, std::nextafter(2 * s, 1.0));
  EXPECT_EQ(within(tetrahedron(a, b, c, d)).sign, Sign::Zero);
  EXPECT_EQ(within(tetrahedron(a, b, c, above)).sign, Sign::Positive);
  EXPECT_EQ(within(tetrahedron(a, c, b, above)).sign, Sign::Negative);
}

TEST(EnclosedVolume, RefusesWhatIsNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(within(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, inf})), InputError);
}

TEST(EnclosedVolume, OfNothingIsNothing) { EXPECT_EQ(within({}).sign, Sign::Zero); }

}  // namespace
}  // namespace nearwall::predicates

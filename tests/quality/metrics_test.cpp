#include "nearwall/quality/metrics.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace nearwall::quality {
namespace {

using mesh::CellType;

const double kRoot2 = std::numbers::sqrt2;
const double kRoot3 = std::numbers::sqrt3;

struct NamedCell {
  const char* name;
  CellType type;
  std::vector<Vec3> p;
};

void PrintTo(const NamedCell& cell, std::ostream* os) { *os << cell.name; }

std::vector<NamedCell> ideal_cells() {
  return {{"Tetrahedron", CellType::Tetrahedron, {{-1, -1, 1}, {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}}},
          {"Pyramid", CellType::Pyramid, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, kRoot2}}},
          {"Wedge", CellType::Wedge, {{0, 0, 0}, {2, 0, 0}, {1, kRoot3, 0}, {0, 0, 2}, {2, 0, 2}, {1, kRoot3, 2}}},
          {"Hexahedron",
           CellType::Hexahedron,
           {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}}};
}

class IdealCell : public testing::TestWithParam<NamedCell> {};

TEST_P(IdealCell, HasScaledJacobianAndAspectRatioOne) {
  const NamedCell& cell = GetParam();
  EXPECT_NEAR(scaled_jacobian(cell.type, cell.p), 1, 1e-15);
  EXPECT_NEAR(aspect_ratio(cell.type, cell.p), 1, 1e-15);
}

TEST_P(IdealCell, IsMinusOneWhenMirrored) {
  NamedCell cell = GetParam();
  for (Vec3& p : cell.p) p = {p.x(), p.y(), -p.z()};
  EXPECT_NEAR(scaled_jacobian(cell.type, cell.p), -1, 1e-15);
}

TEST_P(IdealCell, DoesNotFeelScaleNorTheOrderOfTheAxes) {
  NamedCell cell = GetParam();
  cell.p[0] += Vec3(0.125, -0.25, 0.0625);
  const double before = scaled_jacobian(cell.type, cell.p);
  for (Vec3& p : cell.p) p = Vec3(p.z(), p.x(), p.y()) * std::ldexp(1.0, -70);
  EXPECT_EQ(scaled_jacobian(cell.type, cell.p), before);
}

INSTANTIATE_TEST_SUITE_P(AllTypes, IdealCell, testing::ValuesIn(ideal_cells()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(ScaledJacobian, OfAWedgeAtACubeCornerIsAThirdOfRootTwo) {
  // The line runs along the cube's diagonal, the face's own diagonal ends in the corner: 45 degrees there.
  const double h = 1e-5;
  const std::vector<Vec3> p = {{1, 1, 1},         {0, 1, 1},    {0, 0, 1}, {1 + h, 1 + h, 1 + h},
                               {0, 1 + h, 1 + h}, {0, 0, 1 + h}};
  EXPECT_NEAR(scaled_jacobian(CellType::Wedge, p), kRoot2 / 3, 1e-5);
}

TEST(ScaledJacobian, OfARightAngledPrismIsItsSharpestCorner) {
  const std::vector<Vec3> p = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 1}, {3, 0, 1}, {0, 4, 1}};
  EXPECT_NEAR(scaled_jacobian(CellType::Wedge, p), 0.6 * 2 / kRoot3, 1e-15);  // sin of the angle at (0, 4): 3 / 5
  EXPECT_DOUBLE_EQ(aspect_ratio(CellType::Wedge, p), 5);
}

TEST(ScaledJacobian, OfACollapsedEdgeIsZero) {
  const std::vector<Vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 1}, {0, 1, 1}};
  EXPECT_EQ(scaled_jacobian(CellType::Wedge, p), 0);
  EXPECT_TRUE(std::isinf(aspect_ratio(CellType::Wedge, p)));
}

TEST(ScaledJacobian, SeesAHexahedronThatIsInvertedAtOneCorner) {
  auto cube = ideal_cells()[3].p;
  cube[6] = {0.5, 0.5, 0.5};
  EXPECT_LT(scaled_jacobian(CellType::Hexahedron, cube), 0);
}

}  // namespace
}  // namespace nearwall::quality

#include "nearwall/geometry/measures.h"

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/geometry/angles.h"

namespace nearwall::geometry {
namespace {

using Map = std::function<Vec3(double, double, double)>;

/// Determinant of the map's Jacobian by central differences, exact up to rounding for maps of degree two in each.
double jacobian(const Map& map, double r, double s, double t) {
  const double h = 0.01;
  const Vec3 dr = (map(r + h, s, t) - map(r - h, s, t)) / (2 * h);
  const Vec3 ds = (map(r, s + h, t) - map(r, s - h, t)) / (2 * h);
  const Vec3 dt = (map(r, s, t + h) - map(r, s, t - h)) / (2 * h);
  return dot(cross(dr, ds), dt);
}

struct GaussPoint {
  double at, weight;
};
constexpr std::array<GaussPoint, 3> kGauss = {
    {{0.1127016653792583, 5.0 / 18}, {0.5, 8.0 / 18}, {0.8872983346207417, 5.0 / 18}}};

std::vector<Vec3> random_points(std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < n; ++k) points.emplace_back(u(random), u(random), u(random));
  return points;
}

TEST(TriangleMeasures, OfTheUnitRightTriangle) {
  EXPECT_EQ(triangle_area_vector({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), Vec3(0, 0, 0.5));
  EXPECT_EQ(triangle_area({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.5);
  EXPECT_EQ(triangle_normal({0, 0, 0}, {0, 3, 0}, {4, 0, 0}), Vec3(0, 0, -1));
  EXPECT_EQ(triangle_normal({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), Vec3(0, 0, 0));
}

TEST(WidestCorner, IsAtWhicheverPointItLies) {
  const Vec3 a{0, 0, 0}, b{2, 0, 0}, c{1, 0, 1 / std::sqrt(3.0)};
  for (const double angle : {widest_corner(a, b, c), widest_corner(b, c, a), widest_corner(c, a, b)}) {
    EXPECT_NEAR(angle, to_radians(120), 1e-15);
  }
}

TEST(HexahedronVolume, IsTheIntegralOfTheJacobian) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const auto p = random_points(8, random);
    const Map map = [&](double r, double s, double t) {
      const auto face = [&](std::size_t k) {
        return (p[k] * (1 - r) + p[k + 1] * r) * (1 - s) + (p[k + 3] * (1 - r) + p[k + 2] * r) * s;
      };
      return face(0) * (1 - t) + face(4) * t;
    };
    double integral = 0;
    for (const auto& a : kGauss) {
      for (const auto& b : kGauss) {
        for (const auto& c : kGauss) integral += a.weight * b.weight * c.weight * jacobian(map, a.at, b.at, c.at);
      }
    }
    EXPECT_NEAR(hexahedron_volume(std::span<const Vec3, 8>(p.data(), 8)), integral, 1e-11);
  }
}

TEST(WedgeVolume, IsThatOfTheHexahedronWithACollapsedEdge) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const auto p = random_points(6, random);
    const std::array<Vec3, 6> wedge = {p[0], p[1], p[2], p[3], p[4], p[5]};
    const std::array<Vec3, 8> hexahedron = {p[0], p[1], p[2], p[2], p[3], p[4], p[5], p[5]};
    EXPECT_NEAR(wedge_volume(wedge), hexahedron_volume(hexahedron), 1e-14);
  }
}

TEST(PyramidVolume, IsThatOfTheHexahedronWithACollapsedTop) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const auto p = random_points(5, random);
    const std::array<Vec3, 5> pyramid = {p[0], p[1], p[2], p[3], p[4]};
    const std::array<Vec3, 8> hexahedron = {p[0], p[1], p[2], p[3], p[4], p[4], p[4], p[4]};
    EXPECT_NEAR(pyramid_volume(pyramid), hexahedron_volume(hexahedron), 1e-14);
  }
}

TEST(TetrahedronVolume, OfTheUnitCorner) {
  const std::array<Vec3, 4> p = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  EXPECT_DOUBLE_EQ(tetrahedron_volume(p), 1.0 / 6);
}

TEST(CompensatedSum, KeepsWhatPlainSummationLoses) {
  CompensatedSum sum;
  for (const double v : {1.0, 1e100, 1.0, -1e100}) sum.add(v);
  EXPECT_EQ(sum.value(), 2.0);
}

}  // namespace
}  // namespace nearwall::geometry

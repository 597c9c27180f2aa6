#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "nearwall/surface/fitted_normals.h"
#include "nearwall/surface/normals.h"
#include "tests/support/shapes.h"
#include "tests/surface/fits.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;
using fans::Random;

/// Torus with radii 2 and 1, n x 2n points that are moved along it by up to a fifth of their distance.
struct Torus {
  mesh::SurfaceMesh surface;
  std::vector<Vec3> normals;

  Torus(int n, unsigned seed) {
    Random random(seed);
    const int m = 2 * n;
    const auto number = [&](int i, int j) { return static_cast<std::size_t>((i + n) % n * m + (j + m) % m); };
    std::vector<Vec3> points;
    std::vector<shapes::Corners> faces;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < m; ++j) {
        const double a = 2 * std::numbers::pi * (i + random.uniform(-0.2, 0.2)) / n;
        const double b = 2 * std::numbers::pi * (j + random.uniform(-0.2, 0.2)) / m;
        normals.emplace_back(std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), std::sin(a));
        points.push_back(Vec3(2 * std::cos(b), 2 * std::sin(b), 0) + normals.back());
        faces.push_back({number(i, j), number(i, j + 1), number(i + 1, j + 1)});
        faces.push_back({number(i, j), number(i + 1, j + 1), number(i + 1, j)});
      }
    }
    surface = shapes::make_surface(points, faces);
  }

  double rms_error(Fit fit) const {
    const mesh::Topology topology(surface);
    Neighbourhood neighbourhood(topology);
    double sum = 0;
    for (const VertexId v : surface.points.ids()) {
      std::vector<Vec3> ring, neighbours;
      for (const HalfedgeId h : topology.fan(v)) ring.push_back(surface.points[topology.target(h)]);
      for (const VertexId w : neighbourhood.of(v)) neighbours.push_back(surface.points[w]);
      const Vec3 axis = weighted_normal(Weight::Uniform, surface.points[v], ring);
      const auto normal = fitted_normal(fit, surface.points[v], axis, neighbours);
      if (!normal) return std::numeric_limits<double>::quiet_NaN();
      sum += std::pow(angle(*normal, normals[v.index()]), 2);
    }
    return std::sqrt(sum / static_cast<double>(surface.points.size()));
  }
};

TEST(FittedNormal, ConvergesOnATorusWithTheOrderOfWhatItReproduces) {
  const Torus coarse(24, 11), fine(48, 12);
  for (const Fit fit : {Fit::QuadraticLeastSquares, Fit::RenkaCline}) {
    EXPECT_GT(std::log2(coarse.rms_error(fit) / fine.rms_error(fit)), 1.85) << name(fit);
  }
  for (const Fit fit : {Fit::LinearLeastSquares, Fit::Hardy, Fit::ThinPlate}) {
    EXPECT_GT(std::log2(coarse.rms_error(fit) / fine.rms_error(fit)), 0.9) << name(fit);
  }
}

TEST(FittedNormal, QuadraticsConvergeOnASphere) {
  std::array<double, 2> worst{};
  for (const Fit fit : {Fit::QuadraticLeastSquares, Fit::RenkaCline}) {
    for (const int level : {3, 4}) {
      const auto surface = shapes::sphere(level);
      const mesh::Topology topology(surface);
      Neighbourhood neighbourhood(topology);
      double& error = worst[static_cast<std::size_t>(level - 3)] = 0;
      for (const VertexId v : surface.points.ids()) {
        std::vector<Vec3> neighbours;
        for (const VertexId w : neighbourhood.of(v)) neighbours.push_back(surface.points[w]);
        const auto normal = fitted_normal(fit, surface.points[v], surface.points[v] + Vec3(0.1, 0.2, 0), neighbours);
        ASSERT_TRUE(normal);
        error = std::max(error, angle(*normal, surface.points[v]));
      }
    }
    EXPECT_GT(std::log2(worst[0] / worst[1]), 1.85) << name(fit);
  }
}

TEST(FittedNormal, KnowsQuadraticsUpToTheBoundary) {
  const auto height = [](double x, double y) { return 0.1 * x - 0.2 * y + 0.05 * x * x - 0.03 * x * y + 0.02 * y * y; };
  const auto surface = shapes::height_field(6, height);
  const mesh::Topology topology(surface);
  Neighbourhood neighbourhood(topology);
  for (const VertexId v : surface.points.ids()) {
    const auto [x, y] = std::pair(surface.points[v].x(), surface.points[v].y());
    std::vector<Vec3> neighbours;
    for (const VertexId w : neighbourhood.of(v, 2)) neighbours.push_back(surface.points[w]);
    const Vec3 expected = normalized(Vec3(-(0.1 + 0.1 * x - 0.03 * y), -(-0.2 - 0.03 * x + 0.04 * y), 1));
    for (const Fit fit : {Fit::QuadraticLeastSquares, Fit::RenkaCline}) {
      const auto normal = fitted_normal(fit, surface.points[v], {0, 0, 1}, neighbours);
      ASSERT_TRUE(normal) << name(fit) << " at " << x << ' ' << y;
      EXPECT_LT(angle(*normal, expected), 1e-12) << name(fit) << " at " << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace nearwall::surface

#include "nearwall/surface/fitted_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/surface/fits.h"
#include "tests/surface/long_system.h"

namespace nearwall::surface {
namespace {

using fans::Random;

TEST(FittedNormal, IsExactOnPlanesWhateverTheAxis) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    Scattered scattered(random, random.integer(6, 24));
    const double a = random.uniform(-2, 2), b = random.uniform(-2, 2);
    scattered.lift([&](double x, double y) { return a * x + b * y; });
    for (const Fit fit : kFits) {
      const bool reproduces = fit != Fit::Shepard;
      // Shepard's function reproduces constants only: it is exact where the axis is the normal.
      const Vec3 axis = reproduces ? scattered.axis : scattered.normal(a, b);
      const auto normal = fitted_normal(fit, scattered.point, axis, scattered.neighbours);
      ASSERT_TRUE(normal) << name(fit);
      EXPECT_LT(angle(*normal, scattered.normal(a, b)), 1e-10) << name(fit);
      EXPECT_NEAR(norm(*normal), 1, 1e-15);
    }
  }
}

TEST(FittedNormal, QuadraticFitsAreExactOnQuadratics) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    Scattered scattered(random, random.integer(8, 24));
    std::array<double, 5> c{};
    for (double& coefficient : c) coefficient = random.uniform(-1, 1);
    scattered.lift(
        [&](double x, double y) { return c[0] * x + c[1] * y + c[2] * x * x + c[3] * x * y + c[4] * y * y; });
    for (const Fit fit : {Fit::QuadraticLeastSquares, Fit::RenkaCline}) {
      const auto normal = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      ASSERT_TRUE(normal) << name(fit);
      EXPECT_LT(angle(*normal, scattered.normal(c[0], c[1])), 1e-11) << name(fit);
    }
  }
}

/// Least squares by the normal equations: coefficients of the functions, each row weighted.
std::vector<long double> normal_equations(const std::vector<std::vector<long double>>& rows,
                                          const std::vector<long double>& heights,
                                          const std::vector<long double>& weights) {
  const std::size_t n = rows[0].size();
  LongSystem system(n, std::vector<long double>(n + 1));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const long double w2 = weights[r] * weights[r];
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) system[i][j] += w2 * rows[r][i] * rows[r][j];
      system[i][n] += w2 * rows[r][i] * heights[r];
    }
  }
  return solved(std::move(system));
}

TEST(FittedNormal, LeastSquaresSolveTheNormalEquations) {
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    Scattered scattered(random, random.integer(7, 24));
    scattered.lift(wave);
    double farthest = 0;
    for (const auto& [x, y] : scattered.at) farthest = std::max(farthest, std::hypot(x, y));
    for (const Fit fit : {Fit::LinearLeastSquares, Fit::QuadraticLeastSquares, Fit::RenkaCline}) {
      const bool is_through_point = fit == Fit::RenkaCline;
      std::vector<std::vector<long double>> rows;
      std::vector<long double> heights, weights;
      const auto add = [&](long double x, long double y, long double z, long double weight) {
        if (fit == Fit::LinearLeastSquares) rows.push_back({x, y, 1});
        if (fit == Fit::QuadraticLeastSquares) rows.push_back({x, y, x * x, x * y, y * y, 1});
        if (fit == Fit::RenkaCline) rows.push_back({x, y, x * x, x * y, y * y});
        heights.push_back(z), weights.push_back(weight);
      };
      for (std::size_t i = 0; i < scattered.at.size(); ++i) {
        const auto [x, y] = scattered.at[i];
        const double d = std::hypot(x, y), r = 1.0625 * farthest;
        add(x, y, scattered.height[i], is_through_point ? (r - d) / (r * d) : 1);
      }
      if (!is_through_point) add(0, 0, 0, 1);
      const auto c = normal_equations(rows, heights, weights);
      const auto normal = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      ASSERT_TRUE(normal) << name(fit);
      EXPECT_LT(angle(*normal, scattered.normal(c[0], c[1])), 1e-11) << name(fit);
    }
  }
}

TEST(FittedNormal, InterpolantsSolveTheFullSystem) {
  Random random(4);
  for (int trial = 0; trial < 60; ++trial) {
    Scattered scattered(random, random.integer(4, 24));
    scattered.lift(wave);
    auto at = scattered.at;
    auto height = scattered.height;
    at.push_back({0, 0}), height.push_back(0);
    long double mean = 0;
    for (const auto& [x, y] : scattered.at) mean += std::hypot(x, y) / static_cast<double>(scattered.at.size());
    for (const Fit fit : {Fit::Hardy, Fit::ThinPlate}) {
      const bool is_hardy = fit == Fit::Hardy;
      const long double r2 = 0.25L * mean * mean;
      const std::size_t n = at.size();
      const auto d2 = [&](std::size_t i, std::size_t j) {
        const long double dx = at[i][0] - at[j][0], dy = at[i][1] - at[j][1];
        return dx * dx + dy * dy;
      };
      LongSystem system(n + 3, std::vector<long double>(n + 4));
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          system[i][j] = is_hardy ? std::sqrt(d2(i, j) + r2) : i == j ? 0 : d2(i, j) * std::log(d2(i, j));
        }
        const std::array<long double, 3> affine = {1, at[i][0], at[i][1]};
        for (std::size_t k = 0; k < 3; ++k) system[i][n + k] = system[n + k][i] = affine[k];
        system[i][n + 3] = height[i];
      }
      const auto c = solved(std::move(system));
      long double a = c[n + 1], b = c[n + 2];
      for (std::size_t i = 0; i + 1 < n; ++i) {
        const long double s = d2(i, n - 1), slope = is_hardy ? 1 / std::sqrt(s + r2) : 2 * std::log(s) + 2;
        a -= c[i] * slope * at[i][0], b -= c[i] * slope * at[i][1];
      }
      const auto normal = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      ASSERT_TRUE(normal) << name(fit);
      EXPECT_LT(angle(*normal, scattered.normal(a, b)), 1e-9) << name(fit);
    }
  }
}

TEST(FittedNormal, ShepardHasTheSlopesOfTheMeanOfTheNeighbours) {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    Scattered scattered(random, random.integer(3, 20));
    scattered.lift(wave);
    const auto mean = [&](long double x, long double y) {
      long double sum = 0, weights = 0;
      for (std::size_t i = 0; i < scattered.at.size(); ++i) {
        const long double dx = x - scattered.at[i][0], dy = y - scattered.at[i][1], weight = 1 / (dx * dx + dy * dy);
        sum += weight * scattered.height[i], weights += weight;
      }
      return sum / weights;
    };
    const long double h = 1e-6L;
    const auto normal = fitted_normal(Fit::Shepard, scattered.point, scattered.axis, scattered.neighbours);
    ASSERT_TRUE(normal);
    const Vec3 expected = scattered.normal((mean(h, 0) - mean(-h, 0)) / (2 * h), (mean(0, h) - mean(0, -h)) / (2 * h));
    EXPECT_LT(angle(*normal, expected), 1e-8);
  }
}

TEST(FittedNormal, TurnsWithTheSurface) {
  Random random(6);
  for (int trial = 0; trial < 60; ++trial) {
    Scattered scattered(random, random.integer(8, 24));
    scattered.lift(wave);
    const Vec3 x = random.direction(), y = normalized(cross(x, random.direction())), z = cross(x, y);
    const auto turned = [&](const Vec3& v) { return x * v.x() + y * v.y() + z * v.z(); };
    std::vector<Vec3> neighbours;
    for (const Vec3& p : scattered.neighbours) neighbours.push_back(turned(p));
    for (const Fit fit : kFits) {
      const auto before = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      const auto after = fitted_normal(fit, turned(scattered.point), turned(scattered.axis), neighbours);
      ASSERT_TRUE(before && after) << name(fit);
      EXPECT_LT(angle(*after, turned(*before)), 1e-9) << name(fit);
    }
  }
}

TEST(FittedNormal, IsTheSameBitsAtAllScalesAndOnPermutedAxes) {
  Random random(7);
  constexpr std::array<std::array<int, 3>, 5> kOrders = {{{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  for (int trial = 0; trial < 40; ++trial) {
    Scattered scattered(random, random.integer(8, 24));
    scattered.lift(wave);
    for (const Fit fit : kFits) {
      const auto expected = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      ASSERT_TRUE(expected) << name(fit);
      for (const int exponent : {-900, -7, 3, 900}) {
        const double scale = std::ldexp(1.0, exponent);
        std::vector<Vec3> neighbours;
        for (const Vec3& p : scattered.neighbours) neighbours.push_back(p * scale);
        EXPECT_EQ(fitted_normal(fit, scattered.point * scale, scattered.axis * scale, neighbours), expected)
            << name(fit) << " at 2^" << exponent;
      }
      for (const auto& order : kOrders) {
        const auto permuted = [&](const Vec3& v) { return Vec3(v[order[0]], v[order[1]], v[order[2]]); };
        std::vector<Vec3> neighbours;
        for (const Vec3& p : scattered.neighbours) neighbours.push_back(permuted(p));
        EXPECT_EQ(fitted_normal(fit, permuted(scattered.point), permuted(scattered.axis), neighbours),
                  permuted(*expected))
            << name(fit);
      }
    }
  }
}

}  // namespace
}  // namespace nearwall::surface

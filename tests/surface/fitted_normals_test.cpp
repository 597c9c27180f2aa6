#include "nearwall/surface/fitted_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "nearwall/surface/normals.h"
#include "tests/support/shapes.h"
#include "tests/surface/fans.h"
#include "tests/surface/long_system.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;
using fans::Random;

constexpr std::array kFits = {
    Fit::LinearLeastSquares, Fit::QuadraticLeastSquares, Fit::RenkaCline, Fit::Shepard, Fit::Hardy, Fit::ThinPlate};
constexpr std::array<const char*, 6> kNames = {"linear", "quadratic", "Renka-Cline", "Shepard", "Hardy", "thin plate"};
const char* name(Fit fit) { return kNames[static_cast<std::size_t>(fit)]; }

double angle(const Vec3& a, const Vec3& b) { return geometry::angle_between(a, b); }

/// A point with neighbours scattered round it, as heights over a plane.
struct Scattered {
  Vec3 point, t1, t2, axis;
  std::vector<std::array<double, 2>> at;
  std::vector<double> height;
  std::vector<Vec3> neighbours;

  Scattered(Random& random, int n, double smallest_gap = 0.1) {
    point = random.direction() * 3.0;
    axis = random.direction();
    t1 = normalized(cross(axis, random.direction()));
    t2 = cross(axis, t1);
    while (static_cast<int>(at.size()) < n) {
      const std::array<double, 2> p = {random.uniform(-1, 1), random.uniform(-1, 1)};
      const auto far_from = [&](const std::array<double, 2>& q) {
        return std::hypot(p[0] - q[0], p[1] - q[1]) > smallest_gap;
      };
      if (far_from({0, 0}) && std::all_of(at.begin(), at.end(), far_from)) at.push_back(p);
    }
  }
  template <class Height>
  void lift(Height&& height_at) {
    neighbours.clear(), height.clear();
    for (const auto& [x, y] : at) {
      height.push_back(height_at(x, y));
      neighbours.push_back(point + t1 * x + t2 * y + axis * height.back());
    }
  }
  Vec3 normal(long double a, long double b) const {
    return normalized(axis - t1 * static_cast<double>(a) - t2 * static_cast<double>(b));
  }
};

double wave(double x, double y) { return 0.4 * std::sin(2 * x + y) + 0.3 * std::cos(3 * y - x) - 0.3; }

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

TEST(FittedNormal, GivesNothingWhereTheFitIsOpen) {
  const Vec3 z(0, 0, 1);
  const std::vector<Vec3> line = {{1, 2, 0}, {2, 4, 1}, {-1, -2, 3}, {0.5, 1, 0}, {-3, -6, 0}, {4, 8, 2}, {5, 10, 0}};
  const std::vector<Vec3> cross_of_lines = {{1, 0, 0}, {2, 0, 1}, {-1, 0, 3}, {0, 1, 0}, {0, -3, 0}, {0, 4, 2}};
  const std::vector<Vec3> on_each_other = {{1, 0, 0}, {0, 1, 0}, {-1, 0.2, 0}, {-1, 0.2, 1}, {0.3, -1, 0}};
  for (const Fit fit : kFits) {
    const bool is_quadratic = fit == Fit::QuadraticLeastSquares || fit == Fit::RenkaCline;
    const bool interpolates = fit == Fit::Hardy || fit == Fit::ThinPlate;
    EXPECT_FALSE(fitted_normal(fit, {}, z, {})) << name(fit);
    EXPECT_FALSE(fitted_normal(fit, {}, z, std::vector<Vec3>{{1, 0, 0}})) << name(fit);
    EXPECT_EQ(fitted_normal(fit, {}, z, std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}).has_value(),
              !is_quadratic)
        << name(fit);
    EXPECT_EQ(fitted_normal(fit, {}, z, line).has_value(), fit == Fit::Shepard) << name(fit);
    EXPECT_EQ(fitted_normal(fit, {}, z, cross_of_lines).has_value(), !is_quadratic) << name(fit);
    EXPECT_EQ(fitted_normal(fit, {}, z, on_each_other).has_value(), !interpolates && !is_quadratic) << name(fit);
    EXPECT_FALSE(fitted_normal(fit, {}, {}, cross_of_lines)) << name(fit) << " without an axis";
    EXPECT_FALSE(fitted_normal(fit, {}, {0, 0, std::numeric_limits<double>::quiet_NaN()}, cross_of_lines));
    EXPECT_FALSE(fitted_normal(fit, {std::numeric_limits<double>::infinity(), 0, 0}, z, cross_of_lines));
    EXPECT_FALSE(fitted_normal(fit, {}, z, std::vector<Vec3>(8, Vec3{}))) << name(fit) << " in one point";
    EXPECT_FALSE(fitted_normal(fit, {}, z, std::vector<Vec3>(8, Vec3(0, 0, 1)))) << name(fit) << " along the axis";
  }
  for (const Fit fit : {Fit::RenkaCline, Fit::Shepard, Fit::Hardy, Fit::ThinPlate}) {
    const std::vector<Vec3> above = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 2, 0}, {2, 1, 0}};
    EXPECT_FALSE(fitted_normal(fit, {}, z, above)) << name(fit) << " with a neighbour above the point";
  }
}

TEST(FittedNormal, GivesNothingWhereTheFitIsOpenButForRounding) {
  Random random(13);
  for (int trial = 0; trial < 50; ++trial) {
    Scattered scattered(random, 16);
    for (auto& [x, y] : scattered.at) y = 0.5 * x + random.uniform(-1e-11, 1e-11);
    scattered.lift(wave);
    for (const Fit fit : {Fit::LinearLeastSquares, Fit::QuadraticLeastSquares, Fit::RenkaCline}) {
      EXPECT_FALSE(fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours)) << name(fit);
    }
    Scattered folded(random, 12);
    folded.at.push_back({folded.at[3][0] + 1e-9, folded.at[3][1]});
    folded.lift([&](double, double) { return random.uniform(-1, 1); });
    for (const Fit fit : {Fit::Hardy, Fit::ThinPlate}) {
      EXPECT_FALSE(fitted_normal(fit, folded.point, folded.axis, folded.neighbours)) << name(fit);
    }
  }
}

TEST(FittedNormal, GrowsSteeperWithTheHeightsWithoutLossOfDigits) {
  Random random(14);
  const Vec3 z(0, 0, 1);
  for (int trial = 0; trial < 50; ++trial) {
    Scattered scattered(random, 14);
    std::vector<Vec3> flat, steep;
    for (const auto& [x, y] : scattered.at) {
      const double height = random.uniform(-1, 1);
      flat.emplace_back(x, y, height), steep.emplace_back(x, y, height * 0x1p16);
    }
    for (const Fit fit : kFits) {
      const auto low = fitted_normal(fit, {}, z, flat), high = fitted_normal(fit, {}, z, steep);
      ASSERT_TRUE(low && high) << name(fit);
      for (const int axis : {0, 1}) {
        const double slope = (*low)[axis] / low->z() * 0x1p16;
        EXPECT_NEAR((*high)[axis] / high->z(), slope, 1e-14 * std::abs(slope)) << name(fit);
      }
    }
  }
}

TEST(FittedNormal, IsAUnitVectorOnTheAxisSideOrNothingAsNeighboursMeet) {
  Random random(8);
  for (int exponent = 0; exponent < 80; ++exponent) {
    Scattered scattered(random, 12);
    const double gap = std::ldexp(0.2, -exponent);
    scattered.at.push_back({scattered.at[0][0] + gap, scattered.at[0][1]});
    scattered.at.push_back({0, gap});
    scattered.lift([&](double, double) { return random.uniform(-1, 1); });
    for (const Fit fit : kFits) {
      const auto normal = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      if (!normal) continue;
      EXPECT_NEAR(norm(*normal), 1, 1e-14) << name(fit);
      EXPECT_GT(dot(*normal, scattered.axis), 0) << name(fit);
    }
  }
}

TEST(FittedNormal, IsExactInNarrowNeighbourhoods) {
  Random random(9);
  for (const double width : {1e-2, 1e-4}) {
    Scattered scattered(random, 18);
    for (auto& at : scattered.at) at[1] *= width;
    scattered.lift([](double x, double y) { return 0.3 * x - 0.2 * y; });
    for (const Fit fit : kFits) {
      if (fit == Fit::Shepard) continue;
      const auto normal = fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours);
      ASSERT_TRUE(normal) << name(fit) << ' ' << width;
      EXPECT_LT(angle(*normal, scattered.normal(0.3, -0.2)), 1e-12 / (width * width)) << name(fit) << ' ' << width;
    }
  }
}

TEST(FittedNormal, LooksAtTheNearestOfVeryManyNeighbours) {
  Random random(10);
  Scattered scattered(random, 100, 0.05);
  scattered.lift(wave);
  std::vector<Vec3> nearest = scattered.neighbours;
  std::sort(nearest.begin(), nearest.end(),
            [&](const Vec3& a, const Vec3& b) { return distance(a, scattered.point) < distance(b, scattered.point); });
  nearest.resize(kMaxFittedNeighbours);
  std::vector<Vec3> in_order;
  for (const Vec3& p : scattered.neighbours) {
    if (std::find(nearest.begin(), nearest.end(), p) != nearest.end()) in_order.push_back(p);
  }
  for (const Fit fit : kFits) {
    EXPECT_EQ(fitted_normal(fit, scattered.point, scattered.axis, scattered.neighbours),
              fitted_normal(fit, scattered.point, scattered.axis, in_order))
        << name(fit);
  }
}

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

/// Square plate of n x n cells in the plane z = 0.
mesh::SurfaceMesh plate(std::size_t n) {
  std::vector<Vec3> points;
  std::vector<shapes::Corners> faces;
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) points.emplace_back(static_cast<double>(i), static_cast<double>(j), 0);
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j * (n + 1) + i, b = a + n + 1;
      faces.push_back({a, a + 1, b + 1});
      faces.push_back({a, b + 1, b});
    }
  }
  return shapes::make_surface(points, faces);
}

TEST(FittedNormal, KnowsQuadraticsUpToTheBoundary) {
  const auto height = [](double x, double y) { return 0.1 * x - 0.2 * y + 0.05 * x * x - 0.03 * x * y + 0.02 * y * y; };
  const auto surface =
      shapes::mapped(plate(6), [&](const Vec3& p) { return Vec3(p.x(), p.y(), height(p.x(), p.y())); });
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

/// Vertices within n_rings edges, by brute force over all faces.
std::set<VertexId> within(const mesh::SurfaceMesh& surface, VertexId v, int n_rings) {
  std::set<VertexId> found = {v};
  for (int ring = 0; ring < n_rings; ++ring) {
    std::set<VertexId> next = found;
    for (const auto& face : surface.faces) {
      const bool touches = std::any_of(face.begin(), face.end(), [&](VertexId w) { return found.contains(w); });
      if (touches) next.insert(face.begin(), face.end());
    }
    found = next;
  }
  found.erase(v);
  return found;
}

TEST(Neighbourhood, HoldsEachVertexOfTheRingsOnce) {
  for (const auto& surface : {shapes::sphere(2), plate(5), shapes::cube()}) {
    const mesh::Topology topology(surface);
    Neighbourhood neighbourhood(topology);
    for (const VertexId v : surface.points.ids()) {
      for (const int n_rings : {1, 2, 3}) {
        const auto found = neighbourhood.of(v, n_rings);
        const std::set<VertexId> unique(found.begin(), found.end());
        EXPECT_EQ(unique.size(), found.size());
        EXPECT_EQ(unique, within(surface, v, n_rings)) << v.index() << " with rings: " << n_rings;
      }
      EXPECT_TRUE(neighbourhood.of(v, 0).empty());
    }
  }
}

TEST(Neighbourhood, StartsWithTheFirstRingInItsOrder) {
  const auto surface = plate(4);
  const mesh::Topology topology(surface);
  Neighbourhood neighbourhood(topology);
  for (const VertexId v : surface.points.ids()) {
    std::vector<VertexId> ring;
    for (const HalfedgeId h : topology.fan(v)) ring.push_back(topology.target(h));
    if (topology.is_boundary(v)) ring.push_back(topology.origin(mesh::Topology::previous(topology.fan(v).back())));
    const auto found = neighbourhood.of(v);
    ASSERT_GE(found.size(), ring.size());
    EXPECT_TRUE(std::equal(ring.begin(), ring.end(), found.begin()));
  }
}

TEST(Neighbourhood, DoesNotReachThroughAHub) {
  const std::size_t n = 3000;
  const auto surface = shapes::cone(n, 1);
  const mesh::Topology topology(surface);
  Neighbourhood neighbourhood(topology);
  EXPECT_EQ(neighbourhood.of(VertexId(0)).size(), n + 1);  // the tip sees the whole rim and, through it, the base
  EXPECT_EQ(neighbourhood.of(VertexId(2)).size(), 6u);     // two rim vertices on either side, tip and base
}

}  // namespace
}  // namespace nearwall::surface

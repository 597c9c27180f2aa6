#include "studies/interpolants.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "studies/random.h"
#include "studies/test_functions.h"

namespace nearwall::studies {
namespace {

using Function = std::function<Jet(const Point2&)>;
using Interpolant = std::function<Jet(std::size_t triangle, const Point2& p)>;

/// Random points, their triangulation, and a function known at them.
class Data {
 public:
  explicit Data(const Function& f) : points_(60) {
    RandomStream random(3, 0);
    for (Point2& p : points_) p = {random.uniform(), random.uniform()};
    triangles_ = delaunay(points_);
    splits_ = powell_sabin_splits(points_, triangles_);
    for (const Point2& p : points_) known_.push_back(f(p));
  }

  const std::vector<Triangle2>& triangles() const { return triangles_; }
  const std::vector<Point2>& points() const { return points_; }

  HermiteTriangle triangle(std::size_t i) const {
    HermiteTriangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangles_[i][k];
      t.corner[k] = points_[v], t.value[k] = known_[v].value, t.gradient[k] = {known_[v].dx, known_[v].dy};
    }
    return t;
  }

  std::array<std::pair<const char*, Interpolant>, 2> interpolants() const {
    return {{{"Clough-Tocher", [this](std::size_t i, const Point2& p) { return clough_tocher(triangle(i), p); }},
             {"Powell-Sabin",
              [this](std::size_t i, const Point2& p) { return powell_sabin(triangle(i), splits_[i], p); }}}};
  }

  /// A point of triangle i by barycentric coordinates u, v.
  Point2 inside(std::size_t i, double u, double v) const {
    const auto& [a, b, c] = triangle(i).corner;
    const double w = 1 - u - v;
    return {u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y};
  }

 private:
  std::vector<Point2> points_;
  std::vector<Triangle2> triangles_;
  std::vector<PowellSabinSplit> splits_;
  std::vector<Jet> known_;
};

Jet quadratic(const Point2& p) {
  const Jet x{p.x, 1, 0}, y{p.y, 0, 1};
  return 3.0 * x * x - 2.0 * x * y + 0.7 * y * y - 1.3 * x + 0.4 * y + 2.0;
}

Jet wavy(const Point2& p) { return test_function(5, p.x, p.y); }

void expect_near(const Jet& a, const Jet& b, double tolerance, const char* what) {
  EXPECT_NEAR(a.value, b.value, tolerance) << what;
  EXPECT_NEAR(a.dx, b.dx, tolerance) << what;
  EXPECT_NEAR(a.dy, b.dy, tolerance) << what;
}

TEST(Interpolants, ReproduceQuadratics) {
  const Data data(quadratic);
  for (const auto& [name, interpolant] : data.interpolants()) {
    RandomStream random(4, 0);
    for (std::size_t i = 0; i < data.triangles().size(); ++i) {
      const double u = random.uniform(), v = (1 - u) * random.uniform();
      const Point2 p = data.inside(i, u, v);
      // Thin triangles lose digits in their gradients.
      expect_near(interpolant(i, p), quadratic(p), 1e-9, name);
    }
  }
}

TEST(Interpolants, HaveTheGivenValuesAndGradientsAtTheCorners) {
  const Data data(wavy);
  for (const auto& [name, interpolant] : data.interpolants()) {
    for (std::size_t i = 0; i < data.triangles().size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Point2 p = data.points()[data.triangles()[i][k]];
        expect_near(interpolant(i, p), wavy(p), 1e-7, name);
      }
    }
  }
}

TEST(Interpolants, AreSmoothAcrossSides) {
  const Data data(wavy);
  int n_shared = 0;
  for (const auto& [name, interpolant] : data.interpolants()) {
    for (std::size_t i = 0; i < data.triangles().size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        std::vector<std::uint32_t> shared;
        for (const std::uint32_t v : data.triangles()[i]) {
          for (const std::uint32_t w : data.triangles()[j]) {
            if (v == w) shared.push_back(v);
          }
        }
        if (shared.size() != 2) continue;
        ++n_shared;
        const Point2 a = data.points()[shared[0]], b = data.points()[shared[1]];
        for (const double t : {0.1, 0.37, 0.5, 0.83}) {
          const Point2 p = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
          expect_near(interpolant(i, p), interpolant(j, p), 1e-7, name);
        }
      }
    }
  }
  EXPECT_GT(n_shared, 200);
}

/// Largest change of the derivatives from one to the next of n points of a path across the triangle.
double largest_jump(const Data& data, const Interpolant& interpolant, std::size_t i, int n) {
  double jump = 0;
  Jet before;
  for (int step = 0; step <= n; ++step) {
    const double t = static_cast<double>(step) / n;
    const Jet at = interpolant(i, data.inside(i, 0.05 + 0.8 * t, 0.3 - 0.2 * t));
    if (step > 0) jump = std::max({jump, std::abs(at.dx - before.dx), std::abs(at.dy - before.dy)});
    before = at;
  }
  return jump;
}

TEST(Interpolants, AreSmoothInsideTriangles) {
  // The path crosses the lines along which the parts meet. A jump there would not shrink with the step.
  const Data data(wavy);
  for (const auto& [name, interpolant] : data.interpolants()) {
    for (std::size_t i = 0; i < data.triangles().size(); ++i) {
      EXPECT_LT(largest_jump(data, interpolant, i, 2000), 0.3 * largest_jump(data, interpolant, i, 500)) << name;
    }
  }
}

TEST(Interpolants, DeriveWhatTheyInterpolate) {
  const Data data(wavy);
  constexpr double kStep = 1e-7;
  for (const auto& [name, interpolant] : data.interpolants()) {
    const Point2 p = data.inside(7, 0.21, 0.33);
    const Jet at = interpolant(7, p);
    EXPECT_NEAR(at.dx, (interpolant(7, {p.x + kStep, p.y}).value - at.value) / kStep, 1e-4) << name;
    EXPECT_NEAR(at.dy, (interpolant(7, {p.x, p.y + kStep}).value - at.value) / kStep, 1e-4) << name;
  }
}

class TestFunctions : public testing::TestWithParam<int> {};

TEST_P(TestFunctions, HaveTheDerivativesOfTheirValues) {
  constexpr double kStep = 1e-6;
  RandomStream random(6, static_cast<std::uint64_t>(GetParam()));
  const auto f = [](double x, double y) { return test_function(GetParam(), x, y); };
  for (int sample = 0; sample < 100; ++sample) {
    const double x = random.uniform(0.05, 0.95), y = random.uniform(0.05, 0.95);
    const Jet at = f(x, y);
    const double scale = 1 + std::abs(at.dx) + std::abs(at.dy);
    EXPECT_NEAR(at.dx, (f(x + kStep, y).value - f(x - kStep, y).value) / (2 * kStep), 1e-6 * scale);
    EXPECT_NEAR(at.dy, (f(x, y + kStep).value - f(x, y - kStep).value) / (2 * kStep), 1e-6 * scale);
  }
}

INSTANTIATE_TEST_SUITE_P(Numbers, TestFunctions, testing::Range(1, kTestFunctions + 1));

TEST(TestFunctions, HaveKnownValues) {
  EXPECT_DOUBLE_EQ(test_function(2, 0.3, 0.3).value, 1.0 / 9);
  EXPECT_DOUBLE_EQ(test_function(3, 1.0 / 3, 0).value, 2.25 / 6);
  EXPECT_DOUBLE_EQ(test_function(4, 0.5, 0.5).value, 1.0 / 3);
  EXPECT_DOUBLE_EQ(test_function(5, 0, 0).value, 1);
  EXPECT_DOUBLE_EQ(test_function(6, 0.5, 0.5).value, 8.0 / 9 - 0.5);
  EXPECT_DOUBLE_EQ(test_function(7, 0.67, 0).value, 1 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(test_function(8, 0.3, 0.3).value, 50 + std::exp(-4.0));
  EXPECT_DOUBLE_EQ(test_function(9, 0.5, 0.25).value, 1);
}

}  // namespace
}  // namespace nearwall::studies

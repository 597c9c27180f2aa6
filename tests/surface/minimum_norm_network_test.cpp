#include "nearwall/surface/minimum_norm_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"
#include "tests/support/shapes.h"
#include "tests/surface/fans.h"
#include "tests/surface/long_system.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;
using fans::Random;
using Normals = IdVector<VertexId, Vec3>;

Normals network(const mesh::SurfaceMesh& surface, const Normals& axes) {
  return minimum_norm_network_normals(surface, mesh::Topology(surface), axes).direction;
}

double wave(double x, double y) { return 0.4 * std::sin(2 * x + y) + 0.3 * std::cos(3 * y - x); }

/// Height field over n x n cells of the unit square whose points are moved by up to a quarter of a cell.
template <class Height>
mesh::SurfaceMesh height_field(std::size_t n, unsigned seed, Height&& height) {
  Random random(seed);
  std::vector<Vec3> points;
  std::vector<shapes::Corners> faces;
  const double size = 1.0 / static_cast<double>(n);
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) {
      const double x = (static_cast<double>(i) + random.uniform(-0.25, 0.25)) * size;
      const double y = (static_cast<double>(j) + random.uniform(-0.25, 0.25)) * size;
      points.emplace_back(x, y, height(x, y));
    }
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

std::set<std::pair<VertexId, VertexId>> edges(const mesh::SurfaceMesh& surface) {
  std::set<std::pair<VertexId, VertexId>> found;
  for (const auto& face : surface.faces) {
    for (std::size_t k = 0; k < 3; ++k) found.insert(std::minmax(face[k], face[(k + 1) % 3]));
  }
  return found;
}

/// Integral of the squared second derivative along all edges, each as the cubic over its projection square to the mean
/// of its ends' axes: by Simpson's rule, which is exact for the square of a straight line.
long double energy(const mesh::SurfaceMesh& surface, const Normals& axes, const Normals& normals) {
  using fans::Long;
  long double sum = 0;
  for (const auto& [v, w] : edges(surface)) {
    const Long d = fans::to_long(surface.points[w]) - fans::to_long(surface.points[v]);
    const Long n = fans::unit(fans::to_long(axes[v]) + fans::to_long(axes[w]));
    const long double rise = dot(d, n), run = std::sqrt(dot(d, d) - rise * rise);
    const Long u = {(d.x - n.x * rise) / run, (d.y - n.y * rise) / run, (d.z - n.z * rise) / run};
    const auto slope = [&](VertexId end) {
      const Long axis = fans::to_long(axes[end]), normal = fans::to_long(normals[end]);
      // The normal with unit part along its axis, over the axis' part along the edge's n.
      return -dot(normal, u) / dot(normal, axis) / dot(axis, n);
    };
    const long double at_v = slope(v), at_w = slope(w), chord = rise / run;
    const auto second = [&](long double t) {
      return ((6 * t - 4) * at_v + (6 * t - 2) * at_w + (6 - 12 * t) * chord) / run;
    };
    const auto square = [](long double s) { return s * s; };
    sum += run * (square(second(0)) + 4 * square(second(0.5L)) + square(second(1))) / 6;
  }
  return sum;
}

Normals area_normals(const mesh::SurfaceMesh& surface) {
  Normals normals(surface.points.size());
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    for (const VertexId v : surface.faces[f]) normals[v] += cross(b - a, c - a);
  }
  for (Vec3& normal : normals) normal = normalized(normal);
  return normals;
}

Normals all_along(const mesh::SurfaceMesh& surface, const Vec3& axis) { return Normals(surface.points.size(), axis); }

double angle(const Vec3& a, const Vec3& b) { return geometry::angle_between(a, b); }

TEST(MinimumNormNetwork, IsExactOnAPlaneSeenAlongAnyOneAxis) {
  const auto surface = height_field(6, 1, [](double x, double y) { return 0.7 * x - 1.3 * y; });
  const Vec3 expected = normalized(Vec3(-0.7, 1.3, 1));
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0.3, 0.2, 2), expected}) {
    for (const Vec3& normal : network(surface, all_along(surface, axis))) EXPECT_LT(angle(normal, expected), 1e-13);
  }
}

TEST(MinimumNormNetwork, HasTheLeastEnergyOfAllNetworks) {
  Random random(2);
  const auto field = height_field(6, 2, wave);
  const auto ball = shapes::mapped(shapes::sphere(2), [](const Vec3& p) { return p * (1 + 0.1 * wave(p.x(), p.z())); });
  const std::vector<std::pair<mesh::SurfaceMesh, Normals>> networks = {{field, all_along(field, {0, 0, 1})},
                                                                       {ball, area_normals(ball)}};
  for (const auto& [surface, axes] : networks) {
    const Normals best = network(surface, axes);
    const long double least = energy(surface, axes, best);
    for (int trial = 0; trial < 50; ++trial) {
      // Slopes change by equal amounts to both sides, so the first-order terms must be nil: normals with unit part
      // along the axis.
      const double size = std::ldexp(1.0, -trial / 4);
      Normals more = best, less = best;
      for (const VertexId v : best.ids()) {
        if (random.integer(0, 3) != 0) continue;
        const Vec3 push = random.direction(), change = (push - axes[v] * dot(push, axes[v])) * size;
        const Vec3 normal = best[v] / dot(best[v], axes[v]);
        more[v] = normal + change, less[v] = normal - change;
      }
      const long double above = energy(surface, axes, more) - least, below = energy(surface, axes, less) - least;
      EXPECT_GT(above, 0);
      EXPECT_GT(below, 0);
      EXPECT_LT(std::abs(above - below), 1e-10L * least + 1e-6L * (above + below));
    }
  }
}

TEST(MinimumNormNetwork, AgreesWithADenseSolution) {
  const auto surface = height_field(3, 3, wave);
  const Normals axes = all_along(surface, {0, 0, 1});
  const std::size_t n = 2 * surface.points.size();
  std::vector<double> slopes(n);
  const auto energy_at = [&] {
    Normals normals(surface.points.size());
    for (const VertexId v : normals.ids()) normals[v] = Vec3(-slopes[2 * v.index()], -slopes[2 * v.index() + 1], 1);
    return energy(surface, axes, normals);
  };
  // Coefficients of the quadratic energy from its values at unit slopes and sums of two.
  const long double at_zero = energy_at();
  std::vector<long double> at_one(n);
  for (std::size_t i = 0; i < n; ++i) {
    slopes[i] = 1;
    at_one[i] = energy_at();
    slopes[i] = 0;
  }
  LongSystem system(n, std::vector<long double>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      slopes[i] += 1, slopes[j] += 1;
      system[i][j] = energy_at() - at_one[i] - at_one[j] + at_zero;
      slopes[i] = slopes[j] = 0;
    }
    system[i][n] = -(at_one[i] - at_zero - system[i][i] / 2);
  }
  const auto expected = solved(std::move(system));
  const Normals normals = network(surface, axes);
  for (const VertexId v : normals.ids()) {
    const auto a = static_cast<double>(expected[2 * v.index()]), b = static_cast<double>(expected[2 * v.index() + 1]);
    EXPECT_LT(angle(normals[v], Vec3(-a, -b, 1)), 1e-12);
  }
}

TEST(MinimumNormNetwork, ConvergesOnASphere) {
  std::array<double, 2> worst{};
  for (const int level : {3, 4}) {
    const auto surface = shapes::sphere(level);
    const Normals normals = network(surface, area_normals(surface));
    double& error = worst[static_cast<std::size_t>(level - 3)];
    for (const VertexId v : normals.ids()) error = std::max(error, angle(normals[v], surface.points[v]));
  }
  EXPECT_GT(std::log2(worst[0] / worst[1]), 0.9);
}

TEST(MinimumNormNetwork, TurnsWithTheSurface) {
  Random random(4);
  const auto surface = shapes::mapped(shapes::sphere(2), [](const Vec3& p) { return p * (1 + wave(p.x(), p.z())); });
  const Normals axes = area_normals(surface), expected = network(surface, axes);
  const Vec3 x = random.direction(), y = normalized(cross(x, random.direction())), z = cross(x, y);
  const auto turned = [&](const Vec3& v) { return x * v.x() + y * v.y() + z * v.z(); };
  Normals turned_axes = axes;
  for (Vec3& axis : turned_axes) axis = turned(axis);
  const Normals normals = network(shapes::mapped(surface, turned), turned_axes);
  for (const VertexId v : normals.ids()) EXPECT_LT(angle(normals[v], turned(expected[v])), 1e-12);
}

TEST(MinimumNormNetwork, IsTheSameBitsAtAllScalesOnAllThreadsAndOnShiftedAxes) {
  const auto surface = shapes::mapped(shapes::sphere(3), [](const Vec3& p) { return p * (1 + wave(p.x(), p.z())); });
  const Normals axes = area_normals(surface), expected = network(surface, axes);
  for (const int exponent : {-400, -3, 5, 400}) {
    EXPECT_EQ(network(shapes::scaled(surface, std::ldexp(1.0, exponent)), axes), expected) << exponent;
  }
  for (const int n_threads : {1, 2, 4}) {
    const ThreadLimit limit(n_threads);
    EXPECT_EQ(network(surface, axes), expected) << n_threads;
  }
  const auto shifted = [](const Vec3& v) { return Vec3(v.y(), v.z(), v.x()); };
  Normals shifted_axes = axes, shifted_expected = expected;
  for (Vec3& axis : shifted_axes) axis = shifted(axis);
  for (Vec3& normal : shifted_expected) normal = shifted(normal);
  EXPECT_EQ(network(shapes::mapped(surface, shifted), shifted_axes), shifted_expected);
}

TEST(MinimumNormNetwork, KeepsTheAxisWhereEdgesLeaveTheTangentPlaneOpen) {
  auto surface = height_field(3, 5, wave);
  const VertexId alone = surface.points.push_back({5, 5, 5});
  // A triangle without area and one that stands upright as seen along the axis.
  for (const Vec3& p : {Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(5, 0, 1), Vec3(2, 2, 0), Vec3(2, 2, 1), Vec3(2, 2, 3)}) {
    surface.points.push_back(p);
  }
  for (const std::size_t first : {std::size_t{alone.index()} + 1, std::size_t{alone.index()} + 4}) {
    shapes::add_face(surface, {first, first + 1, first + 2});
  }
  const Vec3 axis(0, 0, 2);
  const NetworkNormals normals =
      minimum_norm_network_normals(surface, mesh::Topology(surface), all_along(surface, axis));
  for (const VertexId v : surface.points.ids()) {
    const bool is_open = v.index() >= alone.index();
    EXPECT_EQ(normals.is_axis[v] != 0, is_open) << v.index();
    EXPECT_EQ(normals.direction[v] == Vec3(0, 0, 1), is_open) << v.index();
  }
}

TEST(MinimumNormNetwork, LeavesOutEdgesTooShortForTheirEnergy) {
  // The last vertex is the first but for 1e-300 of the other edges.
  const auto surface = shapes::make_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, -1}, {-1, 0, 0}, {0, -1e-300, 0}},
                                            {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
  const Vec3 z(0, 0, 1), expected = normalized(Vec3(0, 1, 1));
  const NetworkNormals normals = minimum_norm_network_normals(surface, mesh::Topology(surface), all_along(surface, z));
  for (const std::size_t v : {0, 1, 2, 3}) {
    EXPECT_LT(angle(normals.direction[VertexId(v)], expected), 1e-14) << v;
    EXPECT_FALSE(normals.is_axis[VertexId(v)]) << v;
  }
  EXPECT_EQ(normals.direction[VertexId(4)], z);  // the edges left to it are on one line
  EXPECT_TRUE(normals.is_axis[VertexId(4)]);
}

TEST(MinimumNormNetwork, MakesPointNormalsTellWhereTheAxisStandsIn) {
  // All edges of the second triangle have one direction, up to 1e-7.
  const auto surface = shapes::make_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 0, 0}, {4, 0, 0}, {5, 1e-7, 0}},
                                            {{0, 1, 2}, {3, 4, 5}});
  const mesh::Topology topology(surface);
  const NormalOptions options{.method = NormalMethod::Nielson, .thin_angle = std::numbers::pi};
  const auto normals = point_normals(surface, topology, find_features(surface, topology), options);
  for (const VertexId v : normals.ids()) {
    EXPECT_EQ(normals[v].is_fallback, v.index() >= 3) << v.index();
    EXPECT_LT(distance(normals[v].direction, {0, 0, 1}), 1e-9) << v.index();
  }
}

TEST(MinimumNormNetwork, LeavesEdgesAlongTheAxisOut) {
  // Two upright triangles share the edge along the axis; seen from above, 0 still has two edges square to each other.
  const auto surface = shapes::make_surface({{0, 0, 0}, {1, 0, 0.5}, {0, 0, 1}, {0, 1, -1}}, {{0, 1, 2}, {0, 2, 3}});
  const Normals normals = network(surface, all_along(surface, {0, 0, 1}));
  // 1 and 3 have one direction each and keep slope 0; at 0, 2 g0 + g1 = 0 along either edge: g0 is a quarter and a
  // half.
  EXPECT_LT(angle(normals[VertexId(0)], Vec3(-0.75, 1.5, 1)), 1e-14);
  for (const Vec3& normal : normals) EXPECT_NEAR(norm(normal), 1, 1e-15);
}

TEST(MinimumNormNetwork, GivesUnitVectorsOnTheAxesSideWhateverTheAxes) {
  Random random(6);
  const auto surface = shapes::sphere(2);
  for (int trial = 0; trial < 20; ++trial) {
    Normals axes(surface.points.size());
    for (Vec3& axis : axes) axis = random.direction() * random.uniform(0.1, 10);
    for (const auto& face : surface.faces) {
      if (random.integer(0, 9) == 0) axes[face[0]] = -axes[face[1]];
    }
    axes[VertexId(0)] = {};
    const Normals normals = network(surface, axes);
    EXPECT_EQ(normals[VertexId(0)], Vec3{});
    for (std::size_t i = 1; i < normals.size(); ++i) {
      const VertexId v(i);
      EXPECT_EQ(norm(normals[v]) > 0.5, axes[v] != Vec3{});
      if (axes[v] == Vec3{}) continue;
      EXPECT_NEAR(norm(normals[v]), 1, 1e-14);
      EXPECT_GT(dot(normals[v], axes[v]), 0);
    }
  }
}

/// What the refusal says; nothing if there is none.
std::string refusal(const mesh::SurfaceMesh& surface, const Normals& axes) {
  try {
    network(surface, axes);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(MinimumNormNetwork, RefusesWhatIsNotFiniteAndSaysWhere) {
  auto surface = shapes::octahedron();
  Normals axes = area_normals(surface);
  axes[VertexId(3)] = {0.5, std::numeric_limits<double>::infinity(), 2};
  EXPECT_NE(refusal(surface, axes).find("found vertex 3 at"), std::string::npos);
  EXPECT_NE(refusal(surface, axes).find("axis (0.5, inf, 2)"), std::string::npos);
  axes = area_normals(surface);
  surface.points[VertexId(2)] = {std::numeric_limits<double>::quiet_NaN(), 0.25, 4};
  EXPECT_NE(refusal(surface, axes).find("found vertex 2 at (nan, 0.25, 4)"), std::string::npos);
  surface.points[VertexId(2)] = {1e308, 1e308, 1e308};
  surface.points[VertexId(4)] = {-1e308, -1e308, -1e308};
  EXPECT_NE(refusal(surface, axes).find("longer than doubles"), std::string::npos);
}

}  // namespace
}  // namespace nearwall::surface

#include "nearwall/surface/smoothing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/predicates/orientation.h"
#include "tests/surface/smoothed.h"

namespace nearwall::surface {
namespace {

using namespace smoothed;

constexpr double kRightAngle = std::numbers::pi / 2;

constexpr std::array kFilters = {SmoothingFilter::Laplacian, SmoothingFilter::Taubin, SmoothingFilter::MostVisible,
                                 SmoothingFilter::MostVisibleTaubin};

TEST(SmoothNormals, LeavesAConstantFieldAsItIs) {
  const Prepared plate(shapes::plate(6));
  for (const SmoothingFilter filter : kFilters) {
    for (const PointNormal& normal : plate.smoothed(plate.normals(), sweeps(filter, 10))) {
      EXPECT_EQ(normal.direction, Vec3(0, 0, 1));
      EXPECT_TRUE(normal.is_visible);
    }
  }
}

TEST(SmoothNormals, ChangesNothingWithoutSweepsOrFilter) {
  const Prepared rough(bumpy_sphere(3, 0.1, 1));
  const Normals before = rough.normals();
  for (const auto& options : {sweeps(SmoothingFilter::None, 5), sweeps(SmoothingFilter::Taubin, 0)}) {
    const Normals after = rough.smoothed(before, options);
    for (const VertexId v : before.ids()) EXPECT_EQ(after[v].direction, before[v].direction);
  }
}

TEST(SmoothNormals, EvensOutNoiseSweepBySweep) {
  const Prepared wavy(waves(24));
  const Normals noisy = disturbed(wavy.normals(), 0.2, 2);
  for (const SmoothingFilter filter : kFilters) {
    double before = wavy.roughness(noisy);
    for (const int n : {1, 2, 4, 8}) {
      const double after = wavy.roughness(wavy.smoothed(noisy, sweeps(filter, n)));
      EXPECT_LT(after, before);
      before = after;
    }
  }
}

TEST(SmoothNormals, TaubinKeepsLongWavesThatLaplacianFlattens) {
  const Prepared wavy(waves(48));
  const Normals before = wavy.normals();
  const auto amplitude = [&](const Normals& normals) {
    double sum = 0;
    for (const PointNormal& normal : normals) sum += 1.0 - normal.direction.z();
    return sum;
  };
  const double laplacian = amplitude(wavy.smoothed(before, sweeps(SmoothingFilter::Laplacian, 40))) / amplitude(before);
  const double taubin = amplitude(wavy.smoothed(before, sweeps(SmoothingFilter::Taubin, 40))) / amplitude(before);
  EXPECT_LT(laplacian, 0.9);
  EXPECT_NEAR(taubin, 1, 0.05);
}

TEST(SmoothNormals, FollowsTheFormulaOfTaubinsTwoSteps) {
  const Prepared wavy(waves(8));
  const Normals before = wavy.normals();
  const SmoothingOptions options = sweeps(SmoothingFilter::Taubin, 1);
  IdVector<VertexId, Vec3> direction(before.size());
  for (const VertexId v : before.ids()) direction[v] = before[v].direction;
  for (const double step : {options.lambda, options.mu}) {
    auto moved = direction;
    for (const VertexId v : before.ids()) {
      // Neighbours from the faces: each one is met twice, on a boundary once.
      std::map<VertexId, Vec3> ring;
      for (const auto& face : wavy.surface.faces) {
        if (std::find(face.begin(), face.end(), v) == face.end()) continue;
        for (const VertexId other : face) ring[other] = direction[other];
      }
      ring.erase(v);
      Vec3 mean;
      for (const auto& [other, d] : ring) mean += d / static_cast<double>(ring.size());
      moved[v] = normalized(direction[v] + (mean - direction[v]) * step);
    }
    direction = moved;
  }
  const Normals after = wavy.smoothed(before, options);
  for (const VertexId v : before.ids()) EXPECT_NEAR(distance(after[v].direction, direction[v]), 0, 1e-14);
}

TEST(SmoothNormals, HoldsImposedNormals) {
  const Prepared wavy(waves(16));
  const Normals before = disturbed(wavy.normals(), 0.1, 8);
  IdVector<VertexId, char> is_held(before.size(), 0);
  for (const VertexId v : before.ids()) is_held[v] = wavy.topology.is_boundary(v);
  for (const SmoothingFilter filter : kFilters) {
    Normals after = before;
    smooth_normals(wavy.surface, wavy.topology, wavy.features, sweeps(filter, 5), after, is_held);
    for (const VertexId v : before.ids()) EXPECT_EQ(after[v].direction == before[v].direction, is_held[v] != 0);
  }
}

TEST(SmoothingFilter, GoesByItsName) {
  for (std::size_t k = 0; k < kSmoothingFilterNames.size(); ++k) {
    const auto filter = static_cast<SmoothingFilter>(k);
    EXPECT_EQ(smoothing_filter(filter_name(filter)), filter);
  }
  EXPECT_EQ(filter_name(SmoothingFilter::MostVisibleTaubin), "most-visible-taubin");
  EXPECT_FALSE(smoothing_filter("taubim"));
}

TEST(SmoothNormals, NeverLosesSightNorMoreThanHalfTheRoom) {
  int n_at_the_edge = 0;
  for (const double height : {0.02, 0.1, 0.25}) {
    // Hardly anything counts as a ridge or a tip here, so that all vertices move.
    const Prepared rough(bumpy_sphere(4, height, 3), {3.0, 3.0, 1.5});
    const Normals before = rough.normals();
    for (const SmoothingFilter filter : kFilters) {
      const Normals after = rough.smoothed(before, sweeps(filter, 30));
      for (const VertexId v : before.ids()) {
        if (!before[v].is_visible) continue;
        const std::vector<Vec3> faces = rough.faces_at(v);
        for (const Vec3& face : faces) {
          EXPECT_EQ(predicates::sign_of_dot(face, after[v].direction), predicates::Sign::Positive);
        }
        const double angle = static_cast<double>(fans::worst_angle(fans::to_long(after[v].direction), faces));
        const double room_left = (kRightAngle - angle) / (kRightAngle - before[v].max_angle);
        EXPECT_GT(room_left, 0.5 - 1e-9);
        EXPECT_NEAR(after[v].max_angle, angle, 1e-14);
        EXPECT_TRUE(after[v].is_visible);
        n_at_the_edge += room_left < 0.5 + 1e-9;
      }
    }
  }
  EXPECT_GT(n_at_the_edge, 100) << "the surfaces are too tame to show anything";
}

TEST(SmoothNormals, HoldsCornersRidgeEndsAndTips) {
  const Prepared rough(bumpy_sphere(4, 0.15, 4));
  const Normals before = rough.normals();
  const Normals after = rough.smoothed(before, sweeps(SmoothingFilter::Laplacian, 5));
  int n_held = 0, n_moved = 0;
  for (const VertexId v : before.ids()) {
    const PointKind kind = rough.features.kind[v];
    if (kind == PointKind::Smooth || kind == PointKind::Ridge) {
      n_moved += after[v].direction != before[v].direction;
    } else {
      EXPECT_EQ(after[v].direction, before[v].direction);
      ++n_held;
    }
  }
  EXPECT_GT(n_held, 100);
  EXPECT_GT(n_moved, 100);
}

TEST(SmoothNormals, LooksAlongTheRidgeOnlyAtRidges) {
  const Prepared cube(shapes::subdivided(shapes::subdivided(shapes::subdivided(shapes::cube()))));
  const Normals plain = cube.normals();
  Normals other = plain;
  Random random(5);
  for (const VertexId v : other.ids()) {
    if (cube.features.kind[v] != PointKind::Smooth) continue;
    other[v].direction = normalized(other[v].direction + random.direction() * 0.3);
  }
  const SmoothingOptions options = sweeps(SmoothingFilter::Taubin, 6);
  const Normals a = cube.smoothed(plain, options), b = cube.smoothed(other, options);
  int n_ridge = 0, n_moved = 0;
  for (const VertexId v : plain.ids()) {
    if (cube.features.kind[v] != PointKind::Ridge) continue;
    EXPECT_EQ(a[v].direction, b[v].direction);
    n_moved += a[v].direction != plain[v].direction;
    ++n_ridge;
  }
  EXPECT_EQ(n_ridge, 12 * 7);
  EXPECT_GT(n_moved, 12);
}

TEST(SmoothNormals, HoldsBlindVertices) {
  const Prepared corner(fans::corner_that_nothing_sees());
  const Normals before = corner.normals();
  const Normals after = corner.smoothed(before, sweeps(SmoothingFilter::Laplacian, 3));
  EXPECT_EQ(after[VertexId(0)].direction, before[VertexId(0)].direction);
  EXPECT_FALSE(after[VertexId(0)].is_visible);
}

TEST(SmoothNormals, KeepsADirectionWhoseNeighboursCancel) {
  const Prepared plate(shapes::plate(2));
  const VertexId middle(4);
  Normals normals = plate.normals();
  // Six neighbours round the middle: three pairs of opposite directions.
  int k = 0;
  for (const HalfedgeId h : plate.topology.fan(middle)) {
    const double angle = k++ * std::numbers::pi / 3;
    normals[plate.topology.target(h)].direction = {std::cos(angle), std::sin(angle), 0};
  }
  ASSERT_EQ(k, 6);
  SmoothingOptions options = sweeps(SmoothingFilter::Laplacian, 1);
  options.lambda = 1;
  EXPECT_EQ(plate.smoothed(normals, options)[middle].direction, Vec3(0, 0, 1));
}

TEST(SmoothNormals, StaysFiniteOnFacesWithoutArea) {
  mesh::SurfaceMesh surface = shapes::plate(4);
  surface.points[VertexId(12)] = surface.points[VertexId(13)];
  const Prepared degenerate(surface);
  for (const PointNormal& normal : degenerate.smoothed(degenerate.normals(), sweeps(SmoothingFilter::Taubin, 3))) {
    EXPECT_NEAR(distance(normal.direction, {0, 0, 1}), 0, 1e-15);
  }
}

TEST(SmoothNormals, GivesTheSameBitsOnTurnedAxesAtAnyScaleAndOnAnyNumberOfThreads) {
  const mesh::SurfaceMesh rough = bumpy_sphere(5, 0.08, 6);
  const auto turned = [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()); };
  const SmoothingOptions options = sweeps(SmoothingFilter::Taubin, 8);
  const auto run = [&](const mesh::SurfaceMesh& surface) {
    const Prepared prepared(surface);
    return prepared.smoothed(prepared.normals(), options);
  };
  const auto run_on = [&](int n_threads) {
    const ThreadLimit limit(n_threads);
    return run(rough);
  };
  const Normals one = run_on(1), two = run_on(2);
  const Normals other = run(shapes::scaled(shapes::mapped(rough, turned), 0x1p30));
  for (const VertexId v : one.ids()) {
    ASSERT_EQ(one[v].direction, two[v].direction);
    ASSERT_EQ(one[v].max_angle, two[v].max_angle);
    ASSERT_EQ(other[v].direction, turned(one[v].direction));
  }
}

TEST(SmoothNormals, RefusesOptionsOutOfRange) {
  const Prepared cube(shapes::cube());
  const auto refused = [&](double lambda, double mu, int iterations) {
    SmoothingOptions options = sweeps(SmoothingFilter::Taubin, iterations);
    options.lambda = lambda, options.mu = mu;
    EXPECT_THROW(cube.smoothed(cube.normals(), options), InputError) << lambda << " " << mu << " " << iterations;
  };
  refused(0, -0.5, 1);
  refused(1.5, -2, 1);
  refused(0.5, -0.4, 1);
  refused(0.5, std::nan(""), 1);
  refused(0.5, -0.53, -1);
  for (const double trigger : {0.0, 1.5, std::nan("")}) {
    SmoothingOptions options = sweeps(SmoothingFilter::MostVisible, 1);
    options.trigger = trigger;
    EXPECT_THROW(cube.smoothed(cube.normals(), options), InputError) << trigger;
  }
}

}  // namespace
}  // namespace nearwall::surface

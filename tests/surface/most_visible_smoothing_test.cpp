#include <gtest/gtest.h>

#include <cmath>

#include "nearwall/surface/iterative_normals.h"
#include "tests/surface/smoothed.h"

// Filters that look for the direction that sees the neighbours' directions best.

namespace nearwall::surface {
namespace {

using namespace smoothed;

/// Directions of the vertices round v.
std::vector<Vec3> ring_of(const Prepared& surface, const Normals& normals, VertexId v) {
  std::vector<Vec3> ring;
  for (const HalfedgeId h : surface.topology.fan(v)) ring.push_back(normals[surface.topology.target(h)].direction);
  return ring;
}

TEST(SmoothNormals, MostVisibleTakesTheDirectionThatSeesItsNeighboursBest) {
  const Prepared wavy(waves(24));
  const Normals noisy = disturbed(wavy.normals(), 0.3, 7);
  SmoothingOptions options = sweeps(SmoothingFilter::MostVisible, 1);
  options.lambda = 1;
  options.trigger = 1;
  const Normals after = wavy.smoothed(noisy, options);
  for (const VertexId v : noisy.ids()) {
    if (wavy.topology.is_boundary(v)) continue;
    const std::vector<Vec3> ring = ring_of(wavy, noisy, v);
    EXPECT_NEAR(static_cast<double>(fans::worst_angle(fans::to_long(after[v].direction), ring)),
                static_cast<double>(fans::smallest_worst_angle(ring)), 1e-14);
  }
}

TEST(SmoothNormals, IterativeSearchComesToTheSameWithinItsTolerance) {
  const Prepared wavy(waves(24));
  const Normals noisy = disturbed(wavy.normals(), 0.3, 7);
  SmoothingOptions options = sweeps(SmoothingFilter::MostVisible, 1);
  options.lambda = 1;
  options.search = SearchMethod::Iterative;
  int n_searched = 0, n_within = 0;
  const Normals after = wavy.smoothed(noisy, options);
  for (const VertexId v : noisy.ids()) {
    const std::vector<Vec3> ring = ring_of(wavy, noisy, v);
    if (wavy.topology.is_boundary(v)) continue;
    const double worst = static_cast<double>(fans::worst_angle(fans::to_long(after[v].direction), ring));
    if (std::cos(worst) > kVisibilityTrigger) continue;
    n_within += worst < static_cast<double>(fans::smallest_worst_angle(ring)) + IterationOptions{}.tolerance;
    ++n_searched;
  }
  // Some iterations end after 300 steps on the way.
  EXPECT_GT(n_searched, 20);
  EXPECT_GT(n_within, 0.9 * n_searched);
}

TEST(SmoothNormals, MostVisibleTakesTheMeanWhereItSeesAllNeighboursWell) {
  const Prepared wavy(waves(24));
  const Normals noisy = disturbed(wavy.normals(), 0.3, 7);
  SmoothingOptions options = sweeps(SmoothingFilter::MostVisible, 1);
  options.lambda = 1;
  int n_means = 0, n_others = 0;
  const Normals after = wavy.smoothed(noisy, options);
  for (const VertexId v : noisy.ids()) {
    if (wavy.topology.is_boundary(v)) continue;
    const std::vector<Vec3> ring = ring_of(wavy, noisy, v);
    Vec3 mean;
    for (const Vec3& direction : ring) mean += direction / static_cast<double>(ring.size());
    mean = normalized(mean);
    const bool is_near =
        std::cos(static_cast<double>(fans::worst_angle(fans::to_long(mean), ring))) > kVisibilityTrigger;
    EXPECT_EQ(distance(after[v].direction, mean) < 1e-14, is_near);
    ++(is_near ? n_means : n_others);
  }
  EXPECT_GT(n_means, 50);
  EXPECT_GT(n_others, 50);
}

TEST(SmoothNormals, CouplingWithTaubinKeepsLongWavesThatMostVisibleFlattens) {
  const Prepared wavy(waves(48));
  const Normals before = wavy.normals();
  const auto amplitude = [&](SmoothingFilter filter) {
    double sum = 0;
    for (const PointNormal& normal : wavy.smoothed(before, sweeps(filter, 40))) sum += 1.0 - normal.direction.z();
    return sum;
  };
  const double unsmoothed = amplitude(SmoothingFilter::None);
  EXPECT_LT(amplitude(SmoothingFilter::MostVisible), 0.9 * unsmoothed);
  EXPECT_NEAR(amplitude(SmoothingFilter::MostVisibleTaubin), unsmoothed, 0.05 * unsmoothed);
}

}  // namespace
}  // namespace nearwall::surface

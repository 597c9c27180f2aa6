#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "nearwall/surface/normals.h"
#include "tests/surface/most_normal_reference.h"

// One thread; the mean over 500 random fans of each kind.

namespace nearwall::surface {
namespace {

constexpr int kFans = 500;

/// Fans whose edges rise and fall by up to `slope` [rad], mostly saddles.
void most_normal_of_fans(benchmark::State& state, double slope) {
  const int n = static_cast<int>(state.range(0));
  fans::Random random(1);
  std::vector<rings::Points> rings;
  for (int i = 0; i < kFans; ++i) {
    std::vector<rings::Polar> polars;
    for (int k = 0; k < n; ++k) {
      const double azimuth = 2 * std::numbers::pi * (k + random.uniform(-0.4, 0.4)) / n;
      polars.push_back({azimuth, std::numbers::pi / 2 + slope * random.uniform(-1, 1)});
    }
    rings.push_back(rings::ring_of(polars, random.direction(), random.direction()));
  }
  for (auto _ : state) {
    for (const rings::Points& ring : rings) benchmark::DoNotOptimize(most_normal_normal({0, 0, 0}, ring));
  }
  state.SetItemsProcessed(state.iterations() * kFans);
}

void most_normal_of_mild_fans(benchmark::State& state) { most_normal_of_fans(state, 0.1); }
void most_normal_of_rough_fans(benchmark::State& state) { most_normal_of_fans(state, 0.5); }
void most_normal_of_wild_fans(benchmark::State& state) { most_normal_of_fans(state, 1.2); }
BENCHMARK(most_normal_of_mild_fans)->Arg(6)->Arg(12)->Arg(64);
BENCHMARK(most_normal_of_rough_fans)->Arg(6)->Arg(12)->Arg(64);
BENCHMARK(most_normal_of_wild_fans)->Arg(6)->Arg(12)->Arg(64);

/// A convex corner, where the answer is the far end of the smallest cap round the edges.
void most_normal_of_a_convex_corner(benchmark::State& state) {
  const rings::Points ring = {{1, 0, -1}, {1, 2, -1.2}, {-1, 1.5, -1}, {-1, 0, -1}, {-1, -1.5, -0.8}, {1, -2, -1.1}};
  for (auto _ : state) benchmark::DoNotOptimize(most_normal_normal({0, 0, 0}, ring));
}
BENCHMARK(most_normal_of_a_convex_corner);

}  // namespace
}  // namespace nearwall::surface

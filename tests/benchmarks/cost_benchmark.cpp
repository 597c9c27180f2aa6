#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <string>

#include <benchmark/benchmark.h>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/shapes/shapes.h"
#include "tests/support/growing.h"

// What the means of coverage cost: against an extrusion that has none of them, and on surfaces of growing size.

namespace nearwall {
namespace {

using namespace growing_for_tests;

constexpr int kLayers = 20;
constexpr double kGrowth = 1.2;
constexpr double kThickness = 0.01;  // of the diagonal

layers::GrowOptions with_all_means(const mesh::SurfaceMesh& surface) {
  const double diagonal = geometry::bounding_box(surface.points.raw()).diagonal();
  return options_for(surface, geometric(kThickness * diagonal, kGrowth, kLayers));
}

/// The plain extrusion: one line for each vertex, along its most visible normal, smoothed by means of its neighbours.
/// Limits and certificate are the same.
layers::GrowOptions plain(const mesh::SurfaceMesh& surface) {
  layers::GrowOptions options = with_all_means(surface);
  options.several_lines = options.try_fans = options.lean_lines = options.search_lines = false;
  options.filter = surface::SmoothingFilter::Laplacian;
  return options;
}

double seconds_of(const layers::Wall& wall, const layers::GrowOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(layers::grow(wall, options).rounds);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Body {
  const char* shape;
  shapes::ParameterValues parameters;
  double size;
};

/// Bodies that need none of the means: smooth ones, and a wing of which the trailing edge alone is sharp.
void CostOfCoverage(benchmark::State& state, const Body& body) {
  const ThreadLimit limit(1);
  const TestWall wall(shapes::make_shape(body.shape, body.parameters, body.size));
  const auto all = with_all_means(wall.surface()), none = plain(wall.surface());
  double least_all = std::numeric_limits<double>::infinity(), least_none = least_all;
  for (auto _ : state) {  // in turn, so that other work on the machine disturbs both
    least_none = std::min(least_none, seconds_of(wall.wall(), none));
    const double taken = seconds_of(wall.wall(), all);
    least_all = std::min(least_all, taken);
    state.SetIterationTime(taken);
  }
  const auto n = static_cast<double>(wall.surface().faces.size());
  state.counters["triangles"] = n;
  state.counters["plain_us/triangle"] = 1e6 * least_none / n;
  state.counters["us/triangle"] = 1e6 * least_all / n;
  state.counters["ratio"] = least_all / least_none;
}

void with_repetitions(benchmark::internal::Benchmark* b) {
  constexpr int kTurns = 7;
  b->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(kTurns);
}

BENCHMARK_CAPTURE(CostOfCoverage, sphere, Body{"sphere", {{"subdivisions", 6}}, 0})->Apply(with_repetitions);
BENCHMARK_CAPTURE(CostOfCoverage, torus, Body{"torus", {}, 0.02})->Apply(with_repetitions);
BENCHMARK_CAPTURE(CostOfCoverage, ellipsoid, Body{"ellipsoid", {}, 0.015})->Apply(with_repetitions);
BENCHMARK_CAPTURE(CostOfCoverage, capsule, Body{"capsule", {}, 0.015})->Apply(with_repetitions);
BENCHMARK_CAPTURE(CostOfCoverage, wing, Body{"naca", {}, 0.02})->Apply(with_repetitions);

/// Bodies that need the means, ever finer under the same layers.
void CostForATriangle(benchmark::State& state, const char* shape) {
  const ThreadLimit limit(1);
  constexpr double kPerThousand = 1e-3;
  const TestWall wall(shapes::make_shape(shape, {}, kPerThousand * static_cast<double>(state.range(0))));
  const auto options = with_all_means(wall.surface());
  double least = std::numeric_limits<double>::infinity();
  for (auto _ : state) least = std::min(least, seconds_of(wall.wall(), options));
  const auto n = static_cast<double>(wall.surface().faces.size());
  state.counters["triangles"] = n;
  state.counters["us/triangle"] = 1e6 * least / n;
}

/// Edge lengths in thousandths of the shape's unit, each half of the one before: four times the triangles.
template <int kLongest>
void halving(benchmark::internal::Benchmark* b) {
  constexpr int kShare = 16;
  for (int size = kLongest; size >= kLongest / kShare; size /= 2) b->Arg(size);
  b->ArgName("edge")->Unit(benchmark::kMillisecond)->Iterations(2);
}

BENCHMARK_CAPTURE(CostForATriangle, step, "step")->Apply(halving<64>);
BENCHMARK_CAPTURE(CostForATriangle, wing_body, "wing-body")->Apply(halving<128>);

}  // namespace
}  // namespace nearwall

#include <sys/resource.h>

#include <vector>

#include <benchmark/benchmark.h>

#include "nearwall/core/parallel.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/shapes/shapes.h"
#include "tests/support/growing.h"

// A sphere of 20 · 4^7 = 327,680 triangles with 30 layers: 9.8 M wedges.

namespace nearwall {
namespace {

using namespace growing_for_tests;

constexpr int kLayers = 30;

const mesh::SurfaceMesh& big_sphere() {
  static const mesh::SurfaceMesh sphere = shapes::make_shape("sphere", {{"subdivisions", 7}});
  return sphere;
}

double n_wedges(const benchmark::State& state) {
  return double(state.iterations()) * double(big_sphere().faces.size()) * kLayers;
}

/// Everything from the surface in memory to certified layers in memory.
void WholeGrowth(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const auto heights = geometric(0.02, 1.2, kLayers);
  for (auto _ : state) {
    const TestWall wall(big_sphere());
    const auto growth = layers::grow(wall.wall(), options_for(wall.surface(), heights));
    if (growth.lines.windows[LineId(0)].end != kLayers) state.SkipWithError("layers are missing");
    benchmark::DoNotOptimize(growth.rounds);
  }
  state.counters["wedges/s"] = benchmark::Counter(n_wedges(state), benchmark::Counter::kIsRate);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);  // the peak of the program so far, in kB: the first benchmark of all
  state.counters["bytes/wedge"] = double(usage.ru_maxrss) * 1024 / (double(big_sphere().faces.size()) * kLayers);
}
BENCHMARK(WholeGrowth)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->ArgName("threads");

/// The laying of points and the wedge certificate alone.
void LayAndCertify(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const TestWall wall(big_sphere());
  const auto growth = layers::grow(wall.wall(), options_for(wall.surface(), geometric(0.02, 1.2, kLayers)));
  for (auto _ : state) {
    const auto bad = certify::bad_columns(growth.front, growth.lines);
    if (!bad.empty()) state.SkipWithError("a bad column");
  }
  state.counters["wedges/s"] = benchmark::Counter(n_wedges(state), benchmark::Counter::kIsRate);
}
BENCHMARK(LayAndCertify)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->ArgName("threads");

/// The second opinion before files are written: all of the certificate with both volumes.
void Certificate(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const TestWall wall(big_sphere());
  const auto growth = layers::grow(wall.wall(), options_for(wall.surface(), geometric(0.02, 1.2, kLayers)));
  const mesh::LayerMesh layers(growth.front, growth.lines);
  for (auto _ : state) {
    if (!certify::certify_layers(layers, wall.certified_wall()).is_valid()) state.SkipWithError("not valid");
  }
  state.counters["wedges/s"] = benchmark::Counter(n_wedges(state), benchmark::Counter::kIsRate);
}
BENCHMARK(Certificate)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->ArgName("threads");

}  // namespace
}  // namespace nearwall

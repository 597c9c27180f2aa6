#include <cmath>
#include <cstdint>

#include <benchmark/benchmark.h>

#include "nearwall/planar/crossing_edges.h"
#include "nearwall/planar/region.h"
#include "nearwall/planar/size_field.h"
#include "tests/planar/regions.h"

namespace nearwall::planar {
namespace {

/// Triangles per second of one size in a square with n edges on each side.
void refine_square(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const Outline o = Outline().loop(rectangle(0, 0, 1, 1, n));
  const double size = 1.0 / n;
  std::int64_t n_triangles = 0;
  for (auto _ : state) {
    n_triangles += std::ssize(refine_region(o.points, o.edges, [=](const Point2&) { return size; }).triangles);
  }
  state.SetItemsProcessed(n_triangles);
}
BENCHMARK(refine_square)->Arg(200)->Arg(620)->Unit(benchmark::kMillisecond);

/// Triangles per second between a circle of n edges and a box of ten of its diameters.
void refine_round_circle(benchmark::State& state) {
  const Outline o = Outline().loop(rectangle(-5, -5, 5, 5, 4)).hole(ring(0, 0, 0.5, static_cast<int>(state.range(0))));
  std::int64_t n_triangles = 0;
  for (auto _ : state) {
    const GradedSize size(o.points, o.edges, {0.3});
    n_triangles += std::ssize(refine_region(o.points, o.edges, size).triangles);
  }
  state.SetItemsProcessed(n_triangles);
}
BENCHMARK(refine_round_circle)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// Edges per second of a circle that does not cross itself.
void crossings_of_circle(benchmark::State& state) {
  const Outline o = Outline().loop(ring(0, 0, 1, static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(crossing_edges(o.points, o.edges));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(crossings_of_circle)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nearwall::planar

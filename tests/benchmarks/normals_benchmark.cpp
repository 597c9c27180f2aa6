#include <cmath>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "nearwall/core/parallel.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"
#include "nearwall/surface/smoothing.h"
#include "tests/support/shapes.h"

// One thread; bodies of 262,146 points. Points per second; the sweeps' rates are of whole sweeps, preparation included.

namespace nearwall::surface {
namespace {

constexpr int kSweeps = 20;

/// A sphere, smooth or with a ripple that makes ridges and sharp vertices all over.
struct Body {
  mesh::SurfaceMesh surface;
  mesh::Topology topology;
  Features features;
  explicit Body(double ripple)
      : surface(shapes_for_tests::mapped(
            shapes_for_tests::sphere(8),
            [&](const Vec3& p) { return p * (1.0 + ripple * std::sin(90 * p.x()) * std::cos(110 * p.y())); })),
        topology(surface),
        features(find_features(surface, topology)) {}
  std::int64_t n_points() const { return static_cast<std::int64_t>(surface.points.size()); }
};

const Body& smooth_body() {
  static const Body body(0);
  return body;
}
const Body& rippled_body() {
  static const Body body(0.02);
  return body;
}

void normals_of(benchmark::State& state, const Body& body, NormalMethod method) {
  const ThreadLimit one(1);
  for (auto _ : state) benchmark::DoNotOptimize(point_normals(body.surface, body.topology, body.features, {.method = method}));
  state.SetItemsProcessed(state.iterations() * body.n_points());
}

void smooth_body_by_angle(benchmark::State& state) { normals_of(state, smooth_body(), NormalMethod::Angle); }
void smooth_body_most_visible(benchmark::State& state) { normals_of(state, smooth_body(), NormalMethod::MostVisible); }
void rippled_body_most_visible(benchmark::State& state) {
  normals_of(state, rippled_body(), NormalMethod::MostVisible);
}
BENCHMARK(smooth_body_by_angle)->Unit(benchmark::kMillisecond);
BENCHMARK(smooth_body_most_visible)->Unit(benchmark::kMillisecond);
BENCHMARK(rippled_body_most_visible)->Unit(benchmark::kMillisecond);

void sweeps_of(benchmark::State& state, const Body& body, SmoothingFilter filter) {
  const ThreadLimit one(1);
  const auto before = point_normals(body.surface, body.topology, body.features);
  SmoothingOptions options;
  options.filter = filter;
  options.iterations = kSweeps;
  for (auto _ : state) {
    auto normals = before;
    smooth_normals(body.surface, body.topology, body.features, options, normals);
    benchmark::DoNotOptimize(normals);
  }
  state.SetItemsProcessed(state.iterations() * body.n_points() * kSweeps);
}

void smooth_body_laplacian_sweeps(benchmark::State& state) {
  sweeps_of(state, smooth_body(), SmoothingFilter::Laplacian);
}
void smooth_body_taubin_sweeps(benchmark::State& state) { sweeps_of(state, smooth_body(), SmoothingFilter::Taubin); }
void rippled_body_taubin_sweeps(benchmark::State& state) { sweeps_of(state, rippled_body(), SmoothingFilter::Taubin); }
BENCHMARK(smooth_body_laplacian_sweeps)->Unit(benchmark::kMillisecond);
BENCHMARK(smooth_body_taubin_sweeps)->Unit(benchmark::kMillisecond);
BENCHMARK(rippled_body_taubin_sweeps)->Unit(benchmark::kMillisecond);

/// The direct method on one fan whose optimum rests on three normals among many near the rim.
void most_visible_of_a_fan(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  std::vector<Vec3> normals;
  for (std::size_t i = 0; i < n; ++i) {
    const double azimuth = 2 * std::numbers::pi * static_cast<double>(i * i % n) / static_cast<double>(n);
    const double polar = 1.2 + 0.1 * std::sin(3.0 * static_cast<double>(i));
    normals.emplace_back(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
  }
  for (auto _ : state) benchmark::DoNotOptimize(most_visible_normal(normals));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(most_visible_of_a_fan)->Arg(6)->Arg(12)->Arg(64)->Arg(10000);

}  // namespace
}  // namespace nearwall::surface

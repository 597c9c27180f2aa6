#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "nearwall/core/parallel.h"
#include "nearwall/shapes/shapes.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/point_normals.h"
#include "nearwall/surface/smoothing.h"
#include "tests/support/shapes.h"

// Points per second on bodies of some 120,000 points, beside a loop that merely streams the same arrays. Rates of
// sweeps are those of whole calls with five sweeps, preparation included. The last argument is the number of threads.

namespace nearwall::surface {
namespace {

constexpr int kSweeps = 5;

struct Body {
  mesh::SurfaceMesh surface;
  mesh::Topology topology;
  Features features;
  explicit Body(mesh::SurfaceMesh mesh)
      : surface(std::move(mesh)), topology(surface), features(find_features(surface, topology)) {}
  std::int64_t n_points() const { return static_cast<std::int64_t>(surface.points.size()); }
};

/// Wing on a fuselage: smooth ground with ridges, corners and a concave junction.
const Body& wing_body() {
  constexpr double kEdge = 0.0195;
  static const Body body(shapes::make_shape("wing-body", {}, kEdge));
  return body;
}

/// Sphere with a ripple that makes ridges and sharp vertices all over.
const Body& rippled_sphere() {
  constexpr double kHeight = 0.02;
  static const Body body(shapes_for_tests::mapped(shapes_for_tests::sphere(7), [](const Vec3& p) {
    return p * (1.0 + kHeight * std::sin(90 * p.x()) * std::cos(110 * p.y()));
  }));
  return body;
}

/// Reads what a sweep reads and writes what it writes, with one addition for each number.
void stream(benchmark::State& state) {
  const Body& body = wing_body();
  IdVector<VertexId, Vec3> from(body.surface.points.size(), Vec3(0, 0, 1)), to = from;
  std::vector<VertexId> neighbour;
  for (const VertexId v : from.ids()) {
    for (const HalfedgeId h : body.topology.fan(v)) neighbour.push_back(body.topology.target(h));
  }
  for (auto _ : state) {
    std::uint64_t sum = 0;
    for (const VertexId v : neighbour) sum += v.index();
    for (const VertexId v : from.ids()) to[v] = from[v] + Vec3(0, 0, 1);
    benchmark::DoNotOptimize(sum);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * body.n_points());
}
BENCHMARK(stream)->Unit(benchmark::kMillisecond);

void normals_of(benchmark::State& state, const Body& body, NormalMethod method) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(point_normals(body.surface, body.topology, body.features, {.method = method}));
  }
  state.SetItemsProcessed(state.iterations() * body.n_points());
}

void sweeps_of(benchmark::State& state, const Body& body, SmoothingOptions options) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const auto before = point_normals(body.surface, body.topology, body.features);
  options.iterations = kSweeps;
  for (auto _ : state) {
    auto normals = before;
    smooth_normals(body.surface, body.topology, body.features, options, normals);
    benchmark::DoNotOptimize(normals);
  }
  state.SetItemsProcessed(state.iterations() * body.n_points() * kSweeps);
}

struct Sweep {
  const char* name;
  SmoothingOptions options;
};

/// Whole steps towards the neighbours, as in Aubry & Loehner 2008, section 5; Taubin's with his steps.
const std::vector<Sweep>& all_sweeps() {
  using enum SmoothingFilter;
  static const std::vector<Sweep> sweeps = {
      {"plain", {.filter = Laplacian, .lambda = 1}},
      {"triggered", {.filter = MostVisible, .lambda = 1}},
      {"direct", {.filter = MostVisible, .lambda = 1, .trigger = 1}},
      {"iterative", {.filter = MostVisible, .lambda = 1, .trigger = 1, .search = SearchMethod::Iterative}},
      {"taubin", {.filter = Taubin}},
      {"most_visible_taubin", {.filter = MostVisibleTaubin}}};
  return sweeps;
}

void register_body(const char* name, const Body& (*body)()) {
  for (const Sweep& sweep : all_sweeps()) {
    benchmark::RegisterBenchmark((std::string(name) + "/sweep/" + sweep.name).c_str(),
                                 [=](benchmark::State& state) { sweeps_of(state, body(), sweep.options); })
        ->Unit(benchmark::kMillisecond)
        ->Arg(1)
        ->Arg(2)
        ->UseRealTime();
  }
  for (std::size_t k = 0; k < kNormalMethodNames.size(); ++k) {
    const auto method = static_cast<NormalMethod>(k);
    benchmark::RegisterBenchmark((std::string(name) + "/normals/" + std::string(method_name(method))).c_str(),
                                 [=](benchmark::State& state) { normals_of(state, body(), method); })
        ->Unit(benchmark::kMillisecond)
        ->Arg(1)
        ->Arg(2)
        ->UseRealTime();
  }
}

const bool is_registered = [] {
  register_body("wing_body", wing_body);
  register_body("rippled_sphere", rippled_sphere);
  return true;
}();

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

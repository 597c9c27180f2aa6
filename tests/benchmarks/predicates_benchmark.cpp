#include <array>
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include "nearwall/predicates/cells.h"
#include "nearwall/predicates/orientation.h"

namespace {

using namespace nearwall;
using namespace nearwall::predicates;

/// Three lines over a slanted triangle, layers from 1e-6 of its width on.
struct Column {
  std::array<std::vector<double>, 9> values;
  WedgeColumn view{};

  explicit Column(int n_levels) {
    const std::array<Vec3, 3> base{Vec3(0.1, 0.2, 0.3), Vec3(1.05, 0.25, 0.4), Vec3(0.6, 1.1, 0.2)};
    const std::array<Vec3, 3> along{Vec3(0.1, 0.1, 1.0), Vec3(0.2, 0.0, 1.0), Vec3(0.05, 0.2, 1.0)};
    for (int j = 0; j <= n_levels; ++j) {
      const double height = 1e-6 * (std::pow(1.2, j) - 1.0) / 0.2;
      for (int line = 0; line < 3; ++line) {
        const Vec3 p = base[line] + height * along[line];
        for (int axis = 0; axis < 3; ++axis) values[3 * line + axis].push_back(p[axis]);
      }
    }
    for (int line = 0; line < 3; ++line) {
      view.x[line] = values[3 * line].data();
      view.y[line] = values[3 * line + 1].data();
      view.z[line] = values[3 * line + 2].data();
    }
  }
};

void wedge_column(benchmark::State& state) {
  const int n_levels = static_cast<int>(state.range(0));
  const Column column(n_levels);
  for (auto _ : state) {
    const int bad = first_bad_wedge(column.view, n_levels);
    if (bad != n_levels) state.SkipWithError("a wedge of the column is not positive");
    benchmark::DoNotOptimize(bad);
  }
  state.SetItemsProcessed(state.iterations() * n_levels);
}
BENCHMARK(wedge_column)->Arg(30)->Arg(60);

void single_wedge(benchmark::State& state) {
  const std::array<Vec3, 6> p{Vec3(0, 0, 0),    Vec3(1, 0, 0),      Vec3(0, 1, 0),
                              Vec3(0, 0, 1e-5), Vec3(1, 0.1, 1e-5), Vec3(0, 1, 2e-5)};
  for (auto _ : state) benchmark::DoNotOptimize(wedge(p));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(single_wedge);

/// A flat wedge: nothing but exact arithmetic can tell.
void flat_wedge(benchmark::State& state) {
  const std::array<Vec3, 6> p{Vec3(0.1, 0.3, 0.4), Vec3(1.1, 0.3, 1.4), Vec3(0.1, 1.3, 1.4),
                              Vec3(0.1, 0.3, 0.4), Vec3(1.3, 0.3, 1.6), Vec3(0.1, 1.7, 1.8)};
  for (auto _ : state) benchmark::DoNotOptimize(wedge(p));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(flat_wedge);

void warped_hexahedron(benchmark::State& state) {
  const std::array<Vec3, 8> p{Vec3(0, 0, 0), Vec3(1, 0, 0.1), Vec3(1.1, 1, 0), Vec3(0, 1, 0),
                              Vec3(0, 0, 1), Vec3(1, 0.2, 1), Vec3(1, 1, 1.2), Vec3(0.1, 1, 1)};
  for (auto _ : state) benchmark::DoNotOptimize(hexahedron(p));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(warped_hexahedron);

void orientation_in_doubles(benchmark::State& state) {
  const Vec3 a(0.1, 0.2, 0.3), b(1.1, 0.2, 0.35), c(0.2, 1.3, 0.2), d(0.3, 0.4, 1.5);
  for (auto _ : state) benchmark::DoNotOptimize(orientation(a, b, c, d));
}
BENCHMARK(orientation_in_doubles);

void orientation_of_coplanar_points(benchmark::State& state) {
  const Vec3 a(0, 0, 1), b(0, 1, 0), c(1, 0, 0), d(0.25, 0.25, 0.5);
  for (auto _ : state) benchmark::DoNotOptimize(orientation(a, b, c, d));
}
BENCHMARK(orientation_of_coplanar_points);

}  // namespace

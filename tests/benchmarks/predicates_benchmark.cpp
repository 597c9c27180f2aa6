#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
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

/// Many cells of one kind, each a little different, as the fans at a ridge have them: a box of one length along the
/// ridge, a tenth across the fan, and of layers down to 1e-6, warped, turned and away from the origin.
template <std::size_t N>
std::vector<std::array<Vec3, N>> ridge_cells(const std::array<Vec3, N>& in_box) {
  constexpr std::size_t kCells = 4096;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<std::array<Vec3, N>> cells(kCells);
  for (auto& cell : cells) {
    const double height = std::pow(10.0, -3.5 + 2.5 * number(random));
    const Vec3 along(0.6 + 0.1 * number(random), 0.64, 0.48), across(-0.08, 0.06 + 0.01 * number(random), 0.01);
    const Vec3 up = height * Vec3(-0.3, 0.1 * number(random), 1);
    for (std::size_t k = 0; k < N; ++k) {
      const auto warped = [&](double x) { return x + 0.05 * number(random); };
      cell[k] = Vec3(1, 2, 3) + warped(in_box[k].x()) * along + warped(in_box[k].y()) * across +
                (in_box[k].z() * (1 + 0.1 * number(random))) * up;
    }
  }
  return cells;
}

template <std::size_t N>
void test_all(benchmark::State& state, const std::array<Vec3, N>& in_box,
              Positivity (*test)(std::span<const Vec3, N>)) {
  const auto cells = ridge_cells(in_box);
  for (auto _ : state) {
    std::size_t n = 0;
    for (const auto& cell : cells) n += test(cell) == Positivity::Positive ? 1 : 0;
    if (n != cells.size()) state.SkipWithError("a cell is not positive");
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cells.size()));
}

constexpr std::array<Vec3, 8> kBox{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0),
                                   Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)};

void ridge_tetrahedra(benchmark::State& state) {
  test_all<4>(state, {kBox[0], kBox[1], kBox[3], kBox[4]}, tetrahedron);
}
BENCHMARK(ridge_tetrahedra);

void ridge_pyramids(benchmark::State& state) {
  test_all<5>(state, {kBox[0], kBox[1], kBox[2], kBox[3], Vec3(0.5, 0.5, 1)}, pyramid);
}
BENCHMARK(ridge_pyramids);

void ridge_wedges(benchmark::State& state) {
  test_all<6>(state, {kBox[0], kBox[1], kBox[3], kBox[4], kBox[5], kBox[7]}, wedge);
}
BENCHMARK(ridge_wedges);

void ridge_hexahedra(benchmark::State& state) { test_all<8>(state, kBox, hexahedron); }
BENCHMARK(ridge_hexahedra);

/// A coefficient is zero, so the cell has to be cut up.
void turned_hexahedron(benchmark::State& state) {
  const std::array<Vec3, 8> p{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0),  Vec3(0, 1, 0),
                              Vec3(0, 0, 1), Vec3(0, 1, 1), Vec3(-1, 1, 1), Vec3(-1, 0, 1)};
  for (auto _ : state) benchmark::DoNotOptimize(hexahedron(p));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(turned_hexahedron);

/// Nothing but exact arithmetic can tell the sign of its corners.
void flat_hexahedron(benchmark::State& state) {
  std::array<Vec3, 8> p;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double x = kBox[k].x() + 0.3 * kBox[k].z(), y = kBox[k].y() + 0.7 * kBox[k].z();
    p[k] = Vec3(x, y, x + 2 * y);
  }
  for (auto _ : state) benchmark::DoNotOptimize(hexahedron(p));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(flat_hexahedron);

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

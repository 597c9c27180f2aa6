#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/search/self_intersection.h"
#include "nearwall/search/wall_tree.h"
#include "nearwall/search/winding.h"

namespace {

using namespace nearwall;
using namespace nearwall::search;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A grid of 512 x 320 squares, cut into 327,680 triangles if closed both ways.
struct Grid {
  static constexpr std::uint32_t kRows = 512, kColumns = 320;
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// \param place      the point at two fractions of the ways round
  /// \param is_closed  without it, the last row and column have no triangles
  template <class Place>
  explicit Grid(Place&& place, bool is_closed = true) {
    for (std::uint32_t i = 0; i < kRows; ++i) {
      for (std::uint32_t j = 0; j < kColumns; ++j) {
        points.push_back(place(double(i) / kRows, double(j) / kColumns));
        if (!is_closed && (i + 1 == kRows || j + 1 == kColumns)) continue;
        const auto at = [&](std::uint32_t di, std::uint32_t dj) {
          return (i + di) % kRows * kColumns + (j + dj) % kColumns;
        };
        triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
        triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
      }
    }
  }
  IndexedTriangles soup() const { return {points, triangles}; }
};

Vec3 on_torus(double s, double t) {
  const double r = 1.0 + 0.4 * std::cos(kTurn * t);
  return {r * std::cos(kTurn * s), r * std::sin(kTurn * s), 0.4 * std::sin(kTurn * t)};
}

Vec3 on_slanted_plate(double s, double t) { return {s + 0.3 * t, t, 0.7 * s - 0.2 * t}; }

void self_intersections_of_a_torus(benchmark::State& state) {
  const Grid torus(on_torus);
  for (auto _ : state) {
    if (!self_intersections(torus.soup()).empty()) state.SkipWithError("a torus does not intersect itself");
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(torus.triangles.size()));
}
BENCHMARK(self_intersections_of_a_torus)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Nearly coplanar neighbours: exact arithmetic has to decide.
void self_intersections_of_a_slanted_plate(benchmark::State& state) {
  const Grid plate(on_slanted_plate, false);
  for (auto _ : state) {
    if (!self_intersections(plate.soup()).empty()) state.SkipWithError("a plate does not intersect itself");
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(plate.triangles.size()));
}
BENCHMARK(self_intersections_of_a_slanted_plate)->Unit(benchmark::kMillisecond)->UseRealTime();

void self_intersections_of_a_few_moved(benchmark::State& state) {
  const Grid torus(on_torus);
  std::vector<char> moved(torus.triangles.size(), 0);
  for (std::size_t i = 0; i < moved.size(); i += 1000) moved[i] = 1;
  for (auto _ : state) benchmark::DoNotOptimize(self_intersections(torus.soup(), moved));
}
BENCHMARK(self_intersections_of_a_few_moved)->Unit(benchmark::kMillisecond)->UseRealTime();

mesh::SurfaceMesh surface_of(const Grid& grid) {
  mesh::SurfaceMesh surface;
  surface.points = IdVector<VertexId, Vec3>(grid.points);
  for (const auto& t : grid.triangles) {
    surface.faces.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
  }
  return surface;
}

void build_wall_tree(benchmark::State& state) {
  const mesh::SurfaceMesh surface = surface_of(Grid(on_torus));
  for (auto _ : state) WallTree tree(surface);
}
BENCHMARK(build_wall_tree)->Unit(benchmark::kMillisecond)->UseRealTime();

/// From every point of the torus outwards; the argument is the length in hundredths.
void first_hits(benchmark::State& state) {
  const Grid torus(on_torus);
  const WallTree tree(surface_of(torus));
  const double length = 0.01 * static_cast<double>(state.range(0));
  for (auto _ : state) {
    for (std::uint32_t v = 0; v < torus.points.size(); ++v) {
      const auto keep = [&](FaceId f) {
        const auto& t = torus.triangles[f.index()];
        return t[0] != v && t[1] != v && t[2] != v;
      };
      const Vec3 p = torus.points[v];
      const Vec3 centre = normalized({p.x(), p.y(), 0.0});
      benchmark::DoNotOptimize(tree.first_hit(p, p + length * normalized(p - centre), keep));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(torus.points.size()));
}
BENCHMARK(first_hits)->Arg(5)->Arg(200)->Unit(benchmark::kMillisecond);

void nearest_points(benchmark::State& state) {
  const Grid torus(on_torus);
  const WallTree tree(surface_of(torus));
  for (auto _ : state) {
    for (const Vec3& p : torus.points) benchmark::DoNotOptimize(tree.nearest(1.05 * p));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(torus.points.size()));
}
BENCHMARK(nearest_points)->Unit(benchmark::kMillisecond);

void winding_numbers(benchmark::State& state) {
  const Grid torus(on_torus);
  for (auto _ : state) {
    if (winding_number(torus.soup(), {0.0, 1.1, 0.1}) != 1) state.SkipWithError("the point is inside");
  }
}
BENCHMARK(winding_numbers)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

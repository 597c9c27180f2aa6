// Prints the table of docs/theory/fill.md: fills of some regions, how well they follow the wanted sizes, how good their
// tetrahedra are, and how long they take.

#include <sys/resource.h>

#include <string>
#include <vector>

#include <fmt/format.h>

#include "nearwall/geometry/box.h"
#include "nearwall/shapes/shapes.h"
#include "nearwall/volume/fill.h"
#include "tests/benchmarks/fill_measure.h"
#include "tests/support/shapes.h"
#include "tests/volume/boundaries.h"

namespace nearwall::benchmarks {
namespace {

struct Region {
  std::string name;
  volume::FillBoundary boundary;
  volume::FillOptions options;
};

mesh::SurfaceMesh sphere(double radius, double size, const Vec3& centre = {}) {
  return shapes_for_tests::translated(shapes_for_tests::scaled(shapes::make_shape("sphere", {}, size / radius), radius),
                                      centre);
}

/// A sphere of so many diagonals of the body round it, with edges as they have grown till there.
volume::FillBoundary in_far_field(const std::vector<mesh::SurfaceMesh>& bodies, double diagonals, double growth) {
  geometry::Box box;
  for (const auto& body : bodies) {
    for (const Vec3& p : body.points) box.include(p);
  }
  const Vec3 middle = box.centre();
  const double radius = diagonals * box.diagonal();
  return boundaries_for_tests::region(sphere(radius, (growth - 1) * radius, middle), bodies);
}

std::vector<Region> regions() {
  const auto cube = [](double factor, double size) {
    return shapes_for_tests::scaled(shapes::make_shape("cube", {}, size / factor), factor);
  };
  return {
      {"sphere in sphere", boundaries_for_tests::region(sphere(20, 4), {sphere(1, 0.05)}), {}},
      {"wing", in_far_field({shapes::make_shape("onera-m6", {}, 0.02)}, 50, 1.3), {}},
      {"two spheres", in_far_field({sphere(1, 0.1), sphere(0.5, 0.02, {1.7, 0, 0})}, 20, 1.3), {}},
      {"box in box", boundaries_for_tests::region(cube(10, 1), {cube(1, 0.1)}), {}},
      {"even", boundaries_for_tests::region(cube(1, 0.04)), {1.3, 0.04}},
  };
}

/// Processor time of this process, or of those that it started and that have ended.
double processor_seconds(int whose) {
  rusage use = {};
  ::getrusage(whose, &use);
  constexpr double kMicro = 1e-6;
  return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
         kMicro * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

void print_row(const Region& region) {
  const double ours = processor_seconds(RUSAGE_SELF), theirs = processor_seconds(RUSAGE_CHILDREN);
  const volume::Fill fill = volume::fill_with_tetgen(region.boundary, region.options);
  const double seconds = processor_seconds(RUSAGE_CHILDREN) - theirs;
  const double around = processor_seconds(RUSAGE_SELF) - ours;
  const FillFigures f = measure_fill(region.boundary, region.options, fill);
  fmt::print(
      "| {} | {} | {} | {:.2f} + {:.2f} | {:.2f} {:.2f} {:.2f} | {:.1f} {:.1f} {:.1f} | {} | {:.2f} {:.2f} | {:.2f} "
      "{:.1f} |\n",
      region.name, region.boundary.triangles.size(), f.n_tetrahedra, seconds, around, f.edge_over_wanted.p01,
      f.edge_over_wanted.median, f.edge_over_wanted.p99, f.least_dihedral.least, f.least_dihedral.p01,
      f.least_dihedral.median, f.n_slivers, f.radius_edge.p99, f.radius_edge.most, f.jump.p99, f.jump.most);
}

}  // namespace
}  // namespace nearwall::benchmarks

int main() {
  fmt::print(
      "| region | triangles | tetrahedra | TetGen + ours [s] | edge / wanted: p01, median, p99 | least dihedral [deg]: "
      "min, p01, "
      "median "
      "| under 10 deg | radius / edge: p99, max | jump: p99, max |\n| --- | --- | --- | --- | --- | --- | --- | --- | "
      "--- |\n");
  for (const auto& region : nearwall::benchmarks::regions()) nearwall::benchmarks::print_row(region);
}

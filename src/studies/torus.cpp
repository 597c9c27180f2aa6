#include <algorithm>
#include <cmath>
#include <numbers>

#include "nearwall/core/expect.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/studies/ubach.h"
#include "studies/delaunay.h"
#include "studies/random.h"

namespace nearwall::studies {

namespace {

constexpr double kMajor = std::numbers::phi;  // R, the minor radius being 1
constexpr std::size_t kNodes = 7083;          // of the paper's mesh
constexpr double kTurn = 2 * std::numbers::pi;
/// sqrt(R² - r²): the torus is the conformal image of a rectangle with sides in this ratio.
const double kChartRatio = std::sqrt(kMajor * kMajor - 1.0);

/// The chart: [0, 1) x [0, 1 / kChartRatio), whose angles the torus keeps, so that triangles that are Delaunay in the
/// chart are nearly so in space.
const Point2 kPeriod = {1.0, 1.0 / kChartRatio};

/// Polar angle in the section of the tube.
double tube_angle(const Point2& p) {
  const double half = std::numbers::pi * (p.y / kPeriod.y - 0.5);
  return 2.0 * std::atan2(std::sqrt((kMajor + 1.0) / (kMajor - 1.0)) * std::sin(half), std::cos(half));
}

Vec3 torus_point(const Point2& p) {
  const double u = kTurn * p.x, v = tube_angle(p);
  const double r = kMajor + std::cos(v);
  return {r * std::cos(u), r * std::sin(u), std::sin(v)};
}

Vec3 torus_normal(const Point2& p) {
  const double u = kTurn * p.x, v = tube_angle(p);
  return {std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
}

double wrapped(double x, double period) {
  const double rest = x - period * std::floor(x / period);
  return rest < period ? rest : 0.0;
}

/// A point of the chart that is uniform in the area of the torus.
Point2 random_point(RandomStream& random) {
  while (true) {
    const Point2 p = {random.uniform(), kPeriod.y * random.uniform()};
    const double stretch = (kMajor + std::cos(tube_angle(p))) / (kMajor + 1.0);
    if (random.uniform() < stretch * stretch) return p;
  }
}

std::vector<Point2> scattered(RandomStream& random) {
  std::vector<Point2> points(kNodes);
  for (Point2& p : points) p = random_point(random);
  return points;
}

/// Random points that keep a distance from each other, as those of a mesh generator do.
std::vector<Point2> spaced(RandomStream& random) {
  // Darts fill the plane to some 0.7 points for each square of their distance; less is reached before long.
  constexpr double kFill = 0.6;
  const double area = kTurn * kTurn * kMajor;
  const double least = std::sqrt(kFill * area / static_cast<double>(kNodes));
  // Sectors that are as wide as the distance even at the hole: only the next ones can hold points that are too near.
  const auto n_sectors = static_cast<std::size_t>(kTurn * (kMajor - 1.0) / least);
  std::vector<std::vector<Vec3>> sectors(n_sectors);
  std::vector<Point2> points;
  while (points.size() < kNodes) {
    const Point2 p = random_point(random);
    const Vec3 place = torus_point(p);
    const auto sector = std::min(static_cast<std::size_t>(p.x * static_cast<double>(n_sectors)), n_sectors - 1);
    const auto is_free = [&](std::size_t s) {
      return std::none_of(sectors[s % n_sectors].begin(), sectors[s % n_sectors].end(),
                          [&](const Vec3& other) { return squared_norm(place - other) < least * least; });
    };
    if (!is_free(sector + n_sectors - 1) || !is_free(sector) || !is_free(sector + 1)) continue;
    points.push_back(p);
    sectors[sector].push_back(place);
  }
  return points;
}

/// Equilateral triangles of the chart with their points displaced, each way by at most `jitter` of the edge length.
std::vector<Point2> lattice(double jitter, RandomStream& random) {
  constexpr std::size_t kColumns = 88, kRows = 80;  // an even number of rows: each second one is set off
  const double width = kPeriod.x / kColumns, height = kPeriod.y / kRows;
  std::vector<Point2> points;
  for (std::size_t j = 0; j < kRows; ++j) {
    for (std::size_t i = 0; i < kColumns; ++i) {
      const double x = width * (static_cast<double>(i) + (j % 2 == 0 ? 0.0 : 0.5)), y = height * static_cast<double>(j);
      points.push_back({wrapped(x + width * random.uniform(-jitter, jitter), kPeriod.x),
                        wrapped(y + width * random.uniform(-jitter, jitter), kPeriod.y)});
    }
  }
  return points;
}

mesh::SurfaceMesh torus_mesh(const std::vector<Point2>& points) {
  mesh::SurfaceMesh mesh;
  for (const Point2& p : points) mesh.points.push_back(torus_point(p));
  for (const Triangle2& t : periodic_delaunay(points, kPeriod)) {
    mesh.faces.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
    mesh.face_patch.push_back(PatchId(0));
  }
  mesh.patch_names.push_back("torus");
  return mesh;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TorusComparison compare(const std::string& family, const std::vector<Point2>& points) {
  const mesh::SurfaceMesh mesh = torus_mesh(points);
  const mesh::Topology topology(mesh);
  expect(topology.is_closed() && mesh.faces.size() == 2 * points.size(), "the triangles close up to a torus");
  std::vector<double> circle_deg, max_deg, change_deg;
  std::vector<Vec3> ring;
  for (const VertexId v : mesh.points.ids()) {
    ring.clear();
    for (const HalfedgeId h : topology.fan(v)) ring.push_back(mesh.points[topology.target(h)]);
    const Vec3 truth = torus_normal(points[v.index()]);
    const auto error_deg = [&](surface::Weight weight) {
      return geometry::to_degrees(
          geometry::angle_between(surface::weighted_normal(weight, mesh.points[v], ring), truth));
    };
    circle_deg.push_back(error_deg(surface::Weight::AngleOverCircumArea));
    max_deg.push_back(error_deg(surface::Weight::Max));
    change_deg.push_back(circle_deg.back() - max_deg.back());
  }
  std::sort(change_deg.begin(), change_deg.end());
  const auto n_improved = std::lower_bound(change_deg.begin(), change_deg.end(), 0.0) - change_deg.begin();
  return {.family = family,
          .n_nodes = points.size(),
          .improved_percent = 100.0 * static_cast<double>(n_improved) / static_cast<double>(points.size()),
          .rmse_circle_deg = root_mean_square(circle_deg),
          .rmse_max_deg = root_mean_square(max_deg),
          .change_deg = change_deg};
}

}  // namespace

std::vector<TorusComparison> compare_on_torus(std::uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<TorusComparison> results;
  results.push_back(compare("lattice, jitter 0.1", lattice(0.1, random)));
  results.push_back(compare("lattice, jitter 0.25", lattice(0.25, random)));
  results.push_back(compare("lattice, jitter 0.5", lattice(0.5, random)));
  results.push_back(compare("spaced at random", spaced(random)));
  results.push_back(compare("scattered at random", scattered(random)));
  return results;
}

}  // namespace nearwall::studies

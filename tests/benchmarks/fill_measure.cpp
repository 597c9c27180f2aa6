#include "tests/benchmarks/fill_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/angles.h"
#include "volume/face_table.h"
#include "volume/size_field.h"

namespace nearwall::benchmarks {

namespace {

using Corners = std::array<Vec3, 4>;
constexpr std::pair<int, int> kEdges[6] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

FillFigures::Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {values.front(), at(0.01), at(0.5), at(0.99), values.back()};
}

double volume_of(const Corners& p) { return dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) / 6; }

double least_dihedral(const Corners& p) {
  Vec3 normals[4];
  for (int k = 0; k < 4; ++k) {
    const auto& c = volume::kFaceCorners[k];
    normals[k] = normalized(cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]));
  }
  double most = -1;
  for (const auto& [i, j] : kEdges) most = std::max(most, -dot(normals[i], normals[j]));
  return geometry::to_degrees(std::acos(std::min(most, 1.0)));
}

double radius_edge(const Corners& p) {
  const Vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const Vec3 numerator = squared_norm(a) * cross(b, c) + squared_norm(b) * cross(c, a) + squared_norm(c) * cross(a, b);
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [i, j] : kEdges) shortest = std::min(shortest, distance(p[i], p[j]));
  return norm(numerator) / (2 * std::abs(dot(a, cross(b, c)))) / shortest;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> inner_edges(const volume::FillBoundary& boundary,
                                                                 const volume::Fill& fill) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> all, outer, inner;
  for (const auto& v : fill.tetrahedra) {
    for (const auto& [i, j] : kEdges) all.push_back(std::minmax(v[i], v[j]));
  }
  for (const auto& v : boundary.triangles) {
    for (int k = 0; k < 3; ++k) outer.push_back(std::minmax(v[k], v[(k + 1) % 3]));
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::sort(outer.begin(), outer.end());
  std::set_difference(all.begin(), all.end(), outer.begin(), outer.end(), std::back_inserter(inner));
  return inner;
}

}  // namespace

FillFigures measure_fill(const volume::FillBoundary& boundary, const volume::FillOptions& options,
                         const volume::Fill& fill) {
  const volume::SizeField wanted(volume::sizes_of_edges(boundary.points, boundary.triangles), options.growth - 1,
                                 options.largest.value_or(std::numeric_limits<double>::infinity()));
  FillFigures figures;
  figures.n_tetrahedra = fill.tetrahedra.size();
  figures.n_added_points = fill.points.size() - boundary.points.size();

  std::vector<double> lengths;
  for (const auto& [i, j] : inner_edges(boundary, fill)) {
    const Vec3 &a = fill.points[i], &b = fill.points[j];
    lengths.push_back(distance(a, b) / wanted.at((a + b) * 0.5));
  }
  figures.edge_over_wanted = spread_of(std::move(lengths));

  std::vector<double> angles, ratios, jumps, sizes;
  for (const auto& v : fill.tetrahedra) {
    const Corners p{fill.points[v[0]], fill.points[v[1]], fill.points[v[2]], fill.points[v[3]]};
    angles.push_back(least_dihedral(p));
    ratios.push_back(radius_edge(p));
    sizes.push_back(std::cbrt(volume_of(p)) / wanted.at((p[0] + p[1] + p[2] + p[3]) * 0.25));
  }
  constexpr double kSliver = 10;
  figures.n_slivers = static_cast<std::size_t>(
      std::count_if(angles.begin(), angles.end(), [](double angle) { return angle < kSliver; }));
  figures.least_dihedral = spread_of(std::move(angles));
  figures.radius_edge = spread_of(std::move(ratios));
  const volume::FaceTable faces(fill.points.size(), fill.tetrahedra, boundary.triangles);
  for (std::size_t t = 0; t < sizes.size(); ++t) {
    for (int k = 0; k < 4; ++k) {
      const std::uint32_t other = faces.beyond(t, k);
      if (other < t) jumps.push_back(std::max(sizes[t], sizes[other]) / std::min(sizes[t], sizes[other]));
    }
  }
  figures.jump = spread_of(std::move(jumps));
  return figures;
}

}  // namespace nearwall::benchmarks

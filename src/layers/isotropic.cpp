#include "nearwall/layers/isotropic.h"

#include <cmath>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::layers {

namespace {

/// Height over edge of a regular tetrahedron: sqrt(2/3). The cells that go on from the last layer stand on its
/// triangles and are this high if they are well shaped: then no height jumps.
constexpr double kTetrahedronHeight = 0.816496580927726033;

/// Area of an equilateral triangle over its edge squared: sqrt(3)/4.
constexpr double kTriangleArea = 0.433012701892219324;

/// Sweeps by which widths are evened out: docs/theory/asked.md, section 2, has the figures.
constexpr int kSweeps = 4;

/// Edge of the equilateral triangle that is as large as the mean of those round v.
double width_at(const mesh::SurfaceMesh& surface, const mesh::Topology& topology, VertexId v) {
  const auto fan = topology.fan(v);
  if (fan.empty()) return 0;
  double area = 0;
  for (const HalfedgeId h : fan) {
    const auto [a, b, c] = surface.triangle(mesh::Topology::face(h));
    area += geometry::triangle_area(a, b, c);
  }
  return std::sqrt(area / (static_cast<double>(fan.size()) * kTriangleArea));
}

}  // namespace

IdVector<VertexId, double> isotropic_heights(const mesh::SurfaceMesh& surface, const mesh::Topology& topology) {
  IdVector<VertexId, double> height(surface.points.size());
  parallel_for(height.size(), [&](std::size_t i) {
    height[VertexId(i)] = kTetrahedronHeight * width_at(surface, topology, VertexId(i));
  });
  IdVector<VertexId, double> next(height.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    parallel_for(height.size(), [&](std::size_t i) {
      const VertexId v(i);
      double sum = 0, n = 0;
      topology.for_each_neighbour(v, [&](VertexId u) {
        sum += height[u];
        ++n;
      });
      next[v] = n > 0 ? 0.5 * (height[v] + sum / n) : 0.0;
    });
    std::swap(height, next);
  }
  return height;
}

Level isotropic_level(std::span<const double> heights, double height) {
  Level level = 1;
  // Halfway between two heights in ratio is their geometric mean.
  while (level < heights.size() && heights[level - 1u] * heights[level] < height * height) ++level;
  return level;
}

}  // namespace nearwall::layers

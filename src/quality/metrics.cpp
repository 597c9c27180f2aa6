#include "nearwall/quality/metrics.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace nearwall::quality {

namespace {

/// A corner and the ends of its three edges, so ordered that the determinant is positive in the ideal cell.
using Corner = std::array<int, 4>;
using Edge = std::array<int, 2>;

constexpr std::array<Corner, 4> kTetrahedronCorners = {{{0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {3, 1, 0, 2}}};
// The apex has four edges: the base corners alone tell.
constexpr std::array<Corner, 4> kPyramidCorners = {{{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}}};
constexpr std::array<Corner, 6> kWedgeCorners = {
    {{0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5}, {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}}};
constexpr std::array<Corner, 8> kHexahedronCorners = {
    {{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7}, {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}}};

constexpr std::array<Edge, 6> kTetrahedronEdges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<Edge, 8> kPyramidEdges = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};
constexpr std::array<Edge, 9> kWedgeEdges = {{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
constexpr std::array<Edge, 12> kHexahedronEdges = {
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// What a cell of one type is made of, and the reciprocal of its ideal corner determinant.
struct Shape {
  std::span<const Corner> corners;
  std::span<const Edge> edges;
  double ideal;
};

Shape shape_of(mesh::CellType type) {
  constexpr double kPrism = 2 * std::numbers::inv_sqrt3;
  switch (type) {
    case mesh::CellType::Tetrahedron:
      return {kTetrahedronCorners, kTetrahedronEdges, std::numbers::sqrt2};
    case mesh::CellType::Pyramid:
      return {kPyramidCorners, kPyramidEdges, std::numbers::sqrt2};
    case mesh::CellType::Wedge:
      return {kWedgeCorners, kWedgeEdges, kPrism};
    case mesh::CellType::Hexahedron:
      break;
  }
  return {kHexahedronCorners, kHexahedronEdges, 1.0};
}

const Vec3& at(std::span<const Vec3> p, int i) { return p[static_cast<std::size_t>(i)]; }

}  // namespace

double scaled_jacobian(mesh::CellType type, std::span<const Vec3> p) {
  const Shape shape = shape_of(type);
  double smallest = std::numeric_limits<double>::infinity();
  for (const Corner& c : shape.corners) {
    const Vec3 a = at(p, c[1]) - at(p, c[0]);
    const Vec3 b = at(p, c[2]) - at(p, c[0]);
    const Vec3 d = at(p, c[3]) - at(p, c[0]);
    const double lengths = norm(a) * norm(b) * norm(d);
    smallest = std::min(smallest, lengths > 0 ? dot(cross(a, b), d) / lengths : 0.0);
  }
  return std::clamp(smallest * shape.ideal, -1.0, 1.0);
}

double aspect_ratio(mesh::CellType type, std::span<const Vec3> p) {
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (const Edge& e : shape_of(type).edges) {
    const double length = distance(at(p, e[0]), at(p, e[1]));
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  return shortest > 0 ? longest / shortest : std::numeric_limits<double>::infinity();
}

}  // namespace nearwall::quality

#include "shapes/geodesic.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "nearwall/geometry/angles.h"
#include "shapes/sampling.h"

namespace nearwall::shapes {
namespace {

/// Corners of an icosahedron: (0, ±1, ±phi) and its cyclic permutations.
std::array<Vec3, 12> icosahedron_corners() {
  constexpr double kPhi = std::numbers::phi;
  return {Vec3(-1, kPhi, 0), Vec3(1, kPhi, 0), Vec3(-1, -kPhi, 0), Vec3(1, -kPhi, 0),
          Vec3(0, -1, kPhi), Vec3(0, 1, kPhi), Vec3(0, -1, -kPhi), Vec3(0, 1, -kPhi),
          Vec3(kPhi, 0, -1), Vec3(kPhi, 0, 1), Vec3(-kPhi, 0, -1), Vec3(-kPhi, 0, 1)};
}

constexpr std::array<std::array<int, 3>, 20> kFaces = {{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                        {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                        {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                        {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};

/// Angle between neighbouring corners of an icosahedron, seen from its centre.
const double kEdgeAngle = std::atan(2.0);

/// Mean edge of the 20 f² triangles on the unit sphere, times f: that of equilateral ones of the same area.
const double kMeanEdge = std::sqrt(4 * geometry::kPi / 20 * 4 / std::numbers::sqrt3);

/// Direction of the point with whole barycentric coordinates (i, j, k) in a face; along an edge it divides the arc
/// evenly.
Vec3 direction(const Vec3& a, const Vec3& b, const Vec3& c, int i, int j, int k) {
  const double step = kEdgeAngle / (i + j + k);
  const auto weight = [step](int n) { return std::sin(n * step); };
  return normalized((a * weight(i) + b * weight(j)) + c * weight(k));
}

}  // namespace

int geodesic_frequency(double radius, double size) { return n_segments(radius * kMeanEdge, size); }

void add_sphere(SurfaceBuilder& builder, std::string_view patch_name, const Vec3& centre, double radius, int frequency,
                bool is_cavity) {
  const PatchId patch = builder.patch(patch_name);
  const auto corners = icosahedron_corners();
  std::array<VertexId, 12> corner_ids;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corner_ids[i] = builder.add_point(centre + normalized(corners[i]) * radius);
  }
  // Points inside an edge, from its corner of lower number on.
  std::map<std::pair<int, int>, Row> edges;
  const auto edge_point = [&](int from, int to, int n) {
    if (to < from) std::swap(from, to), n = frequency - n;
    Row& row = edges[{from, to}];
    if (row.empty()) {
      const Vec3 &a = corners[static_cast<std::size_t>(from)], &b = corners[static_cast<std::size_t>(to)];
      for (int i = 1; i < frequency; ++i) {
        row.push_back(builder.add_point(centre + direction(a, b, {}, frequency - i, i, 0) * radius));
      }
    }
    return row[static_cast<std::size_t>(n - 1)];
  };

  for (const auto& [a, b, c] : kFaces) {
    const auto vertex = [&, a = a, b = b, c = c](int i, int j) {
      const int k = frequency - i - j;
      if (i == frequency) return corner_ids[static_cast<std::size_t>(a)];
      if (j == frequency) return corner_ids[static_cast<std::size_t>(b)];
      if (k == frequency) return corner_ids[static_cast<std::size_t>(c)];
      if (k == 0) return edge_point(a, b, j);
      if (i == 0) return edge_point(b, c, k);
      if (j == 0) return edge_point(a, c, k);
      return builder.add_point(centre + direction(corners[static_cast<std::size_t>(a)],
                                                  corners[static_cast<std::size_t>(b)],
                                                  corners[static_cast<std::size_t>(c)], i, j, k) *
                                            radius);
    };
    const auto add = [&](VertexId p, VertexId q, VertexId r) {
      is_cavity ? builder.add_triangle(patch, p, r, q) : builder.add_triangle(patch, p, q, r);
    };
    Row previous{vertex(frequency, 0)};
    for (int i = frequency - 1; i >= 0; --i) {
      Row row;
      for (int j = 0; j <= frequency - i; ++j) row.push_back(vertex(i, j));
      for (std::size_t j = 0; j < previous.size(); ++j) {
        add(previous[j], row[j + 1], row[j]);
        if (j > 0) add(previous[j - 1], previous[j], row[j]);
      }
      previous = row;
    }
  }
}

}  // namespace nearwall::shapes

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "nearwall/planar/point2.h"

namespace nearwall::planar {

/// Points and directed edges of a region, put together loop by loop.
struct Outline {
  std::vector<Point2> points;
  std::vector<Edge> edges;

  /// A closed loop; the region is on its left.
  Outline& loop(const std::vector<Point2>& corners) {
    const auto first = static_cast<std::uint32_t>(points.size()), n = static_cast<std::uint32_t>(corners.size());
    points.insert(points.end(), corners.begin(), corners.end());
    for (std::uint32_t i = 0; i < n; ++i) edges.push_back({first + i, first + (i + 1) % n});
    return *this;
  }
  /// The same the other way round: a hole, if the corners run counterclockwise.
  Outline& hole(std::vector<Point2> corners) {
    std::reverse(corners.begin(), corners.end());
    return loop(corners);
  }
};

/// A rectangle, counterclockwise, with n pieces on each side.
inline std::vector<Point2> rectangle(double u0, double v0, double u1, double v1, int n = 1) {
  const std::vector<Point2> corners{{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
  std::vector<Point2> result;
  for (std::size_t side = 0; side < 4; ++side) {
    const Point2 a = corners[side], b = corners[(side + 1) % 4];
    for (int i = 0; i < n; ++i) {
      const double share = static_cast<double>(i) / n;
      result.push_back({a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)});
    }
  }
  return result;
}

inline std::vector<Point2> ring(double u, double v, double radius, int n) {
  std::vector<Point2> result;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    result.push_back({u + radius * std::cos(angle), v + radius * std::sin(angle)});
  }
  return result;
}

/// Twice the area to the left of the edges.
inline double doubled_area(const std::vector<Point2>& points, const std::vector<Edge>& edges) {
  double sum = 0;
  for (const auto& [a, b] : edges) sum += points[a].u * points[b].v - points[b].u * points[a].v;
  return sum;
}

inline double doubled_area(const std::vector<Point2>& points, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    sum += (points[b].u - points[a].u) * (points[c].v - points[a].v) -
           (points[b].v - points[a].v) * (points[c].u - points[a].u);
  }
  return sum;
}

/// Twice the area of a triangle by the extended precision of the compiler, which for these tests' coordinates tells
/// the sign: an oracle apart from the library's.
inline long double precise_area(const std::vector<Point2>& p, const Triangle& t) {
  const Point2 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
  return (static_cast<long double>(b.u) - a.u) * (static_cast<long double>(c.v) - a.v) -
         (static_cast<long double>(b.v) - a.v) * (static_cast<long double>(c.u) - a.u);
}

/// How often each directed edge occurs in the triangles.
inline std::map<Edge, int> directed_edges(const std::vector<Triangle>& triangles) {
  std::map<Edge, int> count;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
  }
  return count;
}

/// What is wrong with triangles that should fill the region to the left of the edges: none negative, each edge used by
/// one triangle to its left, all other sides of triangles shared by two. Empty: nothing.
inline const char* fault(const std::vector<Point2>& points, const std::vector<Edge>& edges,
                         const std::vector<Triangle>& triangles) {
  for (const Triangle& t : triangles) {
    if (!(precise_area(points, t) > 0)) return "a triangle is not positive";
  }
  std::map<Edge, int> sides = directed_edges(triangles);
  for (const auto& [side, times] : sides) {
    if (times != 1) return "two triangles on one side of an edge";
  }
  for (const Edge& e : edges) {
    if (!sides.contains(e)) return "a given edge has no triangle to its left";
  }
  std::vector<Edge> sorted = edges;
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [side, times] : sides) {
    const bool is_given = std::binary_search(sorted.begin(), sorted.end(), side);
    if (!is_given && !sides.contains({side[1], side[0]})) return "a triangle ends at an edge that is not given";
  }
  return "";
}

/// Smallest angle of each triangle [degrees].
inline std::vector<double> smallest_angles(const std::vector<Point2>& p, const std::vector<Triangle>& triangles) {
  std::vector<double> result;
  for (const Triangle& t : triangles) {
    double least = 180;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 &a = p[t[k]], &b = p[t[(k + 1) % 3]], &c = p[t[(k + 2) % 3]];
      const double cross = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
      const double dot = (b.u - a.u) * (c.u - a.u) + (b.v - a.v) * (c.v - a.v);
      least = std::min(least, std::atan2(cross, dot) * 180 / M_PI);
    }
    result.push_back(least);
  }
  return result;
}

}  // namespace nearwall::planar

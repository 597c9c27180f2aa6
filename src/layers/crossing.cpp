#include "crossing.h"

#include <algorithm>
#include <vector>

namespace nearwall::layers {

namespace {

/// Part of a point that a corner must have to bear it. One of the three always has a third.
constexpr double kBearing = 0.25;

/// Points in which the edges of one triangle meet the plane of another.
std::vector<Vec3> edges_in_plane(const std::array<Vec3, 3>& edges, const std::array<Vec3, 3>& plane) {
  const Vec3 normal = cross(plane[1] - plane[0], plane[2] - plane[0]);
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &p = edges[k], &q = edges[(k + 1) % 3];
    const double above_p = dot(p - plane[0], normal), above_q = dot(q - plane[0], normal);
    if ((above_p > 0) != (above_q > 0)) points.push_back(p + (q - p) * (above_p / (above_p - above_q)));
  }
  return points;
}

std::array<double, 3> barycentric(const std::array<Vec3, 3>& triangle, const Vec3& p) {
  const Vec3 normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  std::array<double, 3> parts{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = triangle[(k + 1) % 3], &b = triangle[(k + 2) % 3];
    parts[k] = dot(cross(b - a, p - a), normal) / squared_norm(normal);
  }
  return parts;
}

bool is_inside(const std::array<double, 3>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](double part) { return part >= 0; });
}

}  // namespace

std::array<char, 3> bearing_corners(const std::array<Vec3, 3>& triangle, const std::array<Vec3, 3>& other) {
  std::array<char, 3> bears{};
  const auto bear = [&](const Vec3& p) {
    const std::array<double, 3> parts = barycentric(triangle, p);
    for (std::size_t k = 0; k < 3; ++k) bears[k] = bears[k] || parts[k] >= kBearing;
  };
  for (const Vec3& p : edges_in_plane(triangle, other)) {
    if (is_inside(barycentric(other, p))) bear(p);
  }
  for (const Vec3& p : edges_in_plane(other, triangle)) {
    if (is_inside(barycentric(triangle, p))) bear(p);
  }
  return bears;
}

}  // namespace nearwall::layers

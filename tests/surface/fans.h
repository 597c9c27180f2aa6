#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/angles.h"
#include "tests/support/shapes.h"

/// Fans of normals and what they should give, worked out in other ways than the library's.
namespace nearwall::fans {

/// Random numbers, the same on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) * 0x1p-32; }
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  Vec3 direction() {
    for (;;) {
      const Vec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      if (norm(v) > 0.1 && norm(v) < 1) return normalized(v);
    }
  }

 private:
  std::mt19937 engine_;
};

/// Normals at polar angles from an axis: `polar` and `azimuth` are asked for each.
template <class Polar, class Azimuth>
std::vector<Vec3> round_axis(Random& random, int n, Polar&& polar, Azimuth&& azimuth) {
  const Vec3 axis = random.direction(), x = normalized(cross(axis, random.direction())), y = cross(axis, x);
  std::vector<Vec3> normals;
  for (int i = 0; i < n; ++i) {
    const double p = polar(i), a = azimuth(i);
    const Vec3 normal = axis * std::cos(p) + (x * std::cos(a) + y * std::sin(a)) * std::sin(p);
    normals.push_back(normal * random.uniform(0.01, 100));
  }
  return normals;
}

/// Vectors of long doubles: eleven more bits than the library has.
struct Long {
  long double x, y, z;
};
inline Long to_long(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Long operator+(Long a, Long b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Long operator-(Long a, Long b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Long operator-(Long a) { return {-a.x, -a.y, -a.z}; }
inline long double dot(Long a, Long b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Long cross(Long a, Long b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Long unit(Long a) {
  const long double size = std::sqrt(dot(a, a));
  return {a.x / size, a.y / size, a.z / size};
}
inline long double angle(Long a, Long b) {
  const Long c = cross(a, b);
  return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}
inline long double worst_angle(Long direction, std::span<const Vec3> normals) {
  long double worst = 0;
  for (const Vec3& normal : normals) worst = std::max(worst, angle(direction, to_long(normal)));
  return worst;
}

/// Smallest worst angle that any direction has to the normals, if it is less than a right angle: the best of every
/// vector, every pair's middle and every triple's two centres, each measured against all.
inline long double smallest_worst_angle(std::span<const Vec3> normals) {
  std::vector<Long> units;
  for (const Vec3& normal : normals) units.push_back(unit(to_long(normal)));
  long double best = 8;
  Long best_centre = units[0];
  const auto attempt = [&](Long centre) {
    if (!(dot(centre, centre) > 0)) return;
    centre = unit(centre);
    long double farthest = 0;
    for (std::size_t l = 0; l < units.size() && farthest < best; ++l) {
      const Long chord = units[l] - centre;
      farthest = std::max(farthest, dot(chord, chord));
    }
    if (farthest < best) best = farthest, best_centre = centre;
  };
  for (std::size_t i = 0; i < units.size(); ++i) {
    attempt(units[i]);
    for (std::size_t j = 0; j < i; ++j) {
      attempt(units[i] + units[j]);
      for (std::size_t k = 0; k < j; ++k) {
        const Long centre = cross(units[i] - units[j], units[i] - units[k]);
        attempt(centre);
        attempt(-centre);
      }
    }
  }
  return worst_angle(best_centre, normals);
}

using Whole = std::array<std::int64_t, 3>;
inline std::int64_t dot(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Whole cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Whether no direction sees all of these normals: whether zero lies in the hull of some four, three or two of them
/// (Caratheodory), in whole numbers.
inline bool hull_holds_zero(const std::vector<Whole>& normals) {
  const auto one_sign = [](std::initializer_list<std::int64_t> weights) {
    const auto [low, high] = std::minmax(weights);
    return (low >= 0 || high <= 0) && (low != 0 || high != 0);
  };
  const std::size_t n = normals.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Whole &a = normals[i], &b = normals[j], ab = cross(a, b);
      if (ab == Whole{} && dot(a, b) < 0) return true;
      for (std::size_t k = 0; k < j; ++k) {
        const Whole &c = normals[k], bc = cross(b, c), ca = cross(c, a);
        if (dot(ab, c) == 0) {
          const Whole& plane = ab != Whole{} ? ab : bc != Whole{} ? bc : ca;
          if (one_sign({dot(ab, plane), dot(bc, plane), dot(ca, plane)})) return true;
        }
        for (std::size_t l = 0; l < k; ++l) {
          const Whole& d = normals[l];
          if (one_sign({dot(bc, d), dot(ca, d), dot(ab, d), -dot(ab, c)})) return true;
        }
      }
    }
  }
  return false;
}

/// Open surface round the origin where the octants 0, 1, 3 and 7 (bits: x, y, z > 0) are solid: its normals are +-x,
/// +-y and +-z, so that no direction sees all faces at the origin, vertex 0.
inline mesh::SurfaceMesh corner_that_nothing_sees() {
  std::map<std::array<int, 3>, std::size_t> number;
  std::vector<Vec3> points;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, is_new] = number.try_emplace(at, points.size());
    if (is_new) points.emplace_back(at[0], at[1], at[2]);
    return entry->second;
  };
  vertex({0, 0, 0});
  const auto is_solid = [](int octant) { return octant == 0 || octant == 1 || octant == 3 || octant == 7; };
  std::vector<shapes_for_tests::Corners> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    for (int quadrant = 0; quadrant < 4; ++quadrant) {
      const int below = (quadrant & 1) << next | (quadrant >> 1) << last, above = below | 1 << axis;
      if (is_solid(below) == is_solid(above)) continue;
      std::array<int, 3> b{}, c{}, d{};
      b[next] = d[next] = quadrant & 1 ? 1 : -1;
      c[last] = d[last] = quadrant & 2 ? 1 : -1;
      // b x c points along +axis for equal signs; the normal points out of the solid.
      const bool is_along = (b[next] == c[last]) == is_solid(below);
      const std::size_t from = vertex(is_along ? b : c), to = vertex(is_along ? c : b), middle = vertex(d);
      faces.push_back({0, from, middle});
      faces.push_back({0, middle, to});
    }
  }
  return shapes_for_tests::make_surface(points, faces);
}

}  // namespace nearwall::fans

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "nearwall/surface/fitted_normals.h"
#include "tests/surface/fans.h"

/// What the tests of fitted normals have in common.
namespace nearwall::surface {

inline constexpr std::array kFits = {
    Fit::LinearLeastSquares, Fit::QuadraticLeastSquares, Fit::RenkaCline, Fit::Shepard, Fit::Hardy, Fit::ThinPlate};
inline constexpr std::array<const char*, 6> kFitNames = {"linear",  "quadratic", "Renka-Cline",
                                                         "Shepard", "Hardy",     "thin plate"};
inline const char* name(Fit fit) { return kFitNames[static_cast<std::size_t>(fit)]; }

inline double angle(const Vec3& a, const Vec3& b) { return geometry::angle_between(a, b); }

/// A point with neighbours scattered round it, as heights over a plane.
struct Scattered {
  Vec3 point, t1, t2, axis;
  std::vector<std::array<double, 2>> at;
  std::vector<double> height;
  std::vector<Vec3> neighbours;

  Scattered(fans::Random& random, int n, double smallest_gap = 0.1) {
    point = random.direction() * 3.0;
    axis = random.direction();
    t1 = normalized(cross(axis, random.direction()));
    t2 = cross(axis, t1);
    while (static_cast<int>(at.size()) < n) {
      const std::array<double, 2> p = {random.uniform(-1, 1), random.uniform(-1, 1)};
      const auto far_from = [&](const std::array<double, 2>& q) {
        return std::hypot(p[0] - q[0], p[1] - q[1]) > smallest_gap;
      };
      if (far_from({0, 0}) && std::all_of(at.begin(), at.end(), far_from)) at.push_back(p);
    }
  }
  template <class Height>
  void lift(Height&& height_at) {
    neighbours.clear(), height.clear();
    for (const auto& [x, y] : at) {
      height.push_back(height_at(x, y));
      neighbours.push_back(point + t1 * x + t2 * y + axis * height.back());
    }
  }
  Vec3 normal(long double a, long double b) const {
    return normalized(axis - t1 * static_cast<double>(a) - t2 * static_cast<double>(b));
  }
};

inline double wave(double x, double y) { return 0.4 * std::sin(2 * x + y) + 0.3 * std::cos(3 * y - x) - 0.3; }

}  // namespace nearwall::surface

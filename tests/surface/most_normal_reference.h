#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "nearwall/core/vec3.h"
#include "tests/surface/fans.h"

/// Rings of directions, and what most normal normals of them should be, worked out in other ways than the library's: in
/// long double, by looking everywhere.
namespace nearwall::rings {

using fans::Long;
using Points = std::vector<Vec3>;

/// Directions round an axis at the given azimuths and polar angles.
struct Polar {
  double azimuth, polar;
};

inline Points ring_of(const std::vector<Polar>& polars, const Vec3& axis, const Vec3& beside) {
  const Vec3 x = normalized(cross(cross(axis, beside), axis)), y = cross(axis, x);
  Points points;
  for (const auto& [a, p] : polars) {
    points.push_back(axis * std::cos(p) + (x * std::cos(a) + y * std::sin(a)) * std::sin(p));
  }
  return points;
}

/// Azimuths in order, no two half a turn or more apart.
inline std::vector<double> azimuths(fans::Random& random, int n) {
  for (;;) {
    std::vector<double> a;
    for (int i = 0; i < n; ++i) a.push_back(random.uniform(0, 2 * std::numbers::pi));
    std::sort(a.begin(), a.end());
    double widest = a.front() + 2 * std::numbers::pi - a.back();
    double narrowest = widest;
    for (std::size_t i = 1; i < a.size(); ++i) {
      widest = std::max(widest, a[i] - a[i - 1]);
      narrowest = std::min(narrowest, a[i] - a[i - 1]);
    }
    if (widest < 3.1 && narrowest > 1e-3) return a;
  }
}

/// Star of `n` directions round a random axis; `polar(i)` is asked for each polar angle.
template <class PolarAngle>
Points star(fans::Random& random, int n, PolarAngle&& polar) {
  std::vector<Polar> polars;
  int i = 0;
  for (const double a : azimuths(random, n)) polars.push_back({a, polar(i++)});
  return ring_of(polars, random.direction(), random.direction());
}

/// The ring with each of some arcs cut in two: neighbours in one plane, up to rounding.
inline Points split(fans::Random& random, const Points& ring) {
  Points points;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    points.push_back(ring[k]);
    const Vec3 end = ring[k + 1 == ring.size() ? 0 : k + 1];
    if (random.integer(0, 1) == 1) points.push_back(normalized(ring[k] * random.uniform(0.3, 1) + end));
  }
  return points;
}

/// Vertex of a sharp edge along x with `opening` between its sides, n faces above and at least one below.
inline Points trailing_edge(fans::Random& random, int n, double opening) {
  const double bend = random.uniform(-0.3, 0.3);
  Points points;
  for (int i = 0; i <= n; ++i) {
    const double turn = std::numbers::pi * i / n, lift = opening * random.uniform(0.4, 0.6);
    points.emplace_back(std::cos(turn), -std::sin(turn) + bend, std::sin(turn) * lift);
  }
  points.emplace_back(-0.3, -1 + bend, -opening / 2);
  points.emplace_back(0.2, -0.9 + bend, -opening / 2);
  return points;
}

/// Corner of blocks: neighbours on axes, edges' and cubes' diagonals, going round z.
inline Points of_blocks(fans::Random& random, int n) {
  for (;;) {
    std::vector<std::pair<double, Vec3>> found;
    for (int i = 0; i < n; ++i) {
      const Vec3 p(random.integer(-1, 1), random.integer(-1, 1), random.integer(-1, 1));
      if (p.x() != 0 || p.y() != 0) found.emplace_back(std::atan2(p.y(), p.x()), p);
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Points points;
    for (const auto& [azimuth, p] : found) {
      if (points.empty() || points.back().x() * p.y() - points.back().y() * p.x() != 0 || dot(points.back(), p) < 0) {
        points.push_back(p);
      }
    }
    const auto turns_left = [&](std::size_t k) {
      const Vec3 a = points[k], b = points[k + 1 == points.size() ? 0 : k + 1];
      return a.x() * b.y() - a.y() * b.x() > 0;
    };
    bool goes_round = points.size() >= 3;
    for (std::size_t k = 0; k < points.size(); ++k) goes_round = goes_round && turns_left(k);
    if (goes_round) return points;
  }
}

/// The ring turned at random.
inline Points turned(fans::Random& random, const Points& ring) {
  const Vec3 x = random.direction(), y = normalized(cross(random.direction(), x)), z = cross(x, y);
  Points points;
  for (const Vec3& p : ring) points.push_back(x * p.x() + y * p.y() + z * p.z());
  return points;
}

/// The arcs of a ring about a direction that sees all of them.
class Arcs {
 public:
  Arcs(const Points& ring, const Vec3& centre) : centre_(fans::unit(fans::to_long(centre))) {
    for (const Vec3& p : ring) ends_.push_back(fans::unit(fans::to_long(p)));
    const Long beside = std::abs(centre_.x) < 0.6L ? Long{1, 0, 0} : Long{0, 1, 0};
    east_ = fans::unit(fans::cross(beside, centre_));
    north_ = fans::cross(centre_, east_);
  }

  /// Distance to the nearest arc: angle to the foot on its plane if that lies between the ends, else to an end.
  long double distance(Long x) const {
    long double nearest = 8;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const Long a = ends_[k], b = end(k);
      nearest = std::min(nearest, fans::angle(x, a));
      const Long n = fans::unit(fans::cross(a, b)), foot = x - scaled(n, fans::dot(n, x));
      if (fans::dot(foot, foot) > 0 && fans::dot(fans::cross(a, foot), n) > 0 &&
          fans::dot(fans::cross(foot, b), n) > 0) {
        nearest = std::min(nearest, std::atan2(std::abs(fans::dot(x, n)), std::sqrt(fans::dot(foot, foot))));
      }
    }
    return nearest;
  }

  /// Whether x is nearer to the centre than the arc in its azimuth.
  bool is_inside(Long x) const {
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      if (fans::dot(fans::cross(centre_, ends_[k]), x) >= 0 && fans::dot(fans::cross(centre_, end(k)), x) < 0) {
        return fans::dot(fans::cross(ends_[k], end(k)), x) > 0;
      }
    }
    return true;  // the centre itself
  }

  long double value(Long x) const { return is_inside(x) ? distance(x) : -1; }

  /// Best value found by sampling all directions and climbing from the best few in random directions: a lower bound.
  std::pair<Long, long double> best(fans::Random& random, int n_samples, int n_starts) const {
    std::vector<std::pair<long double, Long>> found = samples(n_samples);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Long> starts;
    for (const auto& [value, x] : found) {
      const bool is_new =
          std::all_of(starts.begin(), starts.end(), [&, at = x](Long s) { return fans::angle(s, at) > 0.2L; });
      if (is_new && static_cast<int>(starts.size()) < n_starts && value > 0) starts.push_back(x);
    }
    std::pair<Long, long double> best{centre_, value(centre_)};
    starts.push_back(centre_);
    for (const Long start : starts) {
      const auto top = climbed(random, start);
      if (top.second > best.second) best = top;
    }
    return best;
  }

  /// Largest value in rings of directions round x.
  long double best_near(Long x, long double radius, int n) const {
    const Long a = fans::unit(fans::cross(x, std::abs(x.x) < 0.6L ? Long{1, 0, 0} : Long{0, 1, 0}));
    const Long b = fans::cross(x, a);
    long double best = -1;
    for (int i = 0; i < n; ++i) {
      const long double turn = 2 * std::numbers::pi_v<long double> * i / n;
      best = std::max(best, value(moved(x, scaled(a, std::cos(turn)) + scaled(b, std::sin(turn)), radius)));
    }
    return best;
  }

  static Long scaled(Long a, long double s) { return {a.x * s, a.y * s, a.z * s}; }

 private:
  Long end(std::size_t k) const { return ends_[k + 1 == ends_.size() ? 0 : k + 1]; }

  static Long moved(Long x, Long aside, long double by) {
    return fans::unit(scaled(x, std::cos(by)) + scaled(aside, std::sin(by)));
  }

  /// Directions between the centre and the arcs, evenly over azimuths and over fractions of the way.
  std::vector<std::pair<long double, Long>> samples(int n) const {
    std::vector<std::pair<long double, Long>> found;
    for (int i = 0; i < n; ++i) {
      const long double turn = 2 * std::numbers::pi_v<long double> * i / n;
      const Long aside = scaled(east_, std::cos(turn)) + scaled(north_, std::sin(turn));
      long double inside = 0, outside = std::numbers::pi_v<long double>;
      for (int step = 0; step < 40; ++step) {
        const long double middle = (inside + outside) / 2;
        (is_inside(moved(centre_, aside, middle)) ? inside : outside) = middle;
      }
      for (int j = 1; j < n / 2; ++j) {
        const Long x = moved(centre_, aside, inside * 2 * j / n);
        found.emplace_back(value(x), x);
      }
    }
    return found;
  }

  std::pair<Long, long double> climbed(fans::Random& random, Long x) const {
    long double best = value(x), step = 0.1L;
    while (step > 1e-13L) {
      int n_failures = 0;
      while (n_failures < 12) {
        const Long d = fans::to_long(random.direction()), aside = d - scaled(x, fans::dot(d, x));
        const Long y = moved(x, fans::unit(aside), step);
        const long double there = value(y);
        there > best ? (x = y, best = there, n_failures = 0) : ++n_failures;
      }
      step /= 2;
    }
    return {x, best};
  }

  std::vector<Long> ends_;
  Long centre_, east_{}, north_{};
};

}  // namespace nearwall::rings

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <span>
#include <string>

#include <fmt/format.h>

#include "nearwall/core/vec3.h"

/// Cells that are made to deceive: on the border between positive and not, or a last place away from it.
namespace nearwall::adversary {

enum class Trap {
  Touching,       ///< det J touches zero inside: c1² = c0 c2
  Coplanar,       ///< all corners on one plane
  OnCornerPlane,  ///< a corner on the plane of three others
  Collapsed,      ///< corners that coincide, or nearly
  SmallIntegers,  ///< coordinates of a few values only
  ThinLayer,      ///< a millionth as thick as wide, anywhere
  FewPlaces,      ///< so far from the origin that a few last places are all there is
  Denormal        ///< coordinates below 2^-1022
};

inline constexpr std::array kAllTraps{Trap::Touching,      Trap::Coplanar,  Trap::OnCornerPlane, Trap::Collapsed,
                                      Trap::SmallIntegers, Trap::ThinLayer, Trap::FewPlaces,     Trap::Denormal};

inline std::string name_of(Trap trap) {
  constexpr std::array kNames{"Touching",      "Coplanar",  "OnCornerPlane", "Collapsed",
                              "SmallIntegers", "ThinLayer", "FewPlaces",     "Denormal"};
  return kNames[static_cast<std::size_t>(trap)];
}

/// The coordinates with all their bits, for messages.
inline std::string text_of(std::span<const Vec3> points) {
  std::string text;
  for (const Vec3& p : points) text += fmt::format("({:a}, {:a}, {:a}) ", p.x(), p.y(), p.z());
  return text;
}

class Adversary {
 public:
  explicit Adversary(Trap trap, unsigned seed) : trap_(trap), random_(seed) {}

  std::array<Vec3, 4> tetrahedron() {
    constexpr std::array<Vec3, 4> kUnit{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    return trapped(kUnit, 3);
  }
  std::array<Vec3, 5> pyramid() {
    constexpr std::array<Vec3, 5> kUnit{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    return trapped(kUnit, 4);
  }
  std::array<Vec3, 6> wedge() {
    constexpr std::array<Vec3, 6> kUnit{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0),
                                        Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)};
    if (trap_ == Trap::Touching) return disguised(touching_wedge());
    return trapped(kUnit, 3);
  }
  std::array<Vec3, 8> hexahedron() {
    constexpr std::array<Vec3, 8> kUnit{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0),
                                        Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)};
    if (trap_ == Trap::Touching) return disguised(touching_hexahedron());
    return trapped(kUnit, 4);
  }

  int integer(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

  /// Moves some coordinates, often none, by a last place.
  template <std::size_t N>
  void nudge(std::array<Vec3, N>& p) {
    for (int n = integer(0, 3); n > 0; --n) {
      double& x = p[static_cast<std::size_t>(integer(0, N - 1))][integer(0, 2)];
      x = std::nextafter(
          x, integer(0, 1) ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity());
    }
  }

 private:
  double number() { return std::uniform_real_distribution(-1.0, 1.0)(random_); }
  Vec3 integers(int range) {
    return {static_cast<double>(integer(-range, range)), static_cast<double>(integer(-range, range)),
            static_cast<double>(integer(-range, range))};
  }
  Vec3 numbers() { return {number(), number(), number()}; }

  /// Between z = 0 and z = 4; its three quadratics are 4 r² times (1 − t − r t)² with r = 1/2, 1, 2 or 3: a double root
  /// at t = 1 / (1 + r).
  std::array<Vec3, 6> touching_wedge() {
    constexpr std::array<std::array<int, 2>, 4> kRatios{{{1, 2}, {1, 1}, {2, 1}, {3, 1}}};
    const auto [m, n] = kRatios[static_cast<std::size_t>(integer(0, 3))];
    // The top's edges e = (−m + pq, p²), f = (−q², −m − pq) over those of the bottom, n times the unit ones: the mixed
    // coefficient is n (e.x + f.y) / 2 = −n m, the last one e × f = m².
    const int p = integer(-3, 3), q = integer(-3, 3);
    const Vec3 up(integer(-4, 4), integer(-4, 4), 4);
    const Vec3 e(-m + p * q, p * p, 0), f(-q * q, -m - p * q, 0);
    return {Vec3(0, 0, 0), Vec3(n, 0, 0), Vec3(0, n, 0), up, up + e, up + f};
  }

  /// The wedge at one corner of a hexahedron, which then touches zero on an edge; or four times the same, on a plane.
  std::array<Vec3, 8> touching_hexahedron() {
    const auto w = touching_wedge();
    const bool on_plane = integer(0, 3) == 0;
    const Vec3 opposite = on_plane ? w[1] + w[2] - w[0] : w[1] + w[2] - w[0] + integers(1);
    const Vec3 top = on_plane ? w[4] + w[5] - w[3] : w[4] + w[5] - w[3] + integers(1);
    return {w[0], w[1], opposite, w[2], w[3], w[4], top, w[5]};
  }

  template <std::size_t N>
  std::array<Vec3, N> trapped(const std::array<Vec3, N>& unit, std::size_t n_bottom) {
    std::array<Vec3, N> p = unit;
    switch (trap_) {
      case Trap::Touching:
      case Trap::Coplanar:
        for (Vec3& x : p) x = Vec3(integer(-9, 9), integer(-9, 9), 0);
        break;
      case Trap::OnCornerPlane: {
        for (Vec3& x : p) x = 6.0 * x + integers(2);
        // The next corner along the bottom, the one before, and a corner above on their plane.
        const auto i = static_cast<std::size_t>(integer(0, static_cast<int>(n_bottom) - 1));
        const Vec3 a = p[(i + 1) % n_bottom] - p[i], b = p[(i + n_bottom - 1) % n_bottom] - p[i];
        p[n_bottom + i % (N - n_bottom)] = p[i] + integer(-1, 2) * a + integer(-1, 2) * b;
        break;
      }
      case Trap::Collapsed: {
        for (Vec3& x : p) x = 6.0 * x + integers(1);
        for (int n = integer(1, 3); n > 0; --n) {
          p[static_cast<std::size_t>(integer(0, N - 1))] = p[static_cast<std::size_t>(integer(0, N - 1))];
        }
        break;
      }
      case Trap::SmallIntegers: {
        const int size = integer(0, 3);
        for (Vec3& x : p) x = size * x + integers(1);
        break;
      }
      case Trap::ThinLayer:
        return thin_layer(unit);
      case Trap::FewPlaces: {
        const Vec3 centre = std::pow(10.0, 6 + 9 * std::abs(number())) * (numbers() + Vec3(1, 1, 1));
        const double place = std::nextafter(max_norm(centre), INFINITY) - max_norm(centre);
        for (Vec3& x : p) x = centre + place * (8.0 * x + integers(3));
        nudge(p);
        return p;
      }
      case Trap::Denormal:
        for (Vec3& x : p) x = std::numeric_limits<double>::denorm_min() * (integer(1, 50) * x + integers(2));
        return p;
    }
    return disguised(p);
  }

  /// Over a triangle or quadrilateral somewhere within 1e6, in doubles as they come.
  template <std::size_t N>
  std::array<Vec3, N> thin_layer(const std::array<Vec3, N>& unit) {
    const Vec3 centre = std::pow(10.0, 6 * std::abs(number())) * numbers();
    const Vec3 a = numbers(), b = numbers();
    const Vec3 normal = cross(a, b);
    const double height = std::pow(10.0, -6 - 8 * std::abs(number()));
    std::array<Vec3, N> p;
    for (std::size_t k = 0; k < N; ++k) {
      p[k] = centre + unit[k].x() * a + unit[k].y() * b + height * unit[k].z() * (normal + 0.9 * numbers());
    }
    return p;
  }

  /// The same cell, exactly, in another place: turned and sheared by integers, moved, scaled by a power of two; then
  /// nudged. Positive matrices only.
  template <std::size_t N>
  std::array<Vec3, N> disguised(std::array<Vec3, N> p) {
    const int s = integer(-3, 3), t = integer(-3, 3), u = integer(-3, 3), v = integer(-3, 3);
    const Vec3 offset = std::ldexp(1.0, integer(0, 40)) * integers(9);  // below 2^44: sums are exact
    const int axis = integer(0, 2);
    constexpr std::array<int, 8> kScales{0, 0, 0, -40, 500, -500, -345, -360};  // 2^500: 1e150; products underflow
    const int scale = kScales[static_cast<std::size_t>(integer(0, 7))];
    for (Vec3& x : p) {
      const Vec3 sheared(x.x() + s * x.y() + t * x.z(), x.y() + u * x.z(), x.z());
      const Vec3 twice(sheared.x(), sheared.y() + v * sheared.x(), sheared.z() + s * sheared.x() + t * sheared.y());
      const Vec3 moved = twice + offset;
      for (int k = 0; k < 3; ++k) x[(k + axis) % 3] = std::ldexp(moved[k], scale);
    }
    nudge(p);
    return p;
  }

  Trap trap_;
  std::mt19937_64 random_;
};

}  // namespace nearwall::adversary

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>

#include "nearwall/core/vec3.h"

/// Random points of the kinds that predicates find hard.
namespace nearwall::points_for_tests {

/// In the last two, products of two or three coordinates underflow to a few bits.
enum class Kind {
  Uniform,
  SmallIntegers,
  NearlyCoplanar,
  Huge,
  Tiny,
  MixedScales,
  FarAway,
  TinyNearlyCoplanar,
  TinyAcross
};

inline constexpr std::array kAllKinds{
    Kind::Uniform,     Kind::SmallIntegers, Kind::NearlyCoplanar,     Kind::Huge,      Kind::Tiny,
    Kind::MixedScales, Kind::FarAway,       Kind::TinyNearlyCoplanar, Kind::TinyAcross};

inline std::string name_of(Kind kind) {
  constexpr std::array kNames{"Uniform",     "SmallIntegers", "NearlyCoplanar",     "Huge",      "Tiny",
                              "MixedScales", "FarAway",       "TinyNearlyCoplanar", "TinyAcross"};
  return kNames[static_cast<std::size_t>(kind)];
}

class Points {
 public:
  explicit Points(Kind kind, unsigned seed = 1) : kind_(kind), random_(seed) {}

  double number() { return std::uniform_real_distribution(-1.0, 1.0)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

  Vec3 next() {
    const Vec3 p(number(), number(), number());
    switch (kind_) {
      case Kind::Uniform:
        return p;
      case Kind::SmallIntegers:
        return Vec3(integer(-2, 2), integer(-2, 2), integer(-2, 2));
      case Kind::NearlyCoplanar:
        return nearly_coplanar(p);
      case Kind::Huge:
        return 1e150 * p;
      case Kind::Tiny:
        return 1e-150 * p;
      case Kind::MixedScales:
        return {std::ldexp(p.x(), integer(-90, 90)), std::ldexp(p.y(), integer(-90, 90)),
                std::ldexp(p.z(), integer(-90, 90))};
      case Kind::FarAway:  // a few last places apart
        return Vec3(1e6, -3e6, 2e6) + 0x1p-31 * Vec3(integer(-3, 3), integer(-3, 3), integer(-3, 3));
      case Kind::TinyNearlyCoplanar:
        return 0x1p-345 * nearly_coplanar(p);
      case Kind::TinyAcross:
        return {0x1p-533 * p.x(), 0x1p-533 * p.y(), p.z()};
    }
    return p;
  }

  template <std::size_t N>
  std::array<Vec3, N> next_array() {
    std::array<Vec3, N> points;
    for (Vec3& p : points) p = next();
    return points;
  }

 private:
  /// x + 2 y + 3 z = 1 up to some last places.
  Vec3 nearly_coplanar(const Vec3& p) {
    return {p.x(), p.y(), (1.0 - p.x() - 2.0 * p.y()) / 3.0 + 0x1p-53 * integer(-2, 2)};
  }

  Kind kind_;
  std::mt19937_64 random_;
};

}  // namespace nearwall::points_for_tests

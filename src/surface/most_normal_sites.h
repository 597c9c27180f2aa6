#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "nearwall/core/vec3.h"
#include "surface/most_normal_ring.h"

namespace nearwall::surface {

/// What a direction keeps its distance from: the plane of an arc (axis · x = sine) or a vertex (axis · x = cosine).
struct Site {
  Vec3 axis;
  std::size_t arc = 0;  ///< whose plane it is, or which starts at the vertex
  bool is_vertex = false;
  std::size_t arc_before = 0;  ///< which ends at the vertex

  /// Whether one is a vertex and the other the plane of an arc that ends there.
  bool is_end_of(const Site& other) const {
    return is_vertex && !other.is_vertex && (other.arc == arc || other.arc == arc_before);
  }
};

/// A few directions, unit vectors.
struct Directions {
  std::array<Vec3, 4> at;
  std::size_t n = 0;

  void add(const Vec3& x) { at[n++] = x; }
  std::span<const Vec3> all() const& { return {at.data(), n}; }
  std::span<const Vec3> all() && = delete;  // would point into what is gone
};

/// Directions whose distance from both sites is the level's; at an arc and its own end, the one where their level
/// circles touch. Equations (5) to (8) of docs/theory/most-normal.md.
Directions at_level(const Site& a, const Site& b, const Level& level);

/// Directions equally far from three sites, no farther than a right angle. Equations (9) to (12).
Directions equally_far(const Site& a, const Site& b, const Site& c);

/// The direction equally far from two sites and farther than its neighbours on their bisector, if there is one no
/// farther than a right angle. Where all of the bisector is equally far: its direction nearest to `towards`. Equations
/// (13) and (14).
Directions farthest_of_pair(const Site& a, const Site& b, const Vec3& towards);

}  // namespace nearwall::surface

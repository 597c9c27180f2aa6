#pragma once

#include <optional>
#include <span>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/arctangent.h"
#include "nearwall/surface/normals.h"
#include "surface/scratch.h"

namespace nearwall::surface {

/// Angle in [0, pi] by its sine and cosine: it keeps its digits everywhere, and is compared without inverse functions.
struct Distance {
  double sine = 0;
  double cosine = 1;

  double angle() const { return geometry::angle_from(sine, cosine); }
};
inline bool is_less(const Distance& a, const Distance& b) { return a.sine * b.cosine < a.cosine * b.sine; }

/// The distance and a step more, or less; |step| < 1e-8 rad, since its square is left out.
inline Distance moved(const Distance& d, double step) { return {d.sine + d.cosine * step, d.cosine - d.sine * step}; }

/// A distance at most a right angle that many points are held against.
struct Level {
  explicit Level(const Distance& d);

  double sine, cosine;
  bool is_large;      ///< above 45 degrees, where cosines tell distances apart best; sines do below
  double sine_limit;  ///< a plane whose sine is above this is surely farther
  double squared_cosine;
  double squared_chord;  ///< of points at that distance
};

/// Great arc in which one face cuts the unit sphere round the apex.
struct Arc {
  Vec3 start;   ///< P_i, unit vector
  Vec3 normal;  ///< n_i, unit vector into the fluid, square to the arc
  Vec3 ahead;   ///< n_i x P_i: direction of the arc at its start
  Vec3 beyond;  ///< n_i x P_(i+1): direction of the arc at its end

  /// Whether the foot of x on the arc's great circle lies on the arc, up to `slack`.
  bool has_foot(const Vec3& x, double slack = 0) const { return dot(x, ahead) >= -slack && dot(x, beyond) <= slack; }
};

/// How far a direction is from the nearest arc.
struct Place {
  Distance distance;
  bool is_inside = false;  ///< in the fluid
  std::size_t site = 0;    ///< number of the arc, or n_arcs and that of the arc which starts at the nearest vertex
};

/// Closed ring of arcs about a direction that sees all of them.
class Ring {
 public:
  explicit Ring(std::size_t n) : arcs_(n), reflex_(n) {}

  /// Fills the ring. \returns whether it is one that goes round the most visible normal once
  /// \throws InputError if a coordinate is not finite
  bool prepare(const Vec3& apex, std::span<const Vec3> neighbours);

  const Vec3& most_visible() const { return most_visible_; }
  std::span<const Arc> arcs() const { return arcs_.all(); }
  /// Numbers of the arcs whose start is a vertex where the fluid takes up half a turn or more.
  std::span<const std::size_t> reflex() const { return reflex_.all(); }
  std::size_t before(std::size_t k) const { return (k == 0 ? arcs_.all().size() : k) - 1; }
  std::size_t after(std::size_t k) const { return k + 1 == arcs_.all().size() ? 0 : k + 1; }

  /// Distance of x from the nearest arc, and on which side it is. Cost: O(n).
  Place place(const Vec3& x) const;

  /// Whether no arc is nearer to x than the level.
  /// \param order  numbers of the arcs, in which they are asked; the one in the way moves ahead
  bool keeps_clear(const Vec3& x, const Level& level, std::span<std::size_t> order) const;

  bool is_seen(const Vec3& x) const;

 private:
  /// \param points  the starts of the arcs, as given
  bool find_most_visible(const Vec3& apex, std::span<const Vec3> points);
  bool goes_round_once() const;
  bool is_nearer(const Arc& arc, const Vec3& x, const Level& level) const;

  Scratch<Arc> arcs_;
  Scratch<std::size_t> reflex_;
  Vec3 most_visible_;
};

}  // namespace nearwall::surface

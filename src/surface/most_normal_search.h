#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "nearwall/core/vec3.h"
#include "surface/most_normal_ring.h"
#include "surface/most_normal_sites.h"

namespace nearwall::surface {

/// Least turn, in cosine, with which three sites hold a sharp maximum.
inline constexpr double kSharp = 1e-6;

/// A direction in the fluid and its distance from the nearest arc.
struct Candidate {
  Vec3 direction;
  Distance distance;
  std::size_t nearest = 0;  ///< site, numbered as in `Place`
};

/// Level above the best distance at which it is proved that nothing is better [rad]: more than the rounding of
/// distances, less than anybody asks for.
inline constexpr double kDistanceStep = 1e-12;

/// Search for the direction farthest from the arcs of a ring that nothing is farther from than a right angle.
/// docs/theory/most-normal.md from "Candidates and proof" on.
class Search {
 public:
  explicit Search(const Ring& ring);

  const Candidate& best() const { return best_; }

  /// Goes uphill from the best direction, to where the two or three sites in its way hold it, again and again.
  void climb();

  /// Whether the sites that hold the best direction prove by themselves that no other is as good.
  bool is_proven() const;

  /// Finds and proves the best direction, and of several equally good ones that nearest to the most visible normal.
  Candidate prove();

 private:
  /// Numbers of sites: the planes of the arcs from 0 on, the starts of the arcs from n_arcs on.
  struct Support {
    std::array<std::size_t, 3> site{};
    std::size_t n = 0;
  };

  /// Sites that may hold a maximum: all planes, and the vertices that are not convex.
  std::size_t n_sites() const { return ring_.arcs().size() + ring_.reflex().size(); }
  std::size_t number(std::size_t i) const {
    const std::size_t n = ring_.arcs().size();
    return i < n ? i : n + ring_.reflex()[i - n];
  }
  Site site(std::size_t q) const;
  Vec3 foot(const Vec3& x, std::size_t q) const;
  bool is_in_zone(const Vec3& x, std::size_t q) const;

  static bool is_in_question(const Place& place);
  bool keeps_clear(const Vec3& x, const Level& level) { return ring_.keeps_clear(x, level, order_.all()); }
  bool raise(const Vec3& x, double gain = 0);
  bool raise_from(const Support& support);
  bool raise_from_any(const std::array<std::size_t, 3>& sites);
  /// Points of the support that are nearest to the best direction.
  using Hold = std::array<Vec3, 3>;
  /// Angles about the best direction within which nothing is as good, to the side given and to the other; sine 0 if
  /// that is not known.
  struct Local {
    Vec3 side;
    Distance positive, negative;
  };
  struct Top {
    Hold hold;
    Local local;
  };
  bool find_top();
  Local local_proof_by_three(const Hold& hold) const;
  Local local_proof_by_two(const Hold& hold) const;
  bool is_proven_beyond(const Top& top) const;

  bool is_barred(std::size_t q, const Level& level, const Level& clear) const;
  template <class Visit>
  bool visit_corners(double step, double slack, Visit&& visit);
  template <class Visit>
  void visit_candidates(std::size_t i, std::size_t j, Visit&& visit) const;
  bool is_alone();
  void rise();
  /// A direction as good as the best one, and the sites at whose level it is.
  struct Preferred {
    Vec3 direction;
    std::size_t first, second;
  };
  bool is_nearer_to_most_visible(const Vec3& x, const Vec3& y) const;
  Vec3 nearest_at(std::size_t q, const Level& level) const;
  Preferred preferred();
  Candidate nearest_to_most_visible();

  const Ring& ring_;
  Candidate best_;
  Support support_;             ///< what the best direction was computed from
  std::optional<Top> top_;      ///< set if it is known to hold it
  Scratch<std::size_t> order_;  ///< arcs, those often in the way first
};

}  // namespace nearwall::surface

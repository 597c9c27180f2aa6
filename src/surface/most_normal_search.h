#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "nearwall/core/vec3.h"
#include "surface/most_normal_ring.h"
#include "surface/most_normal_sites.h"

namespace nearwall::surface {

/// A direction in the fluid and its distance from the nearest arc.
struct Candidate {
  Vec3 direction;
  Distance distance;
};

/// Search for the direction farthest from the arcs of a ring that nothing is farther from than a right angle.
/// docs/theory/most-normal.md, steps 3 to 5.
class Search {
 public:
  explicit Search(const Ring& ring);

  const Candidate& best() const { return best_; }

  /// Goes uphill from the best direction: to the point equally far from the three sites that hold it there, again and
  /// again.
  void climb();

  /// Whether the three sites that hold the best direction prove by themselves that no other is as good.
  bool is_proven() const;

  /// Finds and proves the best direction, and of several equally good ones that nearest to the most visible normal.
  Candidate prove();

 private:
  using Support = std::array<std::size_t, 3>;

  std::size_t n_sites() const { return ring_.arcs().size() + ring_.reflex().size(); }
  Site site(std::size_t q) const;
  Vec3 foot(const Vec3& x, std::size_t q) const;
  bool is_in_zone(const Vec3& x, std::size_t q) const;

  bool raise(const Vec3& x);
  std::optional<Support> support_of(const Vec3& x) const;
  double spread() const;

  template <class Visit>
  bool visit_corners(const Distance& distance, double slack, Visit&& visit);
  template <class Visit>
  void visit_candidates(std::size_t i, std::size_t j, Visit&& visit) const;
  bool is_alone();
  void rise();
  Candidate nearest_to_most_visible();
  bool is_preferred(const Candidate& a, const Candidate& b) const;

  const Ring& ring_;
  Candidate best_;
  std::optional<Support> support_;
  std::size_t in_the_way_ = 0;
};

}  // namespace nearwall::surface

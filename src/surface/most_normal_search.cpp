#include "surface/most_normal_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/normals_cap.h"

namespace nearwall::surface {

namespace {

/// Directions whose distances differ by less are equally good [rad].
constexpr double kTie = 1e-10;

/// Level above the best distance at which it is proved that nothing is better [rad]: more than the rounding of
/// distances, less than anybody asks for.
constexpr double kStep = 1e-12;

/// Directions this near to each other are one maximum [rad]: more than the width of a smooth one at a depth of kTie.
constexpr double kNear = 1e-4;

/// Directions whose distances from the most visible normal differ by less are equally near [rad].
constexpr double kEquallyNear = 1e-7;

/// How far out of its zone a site may still hold a corner: corners on the border must not fall between two zones.
constexpr double kZone = 1e-9;

/// By how much the three sites' proof has to hold, so that it covers ties, too.
constexpr double kMargin = 1e-6;

/// Rounds of climbing: two or three are usual, and what is left is left to the proof.
constexpr int kRounds = 8;

}  // namespace

Search::Search(const Ring& ring) : ring_(ring), best_{ring.most_visible(), ring.place(ring.most_visible()).distance} {}

Site Search::site(std::size_t q) const {
  const std::size_t n = ring_.arcs().size();
  if (q < n) return {ring_.arcs()[q].normal, q, false, q};
  const std::size_t k = ring_.reflex()[q - n];
  return {ring_.arcs()[k].start, k, true, ring_.before(k)};
}

/// The point of a site that is nearest to x; zero for an arc whose end is nearer.
Vec3 Search::foot(const Vec3& x, std::size_t q) const {
  const std::size_t n = ring_.arcs().size();
  if (q >= n) return ring_.arcs()[ring_.reflex()[q - n]].start;
  const Arc& arc = ring_.arcs()[q];
  if (!arc.has_foot(x)) return {};
  return unit_vector(arc.start * dot(x, arc.start) + arc.ahead * dot(x, arc.ahead));
}

/// Whether x is among the directions whose nearest point, if it is on this site or beside it, is on it.
bool Search::is_in_zone(const Vec3& x, std::size_t q) const {
  const std::size_t n = ring_.arcs().size();
  if (q < n) return ring_.arcs()[q].has_foot(x, kZone);
  const std::size_t k = ring_.reflex()[q - n];
  return dot(x, ring_.arcs()[k].ahead) <= kZone && dot(x, ring_.arcs()[ring_.before(k)].beyond) >= -kZone;
}

/// Takes x as the best direction if it is better.
bool Search::raise(const Vec3& x) {
  const Place place = ring_.place(x);
  if (!place.is_inside || !is_less(best_.distance, place.distance)) return false;
  best_ = {x, place.distance};
  return true;
}

/// The three sites whose nearest points span the facet, of the convex hull of all nearest points, that x leaves
/// through: the optimum of the linear programme min over v of max over points u of v · u with v · x = 1.
std::optional<Search::Support> Search::support_of(const Vec3& x) const {
  Scratch<Vec3> planes(ring_.arcs().size());
  for (std::size_t q = 0; q < ring_.arcs().size(); ++q) planes.add(foot(x, q));
  const auto point = [&](std::size_t q) { return q < planes.all().size() ? planes.all()[q] : foot(x, q); };
  const std::size_t n = n_sites();
  std::size_t nearest = n;
  double largest = -2;
  for (std::size_t q = 0; q < n; ++q) {
    const Vec3 u = point(q);
    const double cosine = u == Vec3{} ? -2 : dot(x, u);
    if (cosine > largest) largest = cosine, nearest = q;
  }
  if (nearest == n) return std::nullopt;
  // Seen from x: the last point on the left and on the right of the nearest one, so that it lies between.
  std::size_t left = n, right = n;
  const Vec3 axis = cross(x, point(nearest));
  for (std::size_t q = 0; q < n; ++q) {
    const Vec3 u = point(q);
    const double side = dot(axis, u);
    if (q == nearest || u == Vec3{} || side == 0) continue;
    std::size_t& last = side > 0 ? left : right;
    if (last == n || dot(cross(x, point(last)), u) * side > 0) last = q;
  }
  if (left == n || right == n || !(dot(cross(x, point(left)), point(right)) > 0)) return std::nullopt;
  Support corner{nearest, left, right};
  for (std::size_t round = 0; round < n; ++round) {
    const Vec3 a = point(corner[0]), b = point(corner[1]), c = point(corner[2]);
    const Vec3 outward = cross(b - a, c - a);
    std::size_t beyond = n;
    double farthest = 4 * std::numeric_limits<double>::epsilon() * norm(outward);
    for (std::size_t q = 0; q < n; ++q) {
      const Vec3 u = point(q);
      const double height = u == Vec3{} ? 0 : dot(outward, u - a);
      if (height > farthest) farthest = height, beyond = q;
    }
    if (beyond == n) break;
    // Of the three facets between the point beyond and the edges, the one that x leaves through.
    const Vec3 to = cross(x, point(beyond));
    const bool is_left_of_a = dot(to, a) < 0, is_left_of_b = dot(to, b) < 0, is_left_of_c = dot(to, c) < 0;
    corner[is_left_of_b && !is_left_of_a ? 2 : is_left_of_c && !is_left_of_b ? 0 : 1] = beyond;
  }
  return corner;
}

void Search::climb() {
  for (int round = 0; round < kRounds; ++round) {
    const auto support = support_of(best_.direction);
    if (!support || support == support_) return;
    const auto& [i, j, k] = *support;
    bool is_better = false;
    for (const Vec3& x : equally_far(site(i), site(j), site(k)).all()) is_better |= raise(x);
    if (!is_better) return;
    support_ = support;
    if (is_proven()) return;
  }
}

/// Smallest cosine, over all directions to leave the best one, of the turn to the nearest point of one of its three
/// sites; negative if they do not surround it or something else is nearer.
double Search::spread() const {
  if (!support_) return -1;
  const Vec3& x = best_.direction;
  std::array<Vec3, 3> aside;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 u = foot(x, (*support_)[k]);
    if (u == Vec3{} || std::abs(dot(u, x) - best_.distance.cosine) > kStep) return -1;
    aside[k] = u - x * dot(u, x);
  }
  double widest = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = aside[k], &b = aside[(k + 1) % 3];
    if (!(dot(x, cross(a, b)) > 0)) return -1;
    widest = std::min(widest, dot(a, b) / std::sqrt(squared_norm(a) * squared_norm(b)));
  }
  return std::sqrt(std::max(0.0, 0.5 * (1.0 + widest)));
}

bool Search::is_proven() const {
  const double cosine = best_.distance.cosine;
  return spread() * (1.0 - cosine) > cosine + kMargin && !ring_.place(-best_.direction).is_inside;
}

/// Calls `visit(x, i, j)` for the corners of the set of directions at least that far, i > j being the sites whose level
/// circles meet at x, until it returns false. \returns whether it never did
/// \param slack  what the other sites may be nearer
template <class Visit>
bool Search::visit_corners(const Distance& distance, double slack, Visit&& visit) {
  const Level level(distance), clear(moved(distance, -slack));
  for (std::size_t i = 0; i < n_sites(); ++i) {
    const Site a = site(i);
    for (std::size_t j = 0; j < i; ++j) {
      for (const Vec3& x : at_level(a, site(j), level).all()) {
        if (!is_in_zone(x, i) || !is_in_zone(x, j) || !ring_.keeps_clear(x, clear, in_the_way_)) continue;
        if (!visit(x, i, j)) return false;
      }
    }
  }
  return true;
}

/// Calls `visit(x)` for what may be the top of a set that has a corner at sites i and j.
template <class Visit>
void Search::visit_candidates(std::size_t i, std::size_t j, Visit&& visit) const {
  const Site a = site(i), b = site(j);
  for (const Vec3& x : farthest_of_pair(a, b, ring_.most_visible()).all()) visit(x);
  for (std::size_t k = 0; k < n_sites(); ++k) {
    if (k == i || k == j) continue;
    const Site c = site(k);
    for (const Vec3& x : equally_far(a, b, c).all()) visit(x);
    for (const Vec3& x : farthest_of_pair(a, c, ring_.most_visible()).all()) visit(x);
    for (const Vec3& x : farthest_of_pair(b, c, ring_.most_visible()).all()) visit(x);
  }
}

/// Whether the best direction is a sharp maximum and nothing far from it is better or as good.
bool Search::is_alone() {
  const double reach = spread() * best_.distance.sine, cosine = best_.distance.cosine;
  if (!(reach > kMargin + kNear * cosine)) return false;
  // Within this angle, half of what the three sites cover, nothing else is better.
  const double covered = cosine / std::sqrt(cosine * cosine + reach * reach);
  return visit_corners(moved(best_.distance, -kTie), kStep,
                       [&](const Vec3& x, std::size_t, std::size_t) { return dot(x, best_.direction) > covered; });
}

/// Raises the best direction until nothing is better by kStep.
void Search::rise() {
  bool is_higher = true;
  while (is_higher && best_.distance.cosine > 2 * kStep) {
    is_higher = !visit_corners(moved(best_.distance, kStep), 0.5 * kStep,
                               [&](const Vec3& corner, std::size_t i, std::size_t j) {
                                 bool is_raised = raise(unit_vector(corner));
                                 visit_candidates(i, j, [&](const Vec3& x) {
                                   const Level level(best_.distance);
                                   if (ring_.keeps_clear(x, level, in_the_way_)) is_raised |= raise(x);
                                 });
                                 return !is_raised;
                               });
  }
}

/// Whether a is to be preferred to b, both being as good as any.
bool Search::is_preferred(const Candidate& a, const Candidate& b) const {
  if (norm(a.direction - b.direction) < kNear) {
    const double gain = a.distance.sine * b.distance.cosine - a.distance.cosine * b.distance.sine;
    if (std::abs(gain) > kStep) return gain > 0;
  }
  const double nearer = distance(b.direction, ring_.most_visible()) - distance(a.direction, ring_.most_visible());
  if (std::abs(nearer) > kEquallyNear) return nearer > 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double ahead = a.direction[axis] - b.direction[axis];
    if (std::abs(ahead) > kEquallyNear) return ahead > 0;
  }
  return false;
}

Candidate Search::nearest_to_most_visible() {
  Candidate chosen = best_;
  const Distance enough = moved(best_.distance, -kTie);
  const Level level(enough);
  const auto choose = [&](const Vec3& x) {
    if (!ring_.keeps_clear(x, level, in_the_way_)) return;
    const Place place = ring_.place(x);
    const Candidate candidate{x, place.distance};
    if (place.is_inside && !is_less(place.distance, enough) && is_preferred(candidate, chosen)) chosen = candidate;
  };
  choose(ring_.most_visible());
  visit_corners(enough, kStep, [&](const Vec3&, std::size_t i, std::size_t j) {
    visit_candidates(i, j, choose);
    return true;
  });
  return chosen;
}

Candidate Search::prove() {
  if (is_alone()) return best_;
  rise();
  return nearest_to_most_visible();
}

}  // namespace nearwall::surface

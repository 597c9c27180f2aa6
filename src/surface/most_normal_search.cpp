#include "surface/most_normal_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/normals_cap.h"

namespace nearwall::surface {

namespace {

/// Directions whose distances differ by less are equally good [rad].
constexpr double kTie = 1e-10;

/// Directions this near to each other are one maximum [rad]: more than the width of a smooth one at a depth of kTie.
constexpr double kNear = 1e-4;

/// Directions whose distances from the most visible normal differ by less are equally near [rad].
constexpr double kEquallyNear = 1e-7;

/// How far out of its zone a site may still hold a corner: corners on the border must not fall between two zones.
constexpr double kZone = 1e-9;

/// Less than what a corner surely gains over the best direction, and far more than rounding.
constexpr double kLeastGain = 0.25 * kDistanceStep;

/// Sweeps over the corners: two or three are usual; after so many the best direction found so far has to do.
constexpr int kSweeps = 64;

/// A computed cosine above another by this much belongs to a smaller angle.
constexpr double kCosineRounding = 0x1p-50;

}  // namespace

Search::Search(const Ring& ring) : ring_(ring), order_(ring.arcs().size()) {
  for (std::size_t k = 0; k < ring.arcs().size(); ++k) order_.add(k);
  const Place place = ring.place(ring.most_visible());
  best_ = {ring.most_visible(), place.distance, place.site};
}

Site Search::site(std::size_t q) const {
  const std::size_t n = ring_.arcs().size();
  if (q < n) return {ring_.arcs()[q].normal, q, false, q};
  return {ring_.arcs()[q - n].start, q - n, true, ring_.before(q - n)};
}

/// Whether x is among the directions whose nearest point, if it is on this site or beside it, is on it.
bool Search::is_in_zone(const Vec3& x, std::size_t q) const {
  const std::size_t n = ring_.arcs().size();
  if (q < n) return ring_.arcs()[q].has_foot(x, kZone);
  const std::size_t k = q - n;
  return dot(x, ring_.arcs()[k].ahead) <= kZone && dot(x, ring_.arcs()[ring_.before(k)].beyond) >= -kZone;
}

/// Whether a direction is in the fluid, as far as this search is concerned: nothing obtuse is, and round the far end of
/// a spike rounding hides which vertex is nearest, and so the side.
bool Search::is_in_question(const Place& place) { return place.is_inside && place.distance.cosine > -kTie; }

/// Takes x as the best direction if it is better by more than `gain`.
bool Search::raise(const Vec3& x, double gain) {
  const Place place = ring_.place(x);
  if (!is_in_question(place) || !is_less(moved(best_.distance, gain), place.distance)) return false;
  best_ = {x, place.distance, place.site};
  top_.reset();
  return true;
}

/// Whether all of a site's level circle, as far as it is in the site's zone, is nearer than `clear` to one same vertex.
bool Search::is_barred(std::size_t q, const Level& level, const Level& clear) const {
  const std::size_t n = ring_.arcs().size();
  const Arc& arc = ring_.arcs()[q < n ? q : q - n];
  const Arc& other = ring_.arcs()[q < n ? ring_.after(q) : ring_.before(q - n)];
  // Ends of the piece of the circle, and its directions there.
  const Vec3 begin = (q < n ? arc.start : other.normal) * (q < n ? level.cosine : level.sine) +
                     (q < n ? arc.normal : arc.start) * (q < n ? level.sine : level.cosine);
  const Vec3 end = (q < n ? other.start : arc.normal) * (q < n ? level.cosine : level.sine) +
                   (q < n ? arc.normal : arc.start) * (q < n ? level.sine : level.cosine);
  const double turn = q < n ? 0 : dot(other.normal, arc.normal);
  const Vec3 ahead = q < n ? arc.ahead : arc.normal - other.normal * turn;
  const Vec3 beyond = q < n ? arc.beyond : arc.normal * turn - other.normal;
  const double least = clear.cosine + kCosineRounding;
  return std::any_of(ring_.arcs().begin(), ring_.arcs().end(), [&](const Arc& by) {
    const Vec3& v = by.start;
    return dot(begin, v) > least && dot(end, v) > least && !(dot(ahead, v) < 0 && dot(beyond, v) > 0);
  });
}

/// Calls `visit(x, i, j)` for the corners of the set of directions farther than the best one by `step`, i and j being
/// the sites whose level circles meet at x, until it returns false. \returns whether it never did
/// \param slack  what the other sites may be nearer
template <class Visit>
bool Search::visit_corners(double step, double slack, Visit&& visit) {
  Distance reached = best_.distance;
  Level level(moved(reached, step)), clear(moved(reached, step - slack));
  Scratch<std::size_t, 48> sites(n_sites());
  for (std::size_t i = 0; i < n_sites(); ++i) {
    if (!is_barred(number(i), level, clear)) sites.add(number(i));
  }
  for (std::size_t later = 0; later < sites.all().size(); ++later) {
    const std::size_t i = sites.all()[later];
    const Site a = site(i);
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const std::size_t j = sites.all()[earlier];
      // The points have a name: what a temporary holds is gone before the loop begins.
      const auto corners = at_level(a, site(j), level);
      for (const Vec3& x : corners.all()) {
        if (!is_in_zone(x, i) || !is_in_zone(x, j) || !keeps_clear(x, clear)) continue;
        if (!visit(x, i, j)) return false;
        if (!is_less(reached, best_.distance)) continue;
        reached = best_.distance;
        level = Level(moved(reached, step)), clear = Level(moved(reached, step - slack));
        break;
      }
    }
  }
  return true;
}

/// Calls `visit(x)` for what may be the top of a set that has a corner at sites i and j.
template <class Visit>
void Search::visit_candidates(std::size_t i, std::size_t j, Visit&& visit) const {
  const auto visit_all = [&](const auto& points) {
    for (const Vec3& x : points.all()) visit(x);
  };
  const Site a = site(i), b = site(j);
  if (i != j) visit_all(farthest_of_pair(a, b, ring_.most_visible()));
  for (std::size_t third = 0; third < n_sites(); ++third) {
    const std::size_t k = number(third);
    if (k == i || k == j) continue;
    const Site c = site(k);
    if (i != j) visit_all(equally_far(a, b, c));
    visit_all(farthest_of_pair(a, c, ring_.most_visible()));
    visit_all(farthest_of_pair(b, c, ring_.most_visible()));
  }
}

/// Whether the best direction is a lone maximum, and nothing far from it is better or as good.
bool Search::is_alone() {
  if (!top_) return false;
  const Local& local = top_->local;
  const Distance& covered = local.positive.sine < local.negative.sine ? local.positive : local.negative;
  if (!(covered.sine > 2 * kNear)) return false;
  return visit_corners(-kTie, kDistanceStep, [&](const Vec3& x, std::size_t, std::size_t) {
    return dot(x, best_.direction) > covered.cosine;
  });
}

/// Raises the best direction until nothing is better by kDistanceStep. A sweep over the corners goes on at the level
/// that it has reached; the next one sees what that passed over.
void Search::rise() {
  const auto can_rise = [this] { return best_.distance.cosine > 2 * kDistanceStep; };
  bool is_higher = true;
  for (int sweep = 0; is_higher && can_rise() && sweep < kSweeps; ++sweep) {
    is_higher = false;
    visit_corners(kDistanceStep, 0.5 * kDistanceStep, [&](const Vec3& corner, std::size_t i, std::size_t j) {
      is_higher |= raise(unit_vector(corner), kLeastGain);
      visit_candidates(i, j, [&](const Vec3& x) {
        if (keeps_clear(x, Level(best_.distance))) is_higher |= raise(x, kLeastGain);
      });
      return can_rise();
    });
  }
}

/// Whether x is to be preferred to y, both being as good as any.
bool Search::is_nearer_to_most_visible(const Vec3& x, const Vec3& y) const {
  const double nearer = distance(y, ring_.most_visible()) - distance(x, ring_.most_visible());
  if (std::abs(nearer) > kEquallyNear) return nearer > 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double ahead = x[axis] - y[axis];
    if (std::abs(ahead) > kEquallyNear) return ahead > 0;
  }
  return false;
}

/// The direction of a site's level circle that is nearest to the most visible normal; zero if all are.
Vec3 Search::nearest_at(std::size_t q, const Level& level) const {
  const Site a = site(q);
  const Vec3 aside = ring_.most_visible() - a.axis * dot(a.axis, ring_.most_visible());
  if (!(squared_norm(aside) > 0)) return {};
  return a.axis * (a.is_vertex ? level.cosine : level.sine) +
         unit_vector(aside) * (a.is_vertex ? level.sine : level.cosine);
}

/// Of the set of directions as good as the best one the nearest to the most visible normal: that itself, or a point of
/// the set's border nearer than those about it.
Search::Preferred Search::preferred() {
  const Distance enough = moved(best_.distance, -kTie);
  const Level level(enough), clear(moved(enough, -kDistanceStep));
  const std::size_t any = number(0);
  Preferred nearest{best_.direction, any, any};
  const auto choose = [&](const Vec3& x, std::size_t i, std::size_t j) {
    if (is_nearer_to_most_visible(x, nearest.direction) && is_in_question(ring_.place(x))) nearest = {x, i, j};
  };
  if (!is_less(ring_.place(ring_.most_visible()).distance, enough)) return {ring_.most_visible(), any, any};
  for (std::size_t k = 0; k < n_sites(); ++k) {
    const std::size_t q = number(k);
    const Vec3 x = nearest_at(q, level);
    if (is_in_zone(x, q) && x != Vec3{} && keeps_clear(x, clear)) choose(unit_vector(x), q, q);
  }
  visit_corners(-kTie, kDistanceStep, [&](const Vec3& x, std::size_t i, std::size_t j) {
    choose(unit_vector(x), i, j);
    return true;
  });
  return nearest;
}

/// The top near the preferred direction, if there is one, else that itself.
Candidate Search::nearest_to_most_visible() {
  const Preferred preferred = this->preferred();
  const auto candidate = [this](const Vec3& x) {
    const Place place = ring_.place(x);
    return Candidate{x, place.distance, place.site};
  };
  Candidate chosen = distance(preferred.direction, best_.direction) < kNear ? best_ : candidate(preferred.direction);
  visit_candidates(preferred.first, preferred.second, [&](const Vec3& x) {
    if (!(distance(preferred.direction, x) < kNear)) return;
    if (!keeps_clear(x, Level(moved(chosen.distance, -kDistanceStep)))) return;
    const Candidate other = candidate(x);
    const bool is_higher = is_less(moved(chosen.distance, kDistanceStep), other.distance);
    if (is_higher || (!is_less(other.distance, moved(chosen.distance, -kDistanceStep)) &&
                      is_nearer_to_most_visible(x, chosen.direction))) {
      chosen = other;
    }
  });
  return chosen;
}

Candidate Search::prove() {
  if (is_alone()) return best_;
  rise();
  return nearest_to_most_visible();
}

}  // namespace nearwall::surface

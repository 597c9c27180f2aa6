#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "surface/most_normal_search.h"
#include "surface/normals_cap.h"

namespace nearwall::surface {

namespace {

/// By how much the proof has to hold, so that it covers ties, too.
constexpr double kMargin = 1e-9;

/// Squared cosine of the distance below which an arc bends round a maximum held by two sites enough for Eq. (17).
constexpr double kFlattest = 0.45;

/// Where y / (1 + 2 y²), the sine in Eq. (17), is largest.
constexpr double kSteepest = std::numbers::sqrt2 / 2;

/// Rounds of climbing: two or three are usual, and what is left is left to the proof.
constexpr int kRounds = 8;

/// Room for the points that programmes after the first take in.
constexpr std::size_t kMoreCuts = 2 * kRounds;

/// Height above a facet, relative to its size, that is rounding.
constexpr double kFlat = 4 * std::numeric_limits<double>::epsilon();

/// Points of the arcs, and the sites they are on.
class Cuts {
 public:
  /// All vertices, which surround x at least, and the points between them that are nearest to x.
  Cuts(const Ring& ring, const Vec3& x)
      : point_(2 * ring.arcs().size() + kMoreCuts), site_(2 * ring.arcs().size() + kMoreCuts) {
    const auto arcs = ring.arcs();
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      const Arc& arc = arcs[k];
      add(arc.start, arcs.size() + k);
      const double ahead = dot(x, arc.ahead);
      if (ahead > 0 && dot(x, arc.beyond) < 0) {
        add(unit_vector(arc.start * dot(x, arc.start) + arc.ahead * ahead), k);
      }
    }
  }

  void add(const Vec3& point, std::size_t site) { point_.add(point), site_.add(site); }
  std::span<const Vec3> points() const { return point_.all(); }
  std::size_t site(std::size_t cut) const { return site_.all()[cut]; }

 private:
  Scratch<Vec3, 48 + kMoreCuts> point_;
  Scratch<std::size_t, 48 + kMoreCuts> site_;
};

/// Three points round x, counterclockwise from x, the first of them the nearest; or none.
std::optional<std::array<std::size_t, 3>> points_around(const Vec3& x, std::span<const Vec3> points) {
  std::size_t nearest = 0;
  double largest = -2;
  for (std::size_t q = 0; q < points.size(); ++q) {
    const double cosine = dot(x, points[q]);
    if (cosine > largest) largest = cosine, nearest = q;
  }
  // The last ones on the left and on the right of the nearest one: it lies between them, if they surround x.
  constexpr auto kNone = std::numeric_limits<std::size_t>::max();
  std::size_t left = kNone, right = kNone;
  Vec3 to_left, to_right;
  const Vec3 axis = cross(x, points[nearest]);
  for (std::size_t q = 0; q < points.size(); ++q) {
    const double side = dot(axis, points[q]);
    if (side > 0 && (left == kNone || dot(to_left, points[q]) > 0)) left = q, to_left = cross(x, points[q]);
    if (side < 0 && (right == kNone || dot(to_right, points[q]) < 0)) right = q, to_right = cross(x, points[q]);
  }
  if (left == kNone || right == kNone || !(dot(to_left, points[right]) > 0)) return std::nullopt;
  return std::array{nearest, left, right};
}

/// Smallest cosine, over all directions to leave x, of the turn to the nearest of three points at the same distance;
/// negative if they do not surround it.
double least_turn(const Vec3& x, const std::array<Vec3, 3>& points) {
  double widest = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = points[k] - x * dot(points[k], x), u = points[(k + 1) % 3], b = u - x * dot(u, x);
    if (!(dot(x, cross(a, b)) > 0)) return -1;
    widest = std::min(widest, dot(a, b) / std::sqrt(squared_norm(a) * squared_norm(b)));
  }
  return std::sqrt(std::max(0.0, 0.5 * (1.0 + widest)));
}

/// Follows points of the ring round a direction, and sees whether all ways to leave it are barred by one of them.
class Cover {
 public:
  /// Ways shorter than `positive`, or `negative`, need not be barred, on the two sides.
  Cover(const Candidate& centre, const Vec3& side, const Distance& positive, const Distance& negative)
      : centre_(centre),
        side_(side),
        positive_{positive.cosine, 1.0 / positive.sine},
        negative_{negative.cosine, 1.0 / negative.sine},
        per_sine_(1.0 / centre.distance.sine) {}

  void add(const Vec3& u) {
    const double height = dot(u, centre_.direction);
    const Vec3 aside = u - centre_.direction * height;
    const Way& way = dot(aside, side_) > 0 ? positive_ : negative_;
    double least = std::max((centre_.distance.cosine * (1.0 + height) + kMargin) * per_sine_,
                            (centre_.distance.cosine + kMargin - way.cosine * height) * way.per_sine);
    const double squared_size = squared_norm(aside), squared_rest = squared_size - least * least;
    if (least > 0 && !(squared_rest > 0)) return;
    if (squared_rest < 0) least = -std::sqrt(squared_size);
    const Bar bar{aside, least, squared_rest > 0 ? std::sqrt(squared_rest) : 0.0};
    if (n_bars_ > 0) {
      if (!(dot(centre_.direction, cross(last_.aside, bar.aside)) > 0)) return void(has_returned_ = false);
      const double together = last_.least * bar.least - last_.rest * bar.rest;
      const bool is_wide = last_.rest * bar.least + last_.least * bar.rest < 0;
      is_unbroken_ = is_unbroken_ && (is_wide || together < dot(last_.aside, bar.aside));
    }
    last_ = bar;
    has_returned_ = true;
    ++n_bars_;
  }

  /// After the first point was added again.
  bool is_unbroken() const { return n_bars_ > 2 && has_returned_ && is_unbroken_; }

 private:
  /// Directions barred: unit vectors e square to the centre with e · aside > least.
  struct Bar {
    Vec3 aside;
    double least = 0, rest = 0;  ///< |aside| times cosine and sine of the half-angle
  };
  struct Way {
    double cosine, per_sine;
  };

  const Candidate& centre_;
  Vec3 side_;
  Way positive_, negative_;
  double per_sine_;
  Bar last_;
  std::size_t n_bars_ = 0;
  bool has_returned_ = false;
  bool is_unbroken_ = true;
};

/// Facet of the hull of points, by three of them, and its normal.
struct Facet {
  std::array<std::size_t, 3> corner{};
  Vec3 outward;
};

bool is_around(const Vec3& x, const std::array<std::size_t, 3>& corner, std::span<const Vec3> points) {
  const Vec3 to_first = cross(x, points[corner[0]]), to_second = cross(x, points[corner[1]]);
  return dot(to_first, points[corner[1]]) > 0 && dot(to_second, points[corner[2]]) > 0 &&
         dot(to_first, points[corner[2]]) < 0;
}

/// Moves `facet` to the one through which x leaves the hull of points: the optimum of the linear programme (15).
/// \returns whether there is one
bool move_to(const Vec3& x, std::span<const Vec3> points, Facet& facet) {
  auto& [a, b, c] = facet.corner;
  if (a == b || !is_around(x, facet.corner, points)) {
    const auto around = points_around(x, points);
    if (!around) return false;
    facet.corner = *around;
  }
  for (std::size_t round = 0; round < points.size(); ++round) {
    facet.outward = cross(points[b] - points[a], points[c] - points[a]);
    std::size_t beyond = points.size();
    double farthest = kFlat * norm(facet.outward);
    for (std::size_t q = 0; q < points.size(); ++q) {
      const double height = dot(facet.outward, points[q] - points[a]);
      if (height > farthest) farthest = height, beyond = q;
    }
    if (beyond == points.size()) break;
    // Of the three facets between the point beyond and the edges, the one that x leaves through.
    const Vec3 to = cross(x, points[beyond]);
    const bool is_left_of_a = dot(to, points[a]) < 0, is_left_of_b = dot(to, points[b]) < 0,
               is_left_of_c = dot(to, points[c]) < 0;
    (is_left_of_b && !is_left_of_a ? c : is_left_of_c && !is_left_of_b ? a : b) = beyond;
  }
  return true;
}

}  // namespace

/// Takes the best of the directions at which the sites may hold a maximum, if one is better than the best so far.
bool Search::raise_from(const Support& support) {
  const Site a = site(support.site[0]), b = site(support.site[1]);
  const Directions tops =
      support.n == 2 ? farthest_of_pair(a, b, ring_.most_visible()) : equally_far(a, b, site(support.site[2]));
  bool is_raised = false;
  for (const Vec3& x : tops.all()) is_raised |= keeps_clear(x, Level(best_.distance)) && raise(x);
  if (is_raised) support_ = support;
  return is_raised;
}

/// The same for three sites, or the two of them that differ, and if that was of no use for each two of the three.
bool Search::raise_from_any(const std::array<std::size_t, 3>& q) {
  if (q[0] == q[1] || q[1] == q[2]) return q[0] != q[2] && raise_from({{q[0], q[2]}, 2});
  if (q[0] == q[2]) return raise_from({{q[0], q[1]}, 2});
  if (raise_from({q, 3})) return true;
  bool is_raised = raise_from({{q[0], q[1]}, 2});
  is_raised |= raise_from({{q[1], q[2]}, 2});
  is_raised |= raise_from({{q[2], q[0]}, 2});
  return is_raised;
}

void Search::climb() {
  Cuts cuts(ring_, best_.direction);
  Facet facet;
  for (int round = 0; round < kRounds; ++round) {
    if (!move_to(best_.direction, cuts.points(), facet)) return;
    const auto& [a, b, c] = facet.corner;
    const double size = norm(facet.outward), height = dot(facet.outward, cuts.points()[a]);
    // No point of the ring is within a right angle of a facet that looks away from it: not the case for this search.
    if (height < 0) return;
    const bool is_raised = raise_from_any({cuts.site(a), cuts.site(b), cuts.site(c)});
    if (is_raised && find_top()) return;
    if (height > (best_.distance.cosine - kDistanceStep) * size) return;
    // The next programme knows what is nearest here and at the optimum of this one.
    const Vec3 optimum = facet.outward / size;
    const std::size_t nearest = ring_.place(optimum).site;
    cuts.add(foot(optimum, nearest), nearest);
    if (is_raised) cuts.add(foot(best_.direction, best_.nearest), best_.nearest);
  }
}

/// Looks whether the support holds the best direction: whether nothing is nearer than its points, and nothing about is
/// as far from them.
bool Search::find_top() {
  Hold hold;
  for (std::size_t k = 0; k < support_.n; ++k) {
    const Vec3 u = foot(best_.direction, support_.site[k]);
    if (u == Vec3{} || std::abs(dot(u, best_.direction) - best_.distance.cosine) > kDistanceStep) return false;
    hold[k] = u;
  }
  const Local local = support_.n == 2 ? local_proof_by_two(hold) : local_proof_by_three(hold);
  if (std::min(local.positive.sine, local.negative.sine) > kSharp) top_ = {hold, local};
  return top_.has_value();
}

/// Angles about the best direction within which its support proves that nothing is as good, Eq. (16).
Search::Local Search::local_proof_by_three(const Hold& hold) const {
  const double cosine = best_.distance.cosine, reach = least_turn(best_.direction, hold) * best_.distance.sine;
  if (!(reach > kSharp)) return {};
  const double size = std::sqrt(reach * reach + cosine * cosine);
  const Distance angle{reach / size, cosine / size};
  return {{}, angle, angle};
}

/// The same, Eq. (17).
Search::Local Search::local_proof_by_two(const Hold& hold) const {
  const std::size_t n = ring_.arcs().size();
  const double cosine = best_.distance.cosine;
  const bool are_arcs = support_.site[0] < n && support_.site[1] < n;
  if (!are_arcs && !(cosine * cosine < kFlattest)) return {};
  // Tangents of the angles, from above.
  double positive = are_arcs ? 1 : kSteepest, negative = positive;
  const Vec3 side = cross(best_.direction, hold[0]);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t q = support_.site[k];
    if (q >= n) continue;
    const bool runs_to_side = dot(cross(ring_.arcs()[q].normal, hold[k]), side) > 0;
    for (const bool is_start : {true, false}) {
      const Vec3& end = ring_.arcs()[is_start ? q : ring_.after(q)].start;
      const double to_end = dot(hold[k], end), along = norm(cross(hold[k], end));
      double& y = is_start == runs_to_side ? negative : positive;
      if (cosine * along < y * to_end) y = cosine * along / to_end;
    }
  }
  const auto angle = [&](double y) {
    const double sine = are_arcs ? y / std::sqrt(1.0 + y * y) : y / (1.0 + 2.0 * y * y);
    return Distance{sine, std::sqrt(1.0 - sine * sine)};
  };
  return {side, angle(positive), angle(negative)};
}

/// Whether points of the ring prove that nothing farther away than the local proof is as good, Eqs. (18) and (19).
bool Search::is_proven_beyond(const Top& top) const {
  const auto arcs = ring_.arcs();
  const std::size_t n = arcs.size(), first = support_.site[0];
  Cover cover(best_, top.local.side, top.local.positive, top.local.negative);
  const auto add_foot = [&](std::size_t arc) {
    for (std::size_t k = 0; k < support_.n; ++k) {
      if (support_.site[k] == arc) cover.add(top.hold[k]);
    }
  };
  const std::size_t start = first < n ? first : first - n;
  if (first >= n) cover.add(top.hold[0]);
  add_foot(start);
  for (std::size_t k = ring_.after(start); k != start; k = ring_.after(k)) {
    cover.add(arcs[k].start);
    add_foot(k);
  }
  if (first < n) cover.add(arcs[start].start);
  cover.add(top.hold[0]);
  return cover.is_unbroken();
}

bool Search::is_proven() const {
  return top_ && is_proven_beyond(*top_) &&
         (ring_.is_seen(best_.direction) || !ring_.place(-best_.direction).is_inside);
}

/// The point of a site that is nearest to x; zero for an arc whose end is nearer.
Vec3 Search::foot(const Vec3& x, std::size_t q) const {
  const std::size_t n = ring_.arcs().size();
  if (q >= n) return ring_.arcs()[q - n].start;
  const Arc& arc = ring_.arcs()[q];
  if (!arc.has_foot(x)) return {};
  return unit_vector(arc.start * dot(x, arc.start) + arc.ahead * dot(x, arc.ahead));
}

}  // namespace nearwall::surface

#include "surface/normals_cap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nearwall::surface {

namespace {

/// Squared chord of 90 degrees: a cap from here on leaves no direction that sees all its vectors.
constexpr double kHemisphere = 2.0;

/// A vector this much (in chord) outside a cap is on its rim: a few roundings of the coordinates of a unit vector.
constexpr double kRim = 4 * std::numeric_limits<double>::epsilon();

/// More than the relative rounding of a sum of squared chords: an angle this near to a right one is taken either way.
constexpr double kRightAngle = 0x1p-49;

double squared_distance(const Vec3& a, const Vec3& b) { return squared_norm(a - b); }

/// Direction of the centre of the circle through a, b and base, on their side. Not normalised; zero for repeated
/// vectors.
Vec3 centre_through(const Vec3& a, const Vec3& b, const Vec3& base) {
  const Vec3 to_a = a - base, to_b = b - base;
  const Vec3 axis = cross(to_a, to_b);
  const double squared_axis = squared_norm(axis), height = dot(axis, base);
  // The axis of a large circle is sharp. That of a small one is blurred by the rounding of the vectors' lengths: there
  // the centre of the circle itself is sharp, which in turn lies too near the origin in large ones.
  if (height * height < 0.5 * squared_axis) return height < 0 ? -axis : axis;
  if (!(squared_axis > 0)) return {};
  const Vec3 weighted = to_b * squared_norm(to_a) - to_a * squared_norm(to_b);
  return base + cross(weighted, axis) / (2.0 * squared_axis);
}

/// The vectors of an active set: at most four.
struct ActiveSet {
  std::array<Vec3, 4> vector{};
  std::array<std::size_t, 4> index{};
  std::size_t n = 0;

  void add(const Vec3& v, std::size_t i) {
    vector[n] = v;
    index[n++] = i;
  }
};

/// A cap through two or three vectors of an active set.
struct Candidate {
  Vec3 centre;
  double squared_chord = std::numeric_limits<double>::infinity();  // to the farthest of the whole active set
  std::array<std::size_t, 3> member{};
  std::size_t n = 0;
};

using SquaredDistances = std::array<std::array<double, 4>, 4>;

bool is_outside(double squared_chord, double squared_radius) {
  return squared_chord > squared_radius + 2 * kRim * std::sqrt(squared_radius) + kRim * kRim;
}

/// Takes the cap about `direction` as the best one if it is smaller: any centre gives a valid upper bound.
/// \returns whether it holds the whole active set and still goes through the last vector
bool consider(const ActiveSet& set, const Vec3& direction, std::array<std::size_t, 3> member, std::size_t n,
              Candidate& best) {
  const double size = norm(direction);
  if (!(size > 0)) return false;
  const Vec3 centre = direction / size;
  const double to_last = squared_distance(set.vector[set.n - 1], centre);
  double farthest = to_last;
  for (std::size_t k = 0; k + 1 < set.n; ++k) farthest = std::max(farthest, squared_distance(set.vector[k], centre));
  if (farthest < best.squared_chord) best = {centre, farthest, member, n};
  return !is_outside(farthest, to_last);
}

/// Considers the caps through the last vector and one other. A cap of a pair holds just those vectors that see the pair
/// under no less than a right angle.
bool consider_pairs(const ActiveSet& set, const SquaredDistances& squared, Candidate& best) {
  const std::size_t last = set.n - 1;
  for (std::size_t i = 0; i < last; ++i) {
    bool may_hold_all = true;
    for (std::size_t k = 0; k < last; ++k) {
      may_hold_all &= squared[i][k] + squared[k][last] <= squared[i][last] * (1.0 + kRightAngle);
    }
    if (may_hold_all && consider(set, centre_of_pair(set.vector[i], set.vector[last]), {i, last, last}, 2, best)) {
      return true;
    }
  }
  return false;
}

/// Considers the caps through the last vector and two others. Those of obtuse triangles are never the smallest.
void consider_triples(const ActiveSet& set, const SquaredDistances& squared, Candidate& best) {
  const std::size_t last = set.n - 1;
  const auto& v = set.vector;
  for (std::size_t i = 0; i < last; ++i) {
    for (std::size_t j = i + 1; j < last; ++j) {
      const double ij = squared[i][j], jk = squared[j][last], ki = squared[i][last];
      const double longest = std::max({ij, jk, ki});
      if (2.0 * longest > (ij + jk + ki) * (1.0 + kRightAngle)) continue;
      // The base between the two shortest edges makes the cross product sharpest.
      const Vec3 centre = longest == ij   ? centre_through(v[i], v[j], v[last])
                          : longest == jk ? centre_through(v[j], v[last], v[i])
                                          : centre_through(v[last], v[i], v[j]);
      if (consider(set, centre, {i, j, last}, 3, best)) return;
    }
  }
}

/// Smallest cap of an active set whose last vector lies outside the smallest cap of the others: it is on the rim.
Candidate cap_through_last(const ActiveSet& set) {
  SquaredDistances squared{};
  for (std::size_t i = 0; i < set.n; ++i) {
    for (std::size_t j = 0; j < i; ++j) squared[i][j] = squared[j][i] = squared_distance(set.vector[i], set.vector[j]);
  }
  Candidate best;
  // Pairs first, so that they win ties: a triple through the same rim has a noisier centre.
  if (!consider_pairs(set, squared, best)) consider_triples(set, squared, best);
  return best;
}

struct Farthest {
  std::size_t index = 0;
  double squared_chord = -1;
};

Farthest farthest_from(const Vec3& centre, std::span<const Vec3> units) {
  Farthest found;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const double squared = squared_distance(units[i], centre);
    if (squared > found.squared_chord) found = {i, squared};
  }
  return found;
}

}  // namespace

Cap smallest_cap(std::span<const Vec3> units) {
  ActiveSet set;
  // The vector farthest from any other is on the rim, or near it.
  const std::size_t first = farthest_from(units[0], units).index;
  set.add(units[first], first);
  Cap cap{units[first], std::numeric_limits<double>::infinity(), set.index, 1};
  double lower_bound = 0;  // squared chord of the active set's own smallest cap
  bool has_grown = true;
  for (Vec3 centre = units[first];;) {
    const Farthest far = farthest_from(centre, units);
    const bool is_better = far.squared_chord < cap.squared_chord;
    if (is_better) cap = {centre, far.squared_chord, set.index, set.n};
    // In exact arithmetic the bound grows with each vector. Where rounding hides that (two nearly opposite vectors
    // hardly hold the centre between them), it goes on as long as the cap gets smaller.
    if (!is_outside(far.squared_chord, lower_bound) || (!is_better && !has_grown)) return cap;
    set.add(units[far.index], far.index);
    const Candidate next = cap_through_last(set);
    // Beyond a hemisphere the smallest cap is none of those through pairs and triples.
    if (!(next.squared_chord < kHemisphere)) return {{}, kHemisphere, set.index, set.n};
    has_grown = next.squared_chord > lower_bound;
    lower_bound = std::max(lower_bound, next.squared_chord);
    centre = next.centre;
    const ActiveSet before = set;
    set.n = 0;
    for (std::size_t k = 0; k < next.n; ++k) set.add(before.vector[next.member[k]], before.index[next.member[k]]);
  }
}

}  // namespace nearwall::surface

#include "surface/normals_existence.h"

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include <CGAL/Exact_rational.h>

namespace nearwall::surface {

namespace {

using Rational = CGAL::Exact_rational;

struct RationalVec {
  Rational x, y, z;
};

RationalVec operator+(const RationalVec& a, const RationalVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
RationalVec operator-(const RationalVec& a) { return {-a.x, -a.y, -a.z}; }
RationalVec operator*(const RationalVec& a, const Rational& s) { return {a.x * s, a.y * s, a.z * s}; }
Rational dot(const RationalVec& a, const RationalVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
RationalVec cross(const RationalVec& a, const RationalVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Rational largest_component(const RationalVec& a) { return std::max({CGAL::abs(a.x), CGAL::abs(a.y), CGAL::abs(a.z)}); }
int sign(const Rational& a) { return CGAL::sign(a); }

/// Open arc of directions in the plane square to `axis`, counterclockwise about it from `begin` to `end`, at most half
/// a turn.
struct Arc {
  RationalVec axis, begin, end;
  bool is_half_turn = true;

  RationalVec middle() const {
    if (is_half_turn) return cross(axis, begin);
    const Rational begin_size = largest_component(begin), end_size = largest_component(end);
    return begin * (Rational(1) / begin_size) + end * (Rational(1) / end_size);
  }
};

/// Cuts the arc down to the directions that `normal` sees. \returns whether any is left
bool cut(Arc& arc, const RationalVec& normal) {
  const int at_begin = sign(dot(normal, arc.begin)), at_end = sign(dot(normal, arc.end));
  const RationalVec enter = cross(normal, arc.axis);
  if (at_begin == 0 && at_end == 0) {
    // The normal's own half turn has the same ends (or the normal is opposite to the axis, and `enter` is zero).
    return sign(dot(arc.begin, enter)) > 0;
  }
  if (at_begin >= 0 && at_end >= 0) return true;
  if (at_begin <= 0 && at_end <= 0) return false;
  (at_begin < 0 ? arc.begin : arc.end) = at_begin < 0 ? enter : -enter;
  arc.is_half_turn = false;
  return true;
}

/// Directions square to `axis` that all of `normals` see.
std::optional<Arc> seeing_arc(const RationalVec& axis, std::span<const RationalVec> normals) {
  const RationalVec enter = cross(normals[0], axis);
  if (sign(largest_component(enter)) == 0) return std::nullopt;
  Arc arc{axis, enter, -enter};
  for (const RationalVec& normal : normals.subspan(1)) {
    if (!cut(arc, normal)) return std::nullopt;
  }
  return arc;
}

/// A direction near `direction`, which all of `normals` see and which is square to `axis`, that sees `axis`, too.
RationalVec lean_towards(const RationalVec& axis, const RationalVec& direction, std::span<const RationalVec> normals) {
  Rational step = largest_component(direction) / largest_component(axis);
  for (const RationalVec& normal : normals) {
    const Rational loss = -dot(normal, axis);
    if (sign(loss) > 0) step = std::min<Rational>(step, dot(normal, direction) / (2 * loss));
  }
  return direction + axis * step;
}

RationalVec exact(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

void shuffle(std::vector<RationalVec>& normals) {
  std::minstd_rand random;  // always the same seed: the same input gives the same result
  for (std::size_t i = normals.size(); i > 1; --i) std::swap(normals[i - 1], normals[random() % i]);
}

/// \param normals  in random order, at least one
std::optional<RationalVec> seeing_direction(std::span<const RationalVec> normals) {
  // One normal after the other. `direction` sees all so far; if it does not see the next one, then a direction that
  // does exists if and only if some direction in the next one's plane sees all so far.
  RationalVec direction = normals[0];
  for (std::size_t k = 1; k < normals.size(); ++k) {
    if (sign(dot(normals[k], direction)) > 0) continue;
    const std::span<const RationalVec> before = normals.first(k);
    const std::optional<Arc> arc = seeing_arc(normals[k], before);
    if (!arc) return std::nullopt;
    direction = lean_towards(normals[k], arc->middle(), before);
  }
  return direction;
}

}  // namespace

std::optional<Vec3> find_seeing_direction(std::span<const Vec3> normals) {
  std::vector<RationalVec> exact_normals;
  for (const Vec3& normal : normals) exact_normals.push_back(exact(normal));
  shuffle(exact_normals);
  const std::optional<RationalVec> direction = seeing_direction(exact_normals);
  if (!direction) return std::nullopt;
  const Rational scale = Rational(1) / largest_component(*direction);
  return normalized({CGAL::to_double(direction->x * scale), CGAL::to_double(direction->y * scale),
                     CGAL::to_double(direction->z * scale)});
}

bool some_direction_sees(const Vec3& apex, std::span<const Vec3> ring) {
  std::vector<RationalVec> normals;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec3& next = ring[k + 1 == ring.size() ? 0 : k + 1];
    const RationalVec normal = cross(exact(ring[k]) + -exact(apex), exact(next) + -exact(apex));
    if (sign(largest_component(normal)) != 0) normals.push_back(normal);
  }
  if (normals.empty()) return false;
  shuffle(normals);
  return seeing_direction(normals).has_value();
}

}  // namespace nearwall::surface

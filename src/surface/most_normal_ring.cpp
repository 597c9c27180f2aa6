#include "surface/most_normal_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "surface/normals_cap.h"
#include "surface/normals_existence.h"
#include "surface/normals_visible.h"

namespace nearwall::surface {

namespace {

/// Sine of an arc below which its ends can't be told apart: some roundings of unit vectors.
constexpr double kNoArc = 0x1p-50;

/// Sine of an arc below which rounded unit vectors do not tell its normal to 1e-13.
constexpr double kThin = 0x1p-9;

/// Sine by which a vertex may stick out into the solid and still count as reflex: a site too many does no harm.
constexpr double kFlat = 1e-12;

/// In cones thinner than this [rad] rounded normals may see what the faces hide.
constexpr double kDoubtful = 0x1p-40;

/// A computed sine above another by this much belongs to a larger angle.
constexpr double kSineRounding = 0x1p-50;

/// Vector to a neighbour, times some power of two: two doubles a component, `low` what `high` lacks.
struct Edge {
  Vec3 high, low;
};

/// a - b without rounding, if it does not overflow.
Edge difference(const Vec3& a, const Vec3& b) {
  Edge d{a - b, {}};
  for (int axis = 0; axis < 3; ++axis) {
    const double lost = d.high[axis] - a[axis];
    d.low[axis] = (a[axis] - (d.high[axis] - lost)) - (b[axis] + lost);
  }
  return d;
}

Edge edge_to(const Vec3& neighbour, const Vec3& apex) {
  if (!is_finite(neighbour)) throw InputError("most_normal_normal: expected finite points, found one that is not");
  const Edge edge = difference(neighbour, apex);
  return is_finite(edge.high) ? edge : difference(neighbour * 0.5, apex * 0.5);
}

/// The edge with its largest component in [1, 2), so that no product leaves the range of doubles.
Edge scaled(const Edge& edge) {
  const int exponent = std::ilogb(max_norm(edge.high));
  const auto scale = [exponent](const Vec3& v) {
    return Vec3(std::ldexp(v.x(), -exponent), std::ldexp(v.y(), -exponent), std::ldexp(v.z(), -exponent));
  };
  return {scale(edge.high), scale(edge.low)};
}

/// p q' - p' q of twice as many digits, for two components of two edges.
double determinant(const Edge& a, const Edge& b, int i, int j) {
  const double p = a.high[i] * b.high[j], q = a.high[j] * b.high[i];
  const double size = p - q, lost = size - p;
  const double rounding = (p - (size - lost)) - (q + lost);
  const double rounding_of_p = std::fma(a.high[i], b.high[j], -p), rounding_of_q = std::fma(a.high[j], b.high[i], -q);
  const double low = (a.high[i] * b.low[j] - a.high[j] * b.low[i]) + (a.low[i] * b.high[j] - a.low[j] * b.high[i]);
  return size + (rounding + ((rounding_of_p - rounding_of_q) + low));
}

/// Normal of a face whose edges are nearly parallel; zero if they are.
Vec3 normal_of_thin(const Edge& edge, const Edge& next) {
  const Edge a = scaled(edge), b = scaled(next);
  return unit_vector({determinant(a, b, 1, 2), determinant(a, b, 2, 0), determinant(a, b, 0, 1)});
}

}  // namespace

Level::Level(const Distance& d)
    : sine(d.sine),
      cosine(d.cosine),
      is_large(d.sine > d.cosine),
      sine_limit(is_large ? d.sine + kSineRounding : d.sine),
      squared_cosine(d.cosine * d.cosine),
      squared_chord(2.0 * d.sine * d.sine / (1.0 + d.cosine)) {}

bool Ring::prepare(const Vec3& apex, std::span<const Vec3> neighbours) {
  if (!is_finite(apex)) throw InputError("most_normal_normal: expected a finite apex, found one that is not");
  Scratch<Vec3> starts(neighbours.size());
  Scratch<Edge> edges(neighbours.size());
  Scratch<Vec3> points(neighbours.size());
  const auto is_same = [](const Vec3& p, const Vec3& q) {
    return dot(p, q) > 0 && squared_norm(cross(p, q)) <= kNoArc * kNoArc;
  };
  bool is_open = false;
  for (const Vec3& neighbour : neighbours) {
    const Edge edge = edge_to(neighbour, apex);
    const Vec3 start = unit_vector(edge.high);
    is_open |= start == Vec3{};
    if (starts.all().empty() || !is_same(starts.all().back(), start)) {
      starts.add(start), edges.add(edge), points.add(neighbour);
    }
  }
  std::span<const Vec3> p = starts.all();
  while (p.size() > 1 && is_same(p.back(), p.front())) p = p.first(p.size() - 1);
  if (is_open || p.size() < 3) return false;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const std::size_t next = k + 1 == p.size() ? 0 : k + 1;
    const Vec3 &start = p[k], &end = p[next];
    // Twice start x end, without its cancellation where the two are nearly the same or opposite.
    const Vec3 face = cross(start - end, start + end);
    const Vec3 normal =
        squared_norm(face) > 4 * kThin * kThin ? unit_vector(face) : normal_of_thin(edges.all()[k], edges.all()[next]);
    if (normal == Vec3{}) return false;
    arcs_.add({start, normal, cross(normal, start), cross(normal, end)});
  }
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (dot(arcs_.all()[before(k)].normal, arcs_.all()[after(k)].start) <= kFlat) reflex_.add(k);
  }
  return find_most_visible(apex, points.all().first(p.size())) && goes_round_once();
}

bool Ring::find_most_visible(const Vec3& apex, std::span<const Vec3> points) {
  Scratch<Vec3> normals(arcs().size());
  for (const Arc& arc : arcs()) normals.add(arc.normal);
  const auto visible = most_visible_of(normals.all(), normals.all());
  if (!visible) return false;
  most_visible_ = visible->direction;
  // The normals are rounded: a cone this thin may be theirs alone.
  return visible->max_angle < geometry::kPi / 2 - kDoubtful || some_direction_sees(apex, points);
}

bool Ring::goes_round_once() const {
  // Seen from the most visible normal each arc turns left by less than half a turn: it passes any given azimuth once.
  // At that of the first vertex its neighbours' sides are known, and rounding may hide them.
  const Vec3 left = cross(most_visible_, arcs()[0].start);
  int n_turns = 1;
  bool was_right = false;
  for (std::size_t k = 2; k < arcs().size(); ++k) {
    const bool is_right = k + 1 == arcs().size() || dot(left, arcs()[k].start) < 0;
    n_turns += was_right && !is_right;
    was_right = is_right;
  }
  return n_turns == 1;
}

Place Ring::place(const Vec3& x) const {
  double squared_chord = std::numeric_limits<double>::infinity();
  std::size_t vertex = 0;
  for (std::size_t k = 0; k < arcs().size(); ++k) {
    const double squared = squared_norm(x - arcs()[k].start);
    if (squared < squared_chord) squared_chord = squared, vertex = k;
  }
  const Arc& nearest = arcs()[vertex];
  // The way to the nearest point of the ring crosses no arc, so the side is that from which it is met there.
  Place place{{norm(cross(x, nearest.start)), dot(x, nearest.start)},
              dot(x, nearest.normal + arcs()[before(vertex)].normal) > 0,
              arcs().size() + vertex};
  for (std::size_t k = 0; k < arcs().size(); ++k) {
    const Arc& arc = arcs()[k];
    const double ahead = dot(x, arc.ahead);
    if (!(ahead > 0 && dot(x, arc.beyond) < 0)) continue;
    const double height = dot(x, arc.normal), across = dot(x, arc.start);
    const Distance distance{std::abs(height), std::sqrt(across * across + ahead * ahead)};
    if (is_less(distance, place.distance)) place = {distance, height > 0, k};
  }
  return place;
}

bool Ring::is_nearer(const Arc& arc, const Vec3& x, const Level& level) const {
  const double across = dot(x, arc.start);
  if (level.is_large ? across > level.cosine : squared_norm(x - arc.start) < level.squared_chord) return true;
  if (std::abs(dot(x, arc.normal)) >= level.sine_limit) return false;
  const double ahead = dot(x, arc.ahead);
  if (ahead < 0 || dot(x, arc.beyond) > 0) return false;
  return !level.is_large || across * across + ahead * ahead > level.squared_cosine;
}

bool Ring::keeps_clear(const Vec3& x, const Level& level, std::span<std::size_t> order) const {
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (is_nearer(arcs()[order[k]], x, level)) return std::swap(order[k], order[k / 2]), false;
  }
  return true;
}

bool Ring::is_seen(const Vec3& x) const {
  return std::all_of(arcs().begin(), arcs().end(),
                     [&](const Arc& arc) { return dot(x, arc.normal) > kSurelyPositive; });
}

}  // namespace nearwall::surface

#include "fans.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nearwall/geometry/angles.h"
#include "nearwall/predicates/orientation.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;

/// A turn of so much more than a multiple of the largest one needs no further line: the rounding of angles.
constexpr double kTurnSlack = 1e-9;

/// Angle between two groups up to which the great arc between them is followed [rad]: 150 degrees.
constexpr double kWidestStraight = geometry::to_radians(150);

VertexId left_copy(const CutWall& cut, HalfedgeId h) { return cut.copy_at(h); }
VertexId right_copy(const Wall& wall, const CutWall& cut, HalfedgeId h) {
  return cut.copy_at(Topology::next(wall.topology.twin(h)));
}

/// Half way between the two faces of a convex edge, away from both. The sum of their normals alone loses its digits at
/// a knife edge, where the directions that leave each face in its plane, square to the edge, agree instead.
Vec3 outward(const Wall& wall, HalfedgeId h) {
  const HalfedgeId twin = wall.topology.twin(h);
  const Vec3 along =
      normalized(wall.surface.points[wall.topology.target(h)] - wall.surface.points[wall.topology.origin(h)]);
  const Vec3& left = wall.features.face_normal[Topology::face(h)];
  const Vec3& right = wall.features.face_normal[Topology::face(twin)];
  return normalized(left + right + cross(along, left) + cross(right, along));
}

/// A direction of a line of v: in the planes on which v lies.
Vec3 held(const Wall& wall, VertexId v, const Vec3& d) {
  return wall.has_planes() && wall.planes->is_on_plane(v) ? wall.planes->direction_within(v, d) : d;
}

/// Where the middle of the fan points: away from the edge, or from both where it runs through.
Vec3 middle(const Wall& wall, HalfedgeId h, HalfedgeId other) {
  const Vec3 own = outward(wall, h);
  return held(wall, wall.topology.origin(h), other.is_valid() ? normalized(own + outward(wall, other)) : own);
}

/// The arcs along which a fan turns from one group to the other: straight, or over the middle between the two faces of
/// the edge where the groups look in nearly opposite directions and the straight arc might run any way round.
struct Arcs {
  Vec3 from, over, to;
  bool is_bent = false;

  Arcs(const Vec3& a, const Vec3& middle, const Vec3& b)
      : from(a), over(middle), to(b), is_bent(geometry::angle_between(a, b) > kWidestStraight) {}

  double turn() const {
    if (!is_bent) return geometry::angle_between(from, to);
    return geometry::angle_between(from, over) + geometry::angle_between(over, to);
  }

  /// n unit vectors at equal angles.
  std::vector<Vec3> spread(std::size_t n) const {
    const double first = geometry::angle_between(from, over), all = turn();
    std::vector<Vec3> directions{from};
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double share = double(i) / double(n - 1), at = all * share;
      Vec3 d = is_bent && at < first ? geometry::slerp(from, over, at / first) : Vec3();
      if (is_bent && !(at < first)) d = geometry::slerp(over, to, (at - first) / (all - first));
      if (!is_bent) d = geometry::slerp(from, to, share);
      directions.push_back(normalized(d));
    }
    directions.push_back(to);
    return directions;
  }
};

Arcs arcs_of(const Fans& fans, const Wall& wall, const CutWall& cut, const IdVector<VertexId, Vec3>& normal,
             HalfedgeId h) {
  return {normal[left_copy(cut, h)], middle(wall, h, fans.onwards(h)), normal[right_copy(wall, cut, h)]};
}

/// Sets of fans that have one number of lines.
class Chains {
 public:
  explicit Chains(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

Fans::Fans(const Wall& wall, const CutWall& cut, const IdVector<VertexId, Vec3>& normal, double max_turn)
    : wall_(wall), cut_(cut), normal_(normal) {
  if (!cut.has_cuts()) return;
  number_.resize(3 * wall.surface.faces.size(), kNone);
  for (const HalfedgeId h : number_.ids()) {
    if (!cut.is_cut(h) || cut.n_copies(wall.topology.origin(h)) < 2) continue;
    number_[h] = static_cast<std::uint32_t>(fans_.size());
    fans_.push_back({h, {}});
  }
  count_lines(max_turn);
  for (std::size_t i = 0; i < fans_.size(); ++i) lay(fans_[i], n_lines_[i]);
  std::sort(twisted_.begin(), twisted_.end());
  twisted_.erase(std::unique(twisted_.begin(), twisted_.end()), twisted_.end());
}

HalfedgeId Fans::onwards(HalfedgeId h) const {
  const VertexId v = wall_.topology.origin(h);
  if (cut_.n_copies(v) != 2) return {};
  for (const HalfedgeId out : wall_.topology.fan(v)) {
    if (out != h && cut_.is_cut(out)) return out;
  }
  return {};
}

void Fans::count_lines(double max_turn) {
  Chains chains(fans_.size());
  std::vector<double> turn(fans_.size());
  for (std::size_t i = 0; i < fans_.size(); ++i) {
    const HalfedgeId h = fans_[i].edge;
    turn[i] = arcs_of(*this, wall_, cut_, normal_, h).turn();
    if (const Fan* there = at(wall_.topology.twin(h))) chains.join(i, number_[there->edge]);
    const HalfedgeId other = onwards(h);
    if (other.is_valid()) chains.join(i, number_[other]);
  }
  std::vector<double> largest(fans_.size(), 0);
  for (std::size_t i = 0; i < fans_.size(); ++i) {
    double& most = largest[chains.root(i)];
    most = std::max(most, turn[i]);
  }
  for (std::size_t i = 0; i < fans_.size(); ++i) {
    const double parts = std::ceil(largest[chains.root(i)] / max_turn - kTurnSlack);
    n_lines_.push_back(static_cast<std::size_t>(std::max(1.0, parts)) + 1);
  }
}

void Fans::lay(Fan& fan, std::size_t n_lines) {
  const HalfedgeId other = onwards(fan.edge);
  if (other.is_valid() && other < fan.edge) {
    // One set of lines serves both edges: what is left of one is right of the other.
    const auto& first = fans_[number_[other]].direction;
    fan.direction.assign(first.rbegin(), first.rend());
  } else {
    fan.direction = arcs_of(*this, wall_, cut_, normal_, fan.edge).spread(n_lines);
    for (Vec3& d : fan.direction) d = held(wall_, wall_.topology.origin(fan.edge), d);
  }
  if (!turns_along_edges(fan)) twisted_.push_back(wall_.topology.origin(fan.edge));
}

/// Whether the first layer over the edge can be positive: each two neighbouring lines turn about the edge in its sense.
bool Fans::turns_along_edges(const Fan& fan) const {
  const Vec3 along =
      wall_.surface.points[wall_.topology.target(fan.edge)] - wall_.surface.points[wall_.topology.origin(fan.edge)];
  for (std::size_t i = 0; i + 1 < fan.direction.size(); ++i) {
    if (predicates::sign_of_determinant(fan.direction[i], fan.direction[i + 1], along) != predicates::Sign::Positive) {
      return false;
    }
  }
  return true;
}

}  // namespace nearwall::layers

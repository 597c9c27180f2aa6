#include "studies/interpolants.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nearwall::studies {

namespace {

Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }
double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
double length(const Point2& a) { return std::hypot(a.x, a.y); }

Point2 combined(const std::array<double, 3>& weight, const std::array<Point2, 3>& corner) {
  return {weight[0] * corner[0].x + weight[1] * corner[1].x + weight[2] * corner[2].x,
          weight[0] * corner[0].y + weight[1] * corner[1].y + weight[2] * corner[2].y};
}

using Barycentric = std::array<Jet, 3>;

/// Barycentric coordinates of p with their derivatives.
Barycentric barycentric(const std::array<Point2, 3>& t, const Point2& p) {
  const double area = cross(t[1] - t[0], t[2] - t[0]);
  Barycentric out;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 a = t[(k + 1) % 3], b = t[(k + 2) % 3];
    out[k] = {cross(a - p, b - p) / area, (a.y - b.y) / area, (b.x - a.x) / area};
  }
  return out;
}

double smallest(const Barycentric& b) { return std::min({b[0].value, b[1].value, b[2].value}); }

/// A cubic in Bernstein-Bezier form on the triangle (A, B, C).
struct Cubic {
  double a, b, c;                 ///< at the corners
  double ab, ba, bc, cb, ca, ac;  ///< on the sides; ab is the one nearer to A
  double abc;

  Jet at(const Barycentric& t) const {
    const auto& [u, v, w] = t;
    const Jet corners = a * (u * u * u) + b * (v * v * v) + c * (w * w * w);
    const Jet along_ab = u * v * (ab * u + ba * v), along_bc = v * w * (bc * v + cb * w);
    const Jet along_ca = w * u * (ca * w + ac * u);
    return corners + 3.0 * (along_ab + along_bc + along_ca) + (6.0 * abc) * (u * v * w);
  }
};

/// A quadratic in the same form.
struct Quadratic {
  double a, b, c, ab, bc, ca;

  Jet at(const Barycentric& t) const {
    const auto& [u, v, w] = t;
    return a * (u * u) + b * (v * v) + c * (w * w) + 2.0 * (ab * (u * v) + bc * (v * w) + ca * (w * u));
  }
};

/// The Bezier coefficients of the Clough-Tocher element; indices are corners, k + 1 and k + 2 modulo 3.
class CloughTocherNet {
 public:
  explicit CloughTocherNet(const HermiteTriangle& t) : t_(t), centre_(combined({kThird, kThird, kThird}, t.corner)) {
    for (std::size_t k = 0; k < 3; ++k) inner_[k] = towards(k, centre_);
    for (std::size_t k = 0; k < 3; ++k) middle_[k] = middle_of_side(k);
    for (std::size_t k = 0; k < 3; ++k) near_centre_[k] = kThird * (inner_[k] + middle_[k] + middle_[(k + 2) % 3]);
    at_centre_ = kThird * (near_centre_[0] + near_centre_[1] + near_centre_[2]);
  }

  const Point2& centre() const { return centre_; }

  /// The cubic on the third (corner k, corner k + 1, centre).
  Cubic third(std::size_t k) const {
    const std::size_t l = (k + 1) % 3;
    return {.a = t_.value[k],
            .b = t_.value[l],
            .c = at_centre_,
            .ab = towards(k, t_.corner[l]),
            .ba = towards(l, t_.corner[k]),
            .bc = inner_[l],
            .cb = near_centre_[l],
            .ca = near_centre_[k],
            .ac = inner_[k],
            .abc = middle_[k]};
  }

 private:
  static constexpr double kThird = 1.0 / 3.0;

  /// The coefficient next to corner k on the way to `p`.
  double towards(std::size_t k, const Point2& p) const {
    return t_.value[k] + kThird * dot(t_.gradient[k], p - t_.corner[k]);
  }

  /// The coefficient in the middle of the third at side k that makes the derivative across the side linear.
  double middle_of_side(std::size_t k) const {
    const std::size_t l = (k + 1) % 3;
    const Point2 side = t_.corner[l] - t_.corner[k];
    const Point2 across = {-side.y, side.x};
    const auto direction = barycentric({t_.corner[k], t_.corner[l], centre_}, t_.corner[k]);
    // The derivative across is a quadratic with the coefficients q0, q1, q2 along the side, and
    // q1 = 3 (a ab + b ba + c abc), where (a, b, c) are the derivatives of the barycentric coordinates.
    const auto derivative = [&](std::size_t i) { return dot({direction[i].dx, direction[i].dy}, across); };
    const double q1 = 0.5 * (dot(t_.gradient[k], across) + dot(t_.gradient[l], across));
    const double along = derivative(0) * towards(k, t_.corner[l]) + derivative(1) * towards(l, t_.corner[k]);
    return (kThird * q1 - along) / derivative(2);
  }

  const HermiteTriangle& t_;
  Point2 centre_;
  std::array<double, 3> inner_{};        ///< next to a corner, towards the centre
  std::array<double, 3> middle_{};       ///< in the middle of a third
  std::array<double, 3> near_centre_{};  ///< next to the centre, towards a corner
  double at_centre_ = 0;
};

Point2 incentre(const std::array<Point2, 3>& t) {
  const std::array<double, 3> side = {length(t[2] - t[1]), length(t[0] - t[2]), length(t[1] - t[0])};
  const double perimeter = side[0] + side[1] + side[2];
  return combined({side[0] / perimeter, side[1] / perimeter, side[2] / perimeter}, t);
}

std::array<Point2, 3> corners_of(std::span<const Point2> points, const Triangle2& t) {
  return {points[t[0]], points[t[1]], points[t[2]]};
}

}  // namespace

Jet clough_tocher(const HermiteTriangle& triangle, const Point2& p) {
  const auto whole = barycentric(triangle.corner, p);
  // The third at side k lies opposite corner k + 2, whose coordinate is the smallest there.
  const auto value = [&](std::size_t i) { return whole[i].value; };
  std::size_t opposite = value(0) < value(1) ? 0 : 1;
  if (value(2) < value(opposite)) opposite = 2;
  const std::size_t k = (opposite + 1) % 3;
  const CloughTocherNet net(triangle);
  return net.third(k).at(barycentric({triangle.corner[k], triangle.corner[(k + 1) % 3], net.centre()}, p));
}

std::vector<PowellSabinSplit> powell_sabin_splits(std::span<const Point2> points,
                                                  std::span<const Triangle2> triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Point2> centre_left_of;
  std::vector<PowellSabinSplit> splits;
  for (const Triangle2& t : triangles) {
    splits.push_back({incentre(corners_of(points, t)), {0.5, 0.5, 0.5}});
    for (std::size_t k = 0; k < 3; ++k) centre_left_of[{t[k], t[(k + 1) % 3]}] = splits.back().centre;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[i][k], to = triangles[i][(k + 1) % 3];
      const auto other = centre_left_of.find({to, from});
      if (other == centre_left_of.end()) continue;
      // Signed areas over the line between the centres: the side is cut in their ratio.
      const Point2 line = other->second - splits[i].centre;
      const double before = cross(line, points[from] - splits[i].centre);
      const double after = cross(line, points[to] - splits[i].centre);
      splits[i].weight[k] = after / (after - before);
    }
  }
  return splits;
}

Jet powell_sabin(const HermiteTriangle& t, const PowellSabinSplit& split, const Point2& p) {
  const auto third = [&](std::size_t k) { return barycentric({t.corner[k], t.corner[(k + 1) % 3], split.centre}, p); };
  std::size_t k = 0;
  for (const std::size_t other : {1, 2}) {
    if (smallest(third(other)) > smallest(third(k))) k = other;
  }
  const std::size_t l = (k + 1) % 3;
  const double weight = split.weight[k];
  const Point2 cut = combined({weight, 1.0 - weight, 0}, {t.corner[k], t.corner[l], Point2()});

  const auto towards = [&](std::size_t i, const Point2& q) {
    return t.value[i] + 0.5 * dot(t.gradient[i], q - t.corner[i]);
  };
  const auto at_centre = barycentric(t.corner, split.centre);
  double centre_value = 0;
  for (std::size_t i = 0; i < 3; ++i) centre_value += at_centre[i].value * towards(i, split.centre);
  const double cut_value = weight * towards(k, cut) + (1.0 - weight) * towards(l, cut);
  const double between = weight * towards(k, split.centre) + (1.0 - weight) * towards(l, split.centre);

  // The cut is at the ratio of the two coordinates; p is on the side of the corner that has more than its share.
  const auto coordinate = third(k);
  const bool is_nearer_to_k = coordinate[0].value * (1.0 - weight) >= coordinate[1].value * weight;
  const std::size_t corner = is_nearer_to_k ? k : l;
  const Quadratic part = {.a = t.value[corner],
                          .b = cut_value,
                          .c = centre_value,
                          .ab = towards(corner, cut),
                          .bc = between,
                          .ca = towards(corner, split.centre)};
  return part.at(barycentric({t.corner[corner], cut, split.centre}, p));
}

}  // namespace nearwall::studies

#include "corner_polygon.h"

#include <limits>

#include "nearwall/predicates/orientation.h"
#include "nearwall/surface/normals.h"

namespace nearwall::layers {

namespace {

/// Longer loops are not filled: the search is cubic, and no real corner has so many ridges.
constexpr std::size_t kLongestLoop = 256;

/// Determinants and lengths that differ by no more than this count as equal: rounding must not choose between fillings
/// that symmetry makes alike.
constexpr double kAlike = 1e-9;

/// Determinant of three directions; minus infinity unless it is positive, exactly.
double quality(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (predicates::sign_of_determinant(a, b, c) != predicates::Sign::Positive) {
    return -std::numeric_limits<double>::infinity();
  }
  return dot(cross(a, b), c);
}

/// Whether the great arcs (a, b) and (c, d), each shorter than half a circle, cross. Exact; touching is no crossing.
bool arcs_cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto side = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return static_cast<int>(predicates::sign_of_determinant(p, q, r));
  };
  const int c_of_ab = side(a, b, c), d_of_ab = side(a, b, d), a_of_cd = side(c, d, a), b_of_cd = side(c, d, b);
  // Circles cross at two opposite points; the arcs hold the same one of them if they pass each other in these senses.
  return c_of_ab * d_of_ab < 0 && a_of_cd * b_of_cd < 0 && c_of_ab * b_of_cd > 0;
}

/// Whether no two sides of the loop cross.
bool is_simple(std::span<const Vec3> loop) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i + 2 < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (arcs_cross(loop[i], loop[i + 1], loop[j], loop[(j + 1) % n])) return false;
    }
  }
  return true;
}

/// How well a part of the loop is filled: by its smallest determinant, then by the length of its diagonals.
struct Value {
  double worst = -std::numeric_limits<double>::infinity();
  double diagonals = 0;

  bool is_better_than(const Value& other) const {
    if (worst > other.worst + kAlike) return true;
    return worst > other.worst - kAlike && diagonals < other.diagonals - kAlike;
  }
};

/// The best triangulation of a loop without further lines, by the parts between two of its lines.
class Search {
 public:
  explicit Search(std::span<const Vec3> loop) : loop_(loop), best_(loop.size() * loop.size()), apex_(best_.size(), 0) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i + 1 < n; ++i) best_[i * n + i + 1].worst = std::numeric_limits<double>::infinity();
    for (std::size_t span = 2; span < n; ++span) {
      for (std::size_t i = 0; i + span < n; ++i) find_apex(i, i + span);
    }
  }

  double worst() const { return best_[loop_.size() - 1].worst; }

  std::vector<std::array<std::uint32_t, 3>> triangles() const {
    std::vector<std::array<std::uint32_t, 3>> all;
    collect(0, loop_.size() - 1, all);
    return all;
  }

 private:
  void find_apex(std::size_t i, std::size_t j) {
    const std::size_t n = loop_.size();
    Value& best = best_[i * n + j];
    const double side = j - i == n - 1 ? 0.0 : distance(loop_[i], loop_[j]);
    for (std::size_t k = i + 1; k < j; ++k) {
      const Value &left = best_[i * n + k], &right = best_[k * n + j];
      Value value{std::min(left.worst, right.worst), left.diagonals + right.diagonals + side};
      if (!value.is_better_than(best)) continue;
      value.worst = std::min(value.worst, quality(loop_[i], loop_[k], loop_[j]));
      if (value.is_better_than(best)) best = value, apex_[i * n + j] = k;
    }
  }

  void collect(std::size_t i, std::size_t j, std::vector<std::array<std::uint32_t, 3>>& all) const {
    if (j < i + 2) return;
    const std::size_t k = apex_[i * loop_.size() + j];
    collect(i, k, all);
    all.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(j)});
    collect(k, j, all);
  }

  std::span<const Vec3> loop_;
  std::vector<Value> best_;        // (n, n) over the part from i to j
  std::vector<std::size_t> apex_;  // (n, n) third corner of the triangle on the side from i to j
};

/// Fills the loop from the direction that sees all of its sides best; none if nothing sees them all.
CornerFilling fill_from_centre(std::span<const Vec3> loop, double& worst) {
  CornerFilling filling;
  worst = -std::numeric_limits<double>::infinity();
  const auto n = static_cast<std::uint32_t>(loop.size());
  std::vector<Vec3> sides;
  for (std::size_t i = 0; i < n; ++i) sides.push_back(normalized(cross(loop[i], loop[(i + 1) % n])));
  const auto centre = surface::most_visible_normal(sides);
  if (!centre) return filling;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < n; ++i) {
    least = std::min(least, quality(loop[i], loop[(i + 1) % n], centre->direction));
    filling.triangles.push_back({i, (i + 1) % n, n});
  }
  if (!(least > 0)) return {};
  filling.has_centre = true;
  filling.centre = centre->direction;
  worst = least;
  return filling;
}

}  // namespace

CornerFilling fill_corner(std::span<const Vec3> loop) {
  if (loop.size() > kLongestLoop || !is_simple(loop)) return {};
  double with_centre = 0;
  CornerFilling filling = fill_from_centre(loop, with_centre);
  const Search search(loop);
  if (!(search.worst() > 0) || search.worst() < with_centre - kAlike) return filling;
  filling = {};
  filling.triangles = search.triangles();
  return filling;
}

}  // namespace nearwall::layers

#include "search/patch_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nearwall::search {

namespace {

/// Cuts of a patch along both its parameters, one within the other: what is 4^6 times as bent as it is apart from the
/// other comes out right.
constexpr int kMaxCuts = 6;
/// Pairs of pieces that are looked at.
constexpr int kMaxPairs = 1 << 16;
/// What rounding can have done to the difference of two products n · x, as a multiple of |n|₁ and of the largest
/// coordinate, both about a corner: one rounding of each coordinate, two for each cut, four for a product, and these
/// twice, 2 (1 + 2 · 6 + 4) = 34 units of roundoff; the rest pays for the bound's own roundings.
constexpr double kMargin = 64 * (std::numeric_limits<double>::epsilon() / 2);

struct Piece {
  PatchCorners corners;
  int cuts = 0;

  double size() const { return std::max(max_norm(corners[2] - corners[0]), max_norm(corners[3] - corners[1])); }
  Vec3 normal() const { return cross(corners[2] - corners[0], corners[3] - corners[1]); }
  Vec3 centre() const { return ((corners[0] + corners[2]) + (corners[1] + corners[3])) * 0.25; }
};

std::array<Piece, 4> quarters(const Piece& p) {
  const auto& [a, b, c, d] = p.corners;
  const auto middle = [](const Vec3& x, const Vec3& y) { return (x + y) * 0.5; };
  const Vec3 ab = middle(a, b), bc = middle(b, c), cd = middle(c, d), da = middle(d, a), centre = middle(ab, cd);
  const int cuts = p.cuts + 1;
  return {Piece{{a, ab, centre, da}, cuts}, Piece{{ab, b, bc, centre}, cuts}, Piece{{centre, bc, c, cd}, cuts},
          Piece{{da, centre, cd, d}, cuts}};
}

class Parting {
 public:
  explicit Parting(double reach) : reach_(reach) {}

  /// Whether a plane across one of three likely directions parts the hulls of the pieces.
  bool parts(const Piece& a, const Piece& b) const {
    return parts_along(b.centre() - a.centre(), a, b) || parts_along(a.normal(), a, b) || parts_along(b.normal(), a, b);
  }

 private:
  bool parts_along(const Vec3& direction, const Piece& a, const Piece& b) const {
    const Vec3 n = normalized(direction);
    const auto range = [&](const Piece& piece) {
      std::array<double, 4> v;
      std::transform(piece.corners.begin(), piece.corners.end(), v.begin(), [&](const Vec3& x) { return dot(n, x); });
      return std::minmax({v[0], v[1], v[2], v[3]});
    };
    const auto [low_a, high_a] = range(a);
    const auto [low_b, high_b] = range(b);
    const double margin = kMargin * reach_ * (std::abs(n.x()) + std::abs(n.y()) + std::abs(n.z()));
    return low_b - high_a > margin || low_a - high_b > margin;
  }

  double reach_;  ///< largest coordinate
};

}  // namespace

bool are_surely_apart(const PatchCorners& a, const PatchCorners& b) {
  Piece first{a, 0}, second{b, 0};
  double reach = 0;
  for (Piece* piece : {&first, &second}) {
    for (Vec3& corner : piece->corners) {
      corner -= a[0];
      reach = std::max(reach, max_norm(corner));
    }
  }
  const Parting parting(reach);
  std::vector<std::pair<Piece, Piece>> open{{first, second}};
  for (int n = 0; !open.empty(); ++n) {
    if (n == kMaxPairs) return false;
    const auto [p, q] = open.back();
    open.pop_back();
    if (parting.parts(p, q)) continue;
    const bool cuts_first = p.cuts < q.cuts || (p.cuts == q.cuts && p.size() >= q.size());
    if ((cuts_first ? p : q).cuts == kMaxCuts) return false;
    if (cuts_first) {
      for (const Piece& quarter : quarters(p)) open.emplace_back(quarter, q);
    } else {
      for (const Piece& quarter : quarters(q)) open.emplace_back(p, quarter);
    }
  }
  return true;
}

}  // namespace nearwall::search

#include "io/triangulate.h"

namespace nearwall::io {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

Vec3 doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); }

/// Sum of the areas of a fan as vectors: the mean normal, twice the area long.
Vec3 mean_normal(std::span<const Vec3> corners) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += doubled_area(corners[0], corners[i], corners[i + 1]);
  return sum;
}

void cut_quadrilateral(std::span<const Vec3> p, std::vector<Triangle>& out) {
  const Vec3 normal = mean_normal(p);
  const auto turned_right = [&](int a, int b, int c) { return dot(doubled_area(p[a], p[b], p[c]), normal) > 0; };
  const bool can_02 = turned_right(0, 1, 2) && turned_right(0, 2, 3);
  const bool can_13 = turned_right(0, 1, 3) && turned_right(1, 2, 3);
  const bool shorter_13 = squared_norm(p[3] - p[1]) < squared_norm(p[2] - p[0]);
  if (can_02 == can_13 ? shorter_13 : can_13) {
    out.push_back({0, 1, 3});
    out.push_back({1, 2, 3});
  } else {
    out.push_back({0, 1, 2});
    out.push_back({0, 2, 3});
  }
}

/// The corners not yet cut off, as a ring.
class EarClipper {
 public:
  explicit EarClipper(std::span<const Vec3> corners) : points_(corners), normal_(mean_normal(corners)) {
    for (std::uint32_t i = 0; i < corners.size(); ++i) ring_.push_back(i);
    ears_.resize(ring_.size());
    for (std::size_t i = 0; i < ring_.size(); ++i) ears_[i] = is_ear(i);
  }

  void clip_all(std::vector<Triangle>& out) {
    while (ring_.size() > 3) {
      const std::size_t ear = best_ear();
      if (ear == ring_.size()) break;
      out.push_back({corner(ear, -1), corner(ear, 0), corner(ear, 1)});
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(ear));
      ears_.erase(ears_.begin() + static_cast<std::ptrdiff_t>(ear));
      const std::size_t n = ring_.size();
      for (const std::size_t i : {(ear + n - 1) % n, ear % n}) ears_[i] = is_ear(i);
    }
    for (std::size_t i = 1; i + 1 < ring_.size(); ++i) out.push_back({ring_[0], ring_[i], ring_[i + 1]});
  }

 private:
  std::uint32_t corner(std::size_t i, int step) const {
    const std::size_t n = ring_.size();
    return ring_[(i + n + static_cast<std::size_t>(step)) % n];
  }

  /// Does c lie to the left of the side from a to b, or on it?
  bool is_left(const Vec3& a, const Vec3& b, const Vec3& c) const { return dot(doubled_area(a, b, c), normal_) >= 0; }

  bool is_ear(std::size_t i) const {
    const Vec3& a = points_[corner(i, -1)];
    const Vec3& b = points_[corner(i, 0)];
    const Vec3& c = points_[corner(i, 1)];
    if (!(dot(doubled_area(a, b, c), normal_) > 0)) return false;
    for (const std::uint32_t other : ring_) {
      const Vec3& p = points_[other];
      if (p == a || p == b || p == c) continue;
      if (is_left(a, b, p) && is_left(b, c, p) && is_left(c, a, p)) return false;
    }
    return true;
  }

  std::size_t best_ear() const {
    std::size_t best = ring_.size();
    double shortest = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (!ears_[i]) continue;
      const double length = squared_norm(points_[corner(i, 1)] - points_[corner(i, -1)]);
      if (best == ring_.size() || length < shortest) best = i, shortest = length;
    }
    return best;
  }

  std::span<const Vec3> points_;
  Vec3 normal_;
  std::vector<std::uint32_t> ring_;
  std::vector<char> ears_;
};

}  // namespace

void triangulate(std::span<const Vec3> corners, std::vector<Triangle>& out) {
  if (corners.size() == 3) {
    out.push_back({0, 1, 2});
  } else if (corners.size() == 4) {
    cut_quadrilateral(corners, out);
  } else {
    EarClipper(corners).clip_all(out);
  }
}

}  // namespace nearwall::io

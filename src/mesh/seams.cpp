#include "nearwall/mesh/seams.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nearwall::mesh {

namespace {

/// Determinant of three unit normals below which their planes have no corner.
constexpr double kLeastDeterminant = 1e-6;

/// Edges that leave a point less those that arrive at it, in one plane.
using Balance = std::map<std::uint32_t, int>;

Balance balance_of(const std::vector<std::array<std::uint32_t, 2>>& edges) {
  // Sorted lists, since nearly all points are balanced.
  std::vector<std::uint32_t> from, to, left, arrived;
  for (const auto& [a, b] : edges) from.push_back(a), to.push_back(b);
  std::sort(from.begin(), from.end());
  std::sort(to.begin(), to.end());
  std::set_difference(from.begin(), from.end(), to.begin(), to.end(), std::back_inserter(left));
  std::set_difference(to.begin(), to.end(), from.begin(), from.end(), std::back_inserter(arrived));
  Balance balance;
  for (const std::uint32_t p : left) ++balance[p];
  for (const std::uint32_t p : arrived) --balance[p];
  return balance;
}

/// A point at which chains of two planes end, and its place along the edge between them.
struct End {
  double place;
  std::uint32_t point;
  int balance;  ///< in the first plane; 0 at a corner of which it is not known
  friend bool operator<(const End& a, const End& b) {
    return std::pair(a.place, a.point) < std::pair(b.place, b.point);
  }
};

using PlanePair = std::array<PlaneIndex, 2>;

class SeamFinder {
 public:
  SeamFinder(std::span<const Vec3> points, std::span<const SidePlane> planes) : points_(points), planes_(planes) {}

  void add_ends(const PlaneEdges& edges) {
    std::vector<Balance> balance;
    for (const auto& of_plane : edges) balance.push_back(balance_of(of_plane));
    for (PlaneIndex p = 0; p < planes_.size(); ++p) {
      for (const auto& [point, own] : balance[p]) {
        bool has_partner = false;
        for (PlaneIndex q = 0; q < planes_.size(); ++q) {
          const auto other = q == p ? balance[q].end() : balance[q].find(point);
          if (other == balance[q].end() || other->second != -own) continue;
          has_partner = true;
          if (p < q) add_end({p, q}, points_[point], point, own);
        }
        if (!has_partner) result_.loose.push_back(point);
      }
    }
  }

  void add_corner(const PlaneCorner& corner) {
    const auto number = static_cast<std::uint32_t>(points_.size() + result_.corners.size());
    result_.corners.push_back(corner.point);
    for (const auto& [pair, balance] : corner.edges) add_end(pair, corner.point, number, balance);
  }

  /// Where edges between each two of three planes have one end too many.
  void add_missing_corners() {
    const auto is_odd = [&](PlaneIndex p, PlaneIndex q) {
      const auto found = ends_.find({p, q});
      return found != ends_.end() && found->second.size() % 2 == 1;
    };
    const auto n = static_cast<PlaneIndex>(planes_.size());
    for (PlaneIndex p = 0; p < n; ++p) {
      for (auto q = static_cast<PlaneIndex>(p + 1); q < n; ++q) {
        for (auto r = static_cast<PlaneIndex>(q + 1); is_odd(p, q) && r < n; ++r) {
          if (!is_odd(p, r) || !is_odd(q, r)) continue;
          const Vec3 a = planes_[p].normal, b = planes_[q].normal, c = planes_[r].normal;
          const double determinant = dot(a, cross(b, c));
          if (std::abs(determinant) < kLeastDeterminant) continue;
          Vec3 corner =
              (cross(b, c) * planes_[p].offset + cross(c, a) * planes_[q].offset + cross(a, b) * planes_[r].offset) /
              determinant;
          for (const PlaneIndex plane : {p, q, r}) {
            const int axis = planes_[plane].axis;
            if (axis >= 0) corner[axis] = planes_[plane].offset * planes_[plane].normal[axis];
          }
          add_corner({corner, {{{p, q}, 0}, {{p, r}, 0}, {{q, r}, 0}}});
        }
      }
    }
  }

  Seams join() {
    for (auto& [pair, list] : ends_) {
      std::sort(list.begin(), list.end());
      for (std::size_t i = 0; i < list.size(); i += 2) {
        if (i + 1 == list.size() || !fit(list[i], list[i + 1])) {
          for (std::size_t k = i; k < list.size(); ++k) {
            if (list[k].point < points_.size()) result_.loose.push_back(list[k].point);
          }
          break;
        }
        // What arrives at a point has to leave it.
        const bool is_forward = list[i].balance < 0 || list[i + 1].balance > 0;
        const auto [from, to] =
            is_forward ? std::pair(list[i].point, list[i + 1].point) : std::pair(list[i + 1].point, list[i].point);
        const bool is_between_corners = list[i].balance == 0 && list[i + 1].balance == 0;
        result_.seams.push_back({pair[0], pair[1], {from, to}});
        if (is_between_corners) turn_.push_back(result_.seams.size() - 1);
      }
    }
    orient_between_corners();
    std::sort(result_.loose.begin(), result_.loose.end());
    result_.loose.erase(std::unique(result_.loose.begin(), result_.loose.end()), result_.loose.end());
    return std::move(result_);
  }

 private:
  void add_end(PlanePair pair, const Vec3& at, std::uint32_t point, int balance) {
    const Vec3 along = cross(planes_[pair[0]].normal, planes_[pair[1]].normal);
    ends_[pair].push_back({dot(along, at), point, balance});
  }

  static bool fit(const End& a, const End& b) { return a.balance == -b.balance || a.balance == 0 || b.balance == 0; }

  /// Of a seam between two corners only its planes tell the direction: the domain lies before both of them, so the
  /// first one has it to its left along the cross product of the normals.
  void orient_between_corners() {
    for (const std::size_t i : turn_) {
      Seam& seam = result_.seams[i];
      const auto at = [&](std::uint32_t p) { return result_.corners[p - points_.size()]; };
      const Vec3 along = cross(planes_[seam.first].normal, planes_[seam.second].normal);
      if (dot(at(seam.ends[1]) - at(seam.ends[0]), along) > 0) std::swap(seam.ends[0], seam.ends[1]);
    }
  }

  std::span<const Vec3> points_;
  std::span<const SidePlane> planes_;
  std::map<PlanePair, std::vector<End>> ends_;
  std::vector<std::size_t> turn_;
  Seams result_;
};

}  // namespace

Seams find_seams(std::span<const Vec3> points, std::span<const SidePlane> planes, const PlaneEdges& edges,
                 std::span<const PlaneCorner> corners) {
  SeamFinder finder(points, planes);
  finder.add_ends(edges);
  for (const PlaneCorner& corner : corners) finder.add_corner(corner);
  finder.add_missing_corners();
  return finder.join();
}

}  // namespace nearwall::mesh

#include "nearwall/mesh/seams.h"

#include <algorithm>
#include <map>
#include <utility>

namespace nearwall::mesh {

namespace {

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
  int balance;  ///< in the first plane
  friend bool operator<(const End& a, const End& b) {
    return std::pair(a.place, a.point) < std::pair(b.place, b.point);
  }
};

}  // namespace

Seams find_seams(std::span<const Vec3> points, std::span<const SidePlane> planes, const PlaneEdges& edges) {
  std::vector<Balance> balance;
  for (const auto& of_plane : edges) balance.push_back(balance_of(of_plane));
  std::map<std::pair<PlaneIndex, PlaneIndex>, std::vector<End>> ends;
  Seams result;
  for (PlaneIndex p = 0; p < planes.size(); ++p) {
    for (const auto& [point, own] : balance[p]) {
      bool has_partner = false;
      for (PlaneIndex q = 0; q < planes.size(); ++q) {
        const auto other = q == p ? balance[q].end() : balance[q].find(point);
        if (other == balance[q].end() || other->second != -own) continue;
        has_partner = true;
        if (p < q) ends[{p, q}].push_back({dot(cross(planes[p].normal, planes[q].normal), points[point]), point, own});
      }
      if (!has_partner) result.loose.push_back(point);
    }
  }
  for (auto& [pair, list] : ends) {
    std::sort(list.begin(), list.end());
    for (std::size_t i = 0; i < list.size(); i += 2) {
      const bool has_next = i + 1 < list.size() && list[i].balance == -list[i + 1].balance;
      if (!has_next) {
        for (std::size_t k = i; k < list.size(); ++k) result.loose.push_back(list[k].point);
        break;
      }
      // What arrives at a point has to leave it.
      const auto [from, to] = list[i].balance < 0 ? std::pair(list[i].point, list[i + 1].point)
                                                  : std::pair(list[i + 1].point, list[i].point);
      result.seams.push_back({pair.first, pair.second, {from, to}});
    }
  }
  std::sort(result.loose.begin(), result.loose.end());
  result.loose.erase(std::unique(result.loose.begin(), result.loose.end()), result.loose.end());
  return result;
}

}  // namespace nearwall::mesh

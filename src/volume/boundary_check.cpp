#include "volume/boundary_check.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/predicates/orientation.h"
#include "nearwall/search/self_intersection.h"

namespace nearwall::volume {

namespace {

struct EdgeUse {
  std::uint32_t low = 0, high = 0;
  std::uint32_t triangle = 0;
  bool runs_up = false;  ///< the triangle goes from low to high
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// Three of each triangle, those of one edge together.
std::vector<EdgeUse> sorted_edges(const FillBoundary& boundary) {
  std::vector<EdgeUse> edges(3 * boundary.triangles.size());
  parallel_for(boundary.triangles.size(), [&](std::size_t f) {
    const auto& t = boundary.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      edges[3 * f + k] = {std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(f), a < b};
    }
  });
  tbb::parallel_sort(edges.begin(), edges.end());
  return edges;
}

/// Calls `visit(uses)` for each edge.
void for_each_edge(const std::vector<EdgeUse>& edges, const std::function<void(std::span<const EdgeUse>)>& visit) {
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high) ++end;
    visit(std::span(edges).subspan(begin, end - begin));
  }
}

std::string place(const Vec3& p) { return fmt::format("({:.9g}, {:.9g}, {:.9g})", p.x(), p.y(), p.z()); }

void sort_unique(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

void check_indices(const FillBoundary& boundary) {
  const auto& [points, triangles] = boundary;
  if (triangles.empty()) throw FillFailed("the boundary of the region to be filled has no triangle", {});
  std::vector<char> is_used(points.size(), 0);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (const std::uint32_t v : triangles[f]) {
      if (v >= points.size()) {
        throw InputError(
            fmt::format("triangle {} of the boundary to be filled uses point {} of {}", f, v, points.size()));
      }
      is_used[v] = 1;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) {
      throw InputError(fmt::format("point {} of the boundary to be filled is {}: not finite", i, place(points[i])));
    }
    if (!is_used[i]) throw InputError(fmt::format("point {} of the boundary to be filled is of no triangle", i));
  }
}

void check_closed(const FillBoundary& boundary) {
  std::vector<std::uint32_t> open;
  std::size_t n_open = 0;
  std::pair<std::uint32_t, std::uint32_t> first;
  for_each_edge(sorted_edges(boundary), [&](std::span<const EdgeUse> uses) {
    const auto n_up = std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) { return use.runs_up; });
    if (2 * static_cast<std::size_t>(n_up) == uses.size()) return;
    if (n_open++ == 0) first = {uses[0].low, uses[0].high};
    for (const EdgeUse& use : uses) open.push_back(use.triangle);
  });
  if (n_open == 0) return;
  sort_unique(open);
  throw FillFailed(
      fmt::format("the boundary of the region to be filled is open or not oriented as one at {} edges of {} triangles, "
                  "first between {} and {}",
                  n_open, open.size(), place(boundary.points[first.first]), place(boundary.points[first.second])),
      open);
}

void check_areas(const FillBoundary& boundary) {
  const auto& [points, triangles] = boundary;
  std::vector<char> has_none(triangles.size(), 0);
  parallel_for(triangles.size(), [&](std::size_t f) {
    const auto& [a, b, c] = triangles[f];
    has_none[f] = predicates::is_degenerate(points[a], points[b], points[c]);
  });
  std::vector<std::uint32_t> found;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (has_none[f]) found.push_back(static_cast<std::uint32_t>(f));
  }
  if (found.empty()) return;
  throw FillFailed(fmt::format("{} triangles of the boundary of the region to be filled have no area, first that at {}",
                               found.size(), place(points[triangles[found[0]][0]])),
                   found);
}

void check_crossings(const FillBoundary& boundary) {
  const auto pairs = search::self_intersections({boundary.points, boundary.triangles});
  if (pairs.empty()) return;
  std::vector<std::uint32_t> triangles;
  for (const auto& [i, j] : pairs) {
    triangles.push_back(i);
    triangles.push_back(j);
  }
  sort_unique(triangles);
  throw FillFailed(
      fmt::format(
          "the boundary of the region to be filled crosses or touches itself in {} pairs of triangles, first {} "
          "and {} at {}",
          pairs.size(), pairs[0].first, pairs[0].second, place(boundary.points[boundary.triangles[pairs[0].first][0]])),
      triangles);
}

}  // namespace

void check_boundary(const FillBoundary& boundary) {
  check_indices(boundary);
  check_closed(boundary);
  check_areas(boundary);
  check_crossings(boundary);
}

BoundaryParts parts_of(const FillBoundary& boundary) {
  std::vector<std::uint32_t> parent(boundary.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&parent](std::uint32_t f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  for_each_edge(sorted_edges(boundary), [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const std::uint32_t a = root(uses[0].triangle), b = root(uses[1].triangle);
    parent[std::max(a, b)] = std::min(a, b);
  });
  BoundaryParts parts;
  parts.part.resize(parent.size());
  for (std::uint32_t f = 0; f < parent.size(); ++f) {
    const std::uint32_t r = root(f);  // never behind f
    parts.part[f] = r == f ? parts.n_parts++ : parts.part[r];
  }
  return parts;
}

}  // namespace nearwall::volume

#include "nearwall/search/self_intersection.h"

#include <algorithm>
#include <mutex>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/intersection.h"
#include "search/box_tree.h"

namespace nearwall::search {

namespace {

using predicates::Triangle;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Triangles that one task looks at.
constexpr std::size_t kBlock = 1024;

/// Corners of two triangles that are one node: places in the first and in the second, and how many.
struct SharedCorners {
  std::array<int, 3> in_a{}, in_b{};
  int count = 0;
};

SharedCorners shared_corners(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  SharedCorners shared;
  for (int i = 0; i < 3; ++i) {
    if (std::find(a.begin(), a.begin() + i, a[i]) != a.begin() + i) continue;  // a repeated corner counts once
    const auto at = std::find(b.begin(), b.end(), a[i]);
    if (at == b.end()) continue;
    shared.in_a[shared.count] = i;
    shared.in_b[shared.count++] = static_cast<int>(at - b.begin());
  }
  return shared;
}

Triangle corners(const IndexedTriangles& soup, const std::array<std::uint32_t, 3>& t, int i, int j, int k) {
  return {soup.points[t[i]], soup.points[t[j]], soup.points[t[k]]};
}

bool meet(const IndexedTriangles& soup, std::uint32_t i, std::uint32_t j) {
  const auto &a = soup.triangles[i], &b = soup.triangles[j];
  const SharedCorners shared = shared_corners(a, b);
  const auto [a0, a1, a2] = shared.in_a;
  const auto [b0, b1, b2] = shared.in_b;
  switch (shared.count) {
    case 0:
      return predicates::triangles_intersect(corners(soup, a, 0, 1, 2), corners(soup, b, 0, 1, 2));
    case 1:
      return predicates::triangles_intersect_beyond_vertex(corners(soup, a, a0, (a0 + 1) % 3, (a0 + 2) % 3),
                                                           corners(soup, b, b0, (b0 + 1) % 3, (b0 + 2) % 3));
    case 2:
      return predicates::triangles_overlap_beyond_edge(corners(soup, a, a0, a1, 3 - a0 - a1),
                                                       corners(soup, b, b0, b1, 3 - b0 - b1));
    default:
      return true;
  }
}

geometry::Box box_of(const IndexedTriangles& soup, std::uint32_t i) {
  geometry::Box box;
  for (const auto v : soup.triangles[i]) box.include(soup.points[v]);
  return box;
}

/// Calls `search(k, found)` for each k in [0, n) and joins what they find.
template <class Search>
void find_pairs(std::size_t n, Pairs& pairs, Search&& search) {
  std::mutex mutex;
  parallel_blocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
    Pairs found;
    for (std::size_t k = begin; k < end; ++k) search(k, found);
    const std::lock_guard lock(mutex);
    pairs.insert(pairs.end(), found.begin(), found.end());
  });
}

}  // namespace

Pairs self_intersections(const IndexedTriangles& soup, std::span<const char> moved) {
  expect(moved.empty() || moved.size() == soup.triangles.size(), "one mark for each triangle");
  // Only the marked triangles go into the tree: few, when a front is mended here and there.
  std::vector<std::uint32_t> marked, others;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) (moved.empty() || moved[i] ? marked : others).push_back(i);
  std::vector<geometry::Box> boxes(marked.size());
  parallel_for(boxes.size(), [&](std::size_t k) { boxes[k] = box_of(soup, marked[k]); });
  const BoxTree tree(boxes);
  Pairs pairs;
  const auto search = [&](std::uint32_t i, const geometry::Box& box, std::size_t first, Pairs& found) {
    const auto meets_box = [&](const geometry::Box& b) { return b.intersects(box); };
    const auto visit = [&](std::size_t position) {
      const std::uint32_t j = marked[tree.item(position)];
      if (meet(soup, i, j)) found.push_back(std::minmax(i, j));
    };
    tree.for_each(meets_box, visit, first);
  };
  find_pairs(tree.size(), pairs,
             [&](std::size_t k, Pairs& found) { search(marked[tree.item(k)], tree.box(k), k + 1, found); });
  find_pairs(others.size(), pairs,
             [&](std::size_t k, Pairs& found) { search(others[k], box_of(soup, others[k]), 0, found); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace nearwall::search

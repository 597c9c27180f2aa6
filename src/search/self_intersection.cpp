#include "nearwall/search/self_intersection.h"

#include <algorithm>
#include <mutex>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "search/box_tree.h"
#include "search/triangle_pairs.h"

namespace nearwall::search {

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Triangles that one task looks at.
constexpr std::size_t kBlock = 1024;

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
      if (triangles_meet(soup.points, soup.triangles[i], soup.triangles[j])) found.push_back(std::minmax(i, j));
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

#include "search/box_tree.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include <oneapi/tbb/parallel_invoke.h>

#include "nearwall/core/errors.h"

namespace nearwall::search {

namespace {

/// Ranges of fewer items than this are not worth a task of their own.
constexpr std::size_t kTaskItems = 4096;

/// Sums of halves cannot overflow.
double centre(const geometry::Box& box, int axis) { return 0.5 * box.low[axis] + 0.5 * box.high[axis]; }

}  // namespace

BoxTree::BoxTree(std::span<const geometry::Box> boxes) : items_(boxes.size()), boxes_(boxes.size()) {
  for (const auto& box : boxes) {
    if (box.is_empty() || !is_finite(box.low) || !is_finite(box.high)) {
      throw InputError("expected finite coordinates in a search tree, found an infinite one or not a number");
    }
  }
  if (boxes.empty()) return;
  std::iota(items_.begin(), items_.end(), Item{0});
  while ((boxes.size() >> depth_) > kLeafItems) ++depth_;
  nodes_.resize((std::size_t{2} << depth_) - 1);
  build({0, 0, boxes.size(), 0}, boxes);
}

void BoxTree::build(const Range& range, std::span<const geometry::Box> boxes) {
  const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(range.begin);
  const auto end = items_.begin() + static_cast<std::ptrdiff_t>(range.end);
  geometry::Box& bounds = nodes_[range.node];
  if (range.depth == depth_) {
    for (std::size_t k = range.begin; k < range.end; ++k) bounds.include(boxes_[k] = boxes[items_[k]]);
    return;
  }
  geometry::Box centres;
  for (auto it = begin; it != end; ++it) {
    const geometry::Box& box = boxes[*it];
    centres.include({centre(box, 0), centre(box, 1), centre(box, 2)});
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (centres.high[k] - centres.low[k] > centres.high[axis] - centres.low[axis]) axis = k;
  }
  const auto halves = children(range);
  const auto middle = items_.begin() + static_cast<std::ptrdiff_t>(halves[1].begin);
  std::nth_element(begin, middle, end, [&](Item a, Item b) {
    return std::make_tuple(centre(boxes[a], axis), a) < std::make_tuple(centre(boxes[b], axis), b);
  });
  const Range &left = halves[0], &right = halves[1];
  if (range.end - range.begin >= kTaskItems) {
    oneapi::tbb::parallel_invoke([&] { build(left, boxes); }, [&] { build(right, boxes); });
  } else {
    build(left, boxes);
    build(right, boxes);
  }
  bounds.include(nodes_[left.node]);
  bounds.include(nodes_[right.node]);
}

}  // namespace nearwall::search

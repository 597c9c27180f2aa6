#include "nearwall/search/patch_tree.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "nearwall/core/parallel.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/orientation.h"
#include "search/box_tree.h"
#include "search/patch.h"
#include "search/ray_directions.h"
#include "search/segment_boxes.h"

namespace nearwall::search {

namespace {

using predicates::RayCrossing;
using predicates::Sign;

/// Patches that one task looks at, and after which the number of pairs is looked at.
constexpr std::size_t kBlock = 1024;
constexpr std::size_t kRound = 64 * kBlock;

/// The points of a gate begin as far from the patch as its longest edge is long and come nearer by halves: as far as
/// coordinates can tell them from it.
constexpr int kMaxHalvings = 60;

std::vector<geometry::Box> boxes_of(const IndexedPatches& patches) {
  std::vector<geometry::Box> boxes(patches.corners.size());
  parallel_for(boxes.size(), [&](std::size_t i) {
    for (const std::uint32_t node : patches.corners[i]) {
      if (node != kNoCorner) boxes[i].include(patches.points[node]);
    }
  });
  return boxes;
}

std::vector<PatchShape> shapes_of(const IndexedPatches& patches) {
  std::vector<PatchShape> shapes(patches.corners.size());
  parallel_for(shapes.size(), [&](std::size_t i) { shapes[i] = Patch::shape_of(patches.points, patches.corners[i]); });
  return shapes;
}

double longest_edge(const Patch& patch) {
  double longest = 0;
  for (int k = 0; k < patch.size(); ++k) {
    longest = std::max(longest, distance(patch.point(k), patch.point((k + 1) % patch.size())));
  }
  return longest;
}

/// Of a quad across its diagonals.
Vec3 normal_of(const Patch& patch) {
  if (patch.size() == 3) return normalized(cross(patch.point(1) - patch.point(0), patch.point(2) - patch.point(0)));
  return normalized(cross(patch.point(2) - patch.point(0), patch.point(3) - patch.point(1)));
}

/// Whether the way between the points surely crosses a patch once, from its one side to the other: within the hull of
/// a warped one, or from strictly beyond one side of all its triangles to beyond the other.
bool passes(const Patch& patch, const PatchTree::Gate& gate) {
  if (patch.is_warped() && patch.hull_contains(gate.behind) && patch.hull_contains(gate.before)) {
    return patch.side_in_hull(gate.behind) == Sign::Negative && patch.side_in_hull(gate.before) == Sign::Positive;
  }
  for (int i = 0; i < patch.n_triangles(); ++i) {
    const auto [a, b, c] = patch.triangle(i);
    if (predicates::orientation(a, b, c, gate.before) != Sign::Positive) return false;
    if (predicates::orientation(a, b, c, gate.behind) != Sign::Negative) return false;
  }
  return patch.is_surely_crossed(gate.behind, gate.before);
}

}  // namespace

struct PatchTree::Tree {
  explicit Tree(const IndexedPatches& all)
      : points(all.points), corners(all.corners), shapes(shapes_of(all)), tree(boxes_of(all)) {
    for (std::size_t k = 0; k < tree.size(); ++k) {
      reach = std::max({reach, max_norm(tree.box(k).low), max_norm(tree.box(k).high)});
    }
    if (reach == 0) reach = 1.0;
  }

  Patch patch(std::uint32_t i) const { return {points, corners[i], shapes[i]}; }

  /// Pairs of the patch at a place of the tree with those behind it.
  void find_pairs(std::size_t place, PatchPairs& found) const;
  std::optional<int> crossings(const Vec3& point, const Vec3& through, int pair) const;
  std::optional<int> between_patches_and_triangles(const Vec3& point, int pair) const;

  std::span<const Vec3> points;
  std::span<const std::array<std::uint32_t, 4>> corners;
  std::vector<PatchShape> shapes;
  BoxTree tree;
  double reach = 0;  ///< largest coordinate
};

void PatchTree::Tree::find_pairs(std::size_t place, PatchPairs& found) const {
  const std::uint32_t i = tree.item(place);
  const geometry::Box& box = tree.box(place);
  const Patch own = patch(i);
  const auto visit = [&](std::size_t other) {
    const std::uint32_t j = tree.item(other);
    const PatchContact c = contact(own, patch(j));
    if (c == PatchContact::Meeting) found.meeting.push_back(std::minmax(i, j));
    if (c == PatchContact::Undecided) found.undecided.push_back(std::minmax(i, j));
  };
  tree.for_each([&](const geometry::Box& b) { return b.intersects(box); }, visit, place + 1);
}

/// Signed crossings of a ray with triangles that stand in for the patches, of warped ones the first or the second pair;
/// nothing if the ray is degenerate.
std::optional<int> PatchTree::Tree::crossings(const Vec3& point, const Vec3& through, int pair) const {
  const SegmentBoxes ray(point, through, std::numeric_limits<double>::infinity());
  int sum = 0;
  bool is_degenerate = false;
  const auto visit = [&](std::size_t place) {
    const Patch p = patch(tree.item(place));
    const int first = p.is_warped() ? 2 * pair : 0;
    for (int i = first; i < p.n_triangles() && i < first + 2 && !is_degenerate; ++i) {
      const RayCrossing crossing = predicates::ray_crossing(point, through, p.triangle(i));
      if (crossing == RayCrossing::Degenerate) is_degenerate = true;
      if (crossing == RayCrossing::Along) ++sum;
      if (crossing == RayCrossing::Against) --sum;
    }
  };
  tree.for_each([&](const geometry::Box& b) { return !is_degenerate && !ray.interval(b).is_empty(); }, visit);
  if (is_degenerate) return std::nullopt;
  return sum;
}

/// What the winding number of the patches is more than that of the triangles. Nothing if the point lies on a patch.
std::optional<int> PatchTree::Tree::between_patches_and_triangles(const Vec3& point, int pair) const {
  int sum = 0;
  bool is_on_patch = false;
  const auto visit = [&](std::size_t place) {
    const Patch p = patch(tree.item(place));
    if (!p.is_warped() || !p.hull_contains(point)) return;
    const Sign side = p.side_in_hull(point);
    is_on_patch |= side == Sign::Zero;
    // On one side of the patch are the triangles of the first pair, on the other those of the second: where the hull
    // bends to the positive side, the first pair lies behind it. What lies behind the patch and before its triangles is
    // wound about once more than they tell; before it and behind them, once less.
    const Sign bend = predicates::orientation(p.point(0), p.point(1), p.point(2), p.point(3));
    const bool are_behind = (bend == Sign::Positive) == (pair == 0);
    if (side == Sign::Negative && are_behind) ++sum;
    if (side == Sign::Positive && !are_behind) --sum;
  };
  tree.for_each([&](const geometry::Box& b) { return b.contains(point); }, visit);
  if (is_on_patch) return std::nullopt;
  return sum;
}

PatchTree::PatchTree(const IndexedPatches& patches) : tree_(std::make_unique<Tree>(patches)) {}

PatchTree::~PatchTree() = default;

PatchPairs PatchTree::intersections(std::size_t limit) const {
  PatchPairs all;
  const std::size_t n = tree_->tree.size();
  for (std::size_t first = 0; first < n && all.is_complete; first += kRound) {
    std::mutex mutex;
    parallel_blocks(std::min(kRound, n - first), kBlock, [&](std::size_t begin, std::size_t end) {
      PatchPairs found;
      for (std::size_t k = begin; k < end; ++k) tree_->find_pairs(first + k, found);
      const std::lock_guard lock(mutex);
      all.meeting.insert(all.meeting.end(), found.meeting.begin(), found.meeting.end());
      all.undecided.insert(all.undecided.end(), found.undecided.begin(), found.undecided.end());
    });
    const bool is_last = n - first <= kRound;
    if (!is_last && all.meeting.size() + all.undecided.size() >= limit) all.is_complete = false;
  }
  std::sort(all.meeting.begin(), all.meeting.end());
  std::sort(all.undecided.begin(), all.undecided.end());
  return all;
}

std::optional<PatchTree::Gate> PatchTree::gate(std::uint32_t patch) const {
  const Patch own = tree_->patch(patch);
  const Vec3 middle = own.middle(), normal = normal_of(own);
  double reach = longest_edge(own);
  for (int halving = 0; halving < kMaxHalvings; ++halving, reach *= 0.5) {
    const Gate gate{middle - normal * reach, middle + normal * reach};
    if (!passes(own, gate)) continue;
    const SegmentBoxes way(gate.behind, gate.before, 1.0);
    bool is_free = true;
    const auto visit = [&](std::size_t place) {
      const std::uint32_t other = tree_->tree.item(place);
      if (other != patch && is_free) is_free = !tree_->patch(other).may_be_met(gate.behind, gate.before);
    };
    tree_->tree.for_each([&](const geometry::Box& b) { return is_free && !way.interval(b).is_empty(); }, visit);
    if (is_free) return gate;
  }
  return std::nullopt;
}

std::optional<int> PatchTree::winding_number(const Vec3& point) const {
  // A ray as long as its point is far from the origin has a direction that rounding hardly turns.
  const double reach = std::max(tree_->reach, max_norm(point));
  for (const int pair : {0, 1}) {
    const auto between = tree_->between_patches_and_triangles(point, pair);
    if (!between) return std::nullopt;
    for (int k = 0; k < kMaxRays; ++k) {
      if (const auto sum = tree_->crossings(point, point + reach * ray_direction(k), pair)) return *sum + *between;
    }
  }
  return std::nullopt;
}

}  // namespace nearwall::search

#include "nearwall/search/point_tree.h"

#include <algorithm>

#include "nearwall/geometry/box.h"
#include "search/box_tree.h"

namespace nearwall::search {

namespace {

std::vector<geometry::Box> boxes_of(std::span<const Vec3> points) {
  std::vector<geometry::Box> boxes;
  boxes.reserve(points.size());
  for (const Vec3& p : points) boxes.push_back({p, p});
  return boxes;
}

}  // namespace

struct PointTree::Tree {
  std::span<const Vec3> points;
  BoxTree boxes;
};

PointTree::PointTree(std::span<const Vec3> points)
    : tree_(std::make_unique<Tree>(Tree{points, BoxTree(boxes_of(points))})) {}

PointTree::~PointTree() = default;

std::vector<std::uint32_t> PointTree::within(const Vec3& place, double radius) const {
  std::vector<std::uint32_t> found;
  const Vec3 reach(radius, radius, radius);
  const geometry::Box near{place - reach, place + reach};
  tree_->boxes.for_each([&](const geometry::Box& box) { return box.intersects(near); },
                        [&](std::size_t position) {
                          const std::uint32_t point = tree_->boxes.item(position);
                          if (distance(tree_->points[point], place) <= radius) found.push_back(point);
                        });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace nearwall::search

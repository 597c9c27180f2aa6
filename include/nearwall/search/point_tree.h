#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"

namespace nearwall::search {

/// Points on a tree, for those near a place. Queries may run on many threads. The points must outlive it.
class PointTree {
 public:
  /// \throws InputError if a coordinate is not finite.    Cost: O(n log n), on all threads.
  explicit PointTree(std::span<const Vec3> points);
  ~PointTree();
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;

  /// Numbers of the points no farther than `radius` from `place`, in increasing order. Cost: O(log n + found).
  std::vector<std::uint32_t> within(const Vec3& place, double radius) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace nearwall::search

#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "nearwall/planar/point2.h"

namespace nearwall::planar {

/// A place at which a size is wanted.
struct SizeSource {
  Point2 place;
  double size = 0;  ///< [length], > 0
};

struct Grading {
  double growth = 0.3;                                       ///< growth of the size per unit of distance [-], >= 0
  double largest = std::numeric_limits<double>::infinity();  ///< no size is larger [length], > 0
};

/// Sizes that grow from edges and places: the least of (length of an edge + growth · distance from it), (size of a
/// source + growth · distance from it) and `largest`.
class GradedSize {
 public:
  /// \throws InputError  if a size, a length or the grading is outside its range, there is neither an edge nor a source
  /// nor a finite `largest`, or an edge names a point that does not exist. Cost: O(n log n).
  GradedSize(std::span<const Point2> points, std::span<const Edge> edges, const Grading& grading,
             std::span<const SizeSource> sources = {});

  /// Cost: O(log n) but where very many edges ask for nearly the same.
  double operator()(const Point2& p) const;

 private:
  struct Source {
    Point2 from, to;  // equal for a place
    double size;
  };
  struct Node {
    Point2 low, high;
    double smallest;
    std::uint32_t begin, end;  // of sources
    std::uint32_t second = 0;  // the first child follows its parent; 0: a leaf
  };
  void build(std::uint32_t begin, std::uint32_t end);
  double lower_bound(const Node& node, const Point2& p) const;
  void search(std::uint32_t node, const Point2& p, double& least) const;

  Grading grading_;
  std::vector<Source> sources_;
  std::vector<Node> nodes_;
};

}  // namespace nearwall::planar

#include "nearwall/planar/size_field.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::planar {
namespace {

/// Sources in a leaf of the tree.
constexpr std::uint32_t kLeaf = 4;

/// Distance to the segment from a to b, which may be a point.
double distance(const Point2& p, const Point2& a, const Point2& b) {
  const double u = b.u - a.u, v = b.v - a.v, x = p.u - a.u, y = p.v - a.v;
  const double along = u * x + v * y, square = u * u + v * v;
  const double share = along > 0 ? std::min(1.0, along / square) : 0;
  const double dx = x - share * u, dy = y - share * v;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

GradedSize::GradedSize(std::span<const Point2> points, std::span<const Edge> edges, const Grading& grading,
                       std::span<const SizeSource> sources)
    : grading_(grading) {
  if (!(grading.growth >= 0 && std::isfinite(grading.growth) && grading.largest > 0)) {
    throw InputError(
        fmt::format("graded size: expected a growth of at least 0 and a positive largest size, found {} and {}",
                    grading.growth, grading.largest));
  }
  sources_.reserve(edges.size() + sources.size());
  for (const auto& [a, b] : edges) {
    if (std::max(a, b) >= points.size()) {
      throw InputError(fmt::format("graded size: edge from point {} to {} of {} points", a, b, points.size()));
    }
    const double length = std::hypot(points[b].u - points[a].u, points[b].v - points[a].v);
    sources_.push_back({points[a], points[b], length});
  }
  for (const auto& [place, size] : sources) sources_.push_back({place, place, size});
  for (const Source& s : sources_) {
    if (!(s.size > 0 && std::isfinite(s.size))) {
      throw InputError(fmt::format("graded size: expected positive sizes and edges with a length, found {} at ({}, {})",
                                   s.size, s.from.u, s.from.v));
    }
  }
  if (sources_.empty() && !std::isfinite(grading.largest)) {
    throw InputError("graded size: no edge, no source and no largest size to tell a size from");
  }
  if (!sources_.empty()) build(0, static_cast<std::uint32_t>(sources_.size()));
}

void GradedSize::build(std::uint32_t begin, std::uint32_t end) {
  const auto number = nodes_.size();
  Node node{sources_[begin].from, sources_[begin].from, sources_[begin].size, begin, end};
  for (std::uint32_t i = begin; i < end; ++i) {
    const Source& s = sources_[i];
    node.low = {std::min({node.low.u, s.from.u, s.to.u}), std::min({node.low.v, s.from.v, s.to.v})};
    node.high = {std::max({node.high.u, s.from.u, s.to.u}), std::max({node.high.v, s.from.v, s.to.v})};
    node.smallest = std::min(node.smallest, s.size);
  }
  nodes_.push_back(node);
  if (end - begin <= kLeaf) return;

  const bool across = node.high.u - node.low.u < node.high.v - node.low.v;
  const auto middle = [across](const Source& s) { return across ? s.from.v + s.to.v : s.from.u + s.to.u; };
  const std::uint32_t half = begin + (end - begin) / 2;
  std::nth_element(sources_.begin() + begin, sources_.begin() + half, sources_.begin() + end,
                   [&](const Source& a, const Source& b) { return middle(a) < middle(b); });
  build(begin, half);
  nodes_[number].second = static_cast<std::uint32_t>(nodes_.size());
  build(half, end);
}

double GradedSize::lower_bound(const Node& node, const Point2& p) const {
  const double u = std::max({0.0, node.low.u - p.u, p.u - node.high.u});
  const double v = std::max({0.0, node.low.v - p.v, p.v - node.high.v});
  return node.smallest + grading_.growth * std::sqrt(u * u + v * v);
}

void GradedSize::search(std::uint32_t number, const Point2& p, double& least) const {
  const Node& node = nodes_[number];
  if (node.second == 0) {
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const Source& s = sources_[i];
      if (s.size < least) least = std::min(least, s.size + grading_.growth * distance(p, s.from, s.to));
    }
    return;
  }
  std::uint32_t near = number + 1, far = node.second;
  double near_bound = lower_bound(nodes_[near], p), far_bound = lower_bound(nodes_[far], p);
  if (far_bound < near_bound) {
    std::swap(near, far);
    std::swap(near_bound, far_bound);
  }
  if (near_bound < least) search(near, p, least);
  if (far_bound < least) search(far, p, least);
}

double GradedSize::operator()(const Point2& p) const {
  double least = grading_.largest;
  if (!nodes_.empty()) search(0, p, least);
  return least;
}

}  // namespace nearwall::planar

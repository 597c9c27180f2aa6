#include "volume/size_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nearwall/core/expect.h"

namespace nearwall::volume {

namespace {

constexpr std::uint32_t kLeaf = 8;
/// How much too large a value may be: sizes need no more, and it ends most searches early.
constexpr double kTolerance = 1.01;
/// Deeper than any tree of 2³² sources that is cut in halves.
constexpr int kDeepest = 64;

}  // namespace

std::vector<SizeSource> sizes_of_edges(std::span<const Vec3> points,
                                       std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<SizeSource> sources(points.size());
  std::vector<std::uint32_t> n_edges(points.size(), 0);
  // Each edge comes once from each of its two triangles: that changes no mean.
  for (const auto& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const double length = distance(points[a], points[b]);
      sources[a].size += length, sources[b].size += length;
      ++n_edges[a], ++n_edges[b];
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    sources[i].point = points[i];
    if (n_edges[i] > 0) sources[i].size /= n_edges[i];
  }
  return sources;
}

SizeField::SizeField(std::vector<SizeSource> sources, double slope, double largest)
    : sources_(std::move(sources)), slope_(slope), largest_(largest) {
  expect(!sources_.empty(), "a size field has a source");
  nodes_.reserve(sources_.size() / 2 + 2);
  build(0, static_cast<std::uint32_t>(sources_.size()));
}

std::uint32_t SizeField::build(std::uint32_t begin, std::uint32_t end) {
  Node node{sources_[begin].point, sources_[begin].point, sources_[begin].size, begin, end, 0};
  for (std::uint32_t i = begin; i < end; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis] = std::min(node.low[axis], sources_[i].point[axis]);
      node.high[axis] = std::max(node.high[axis], sources_[i].point[axis]);
    }
    node.least = std::min(node.least, sources_[i].size);
  }
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  if (end - begin <= kLeaf) return number;
  const Vec3 width = node.high - node.low;
  int axis = width.x() >= width.y() ? 0 : 1;
  if (width.z() > width[axis]) axis = 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(sources_.begin() + begin, sources_.begin() + middle, sources_.begin() + end,
                   [axis](const SizeSource& a, const SizeSource& b) { return a.point[axis] < b.point[axis]; });
  build(begin, middle);
  const std::uint32_t second = build(middle, end);
  nodes_[number].second = second;
  return number;
}

double SizeField::lower_bound(const Node& node, const Vec3& x) const {
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double out = std::max({node.low[axis] - x[axis], x[axis] - node.high[axis], 0.0});
    squared += out * out;
  }
  return node.least + slope_ * std::sqrt(squared);
}

double SizeField::at(const Vec3& x) const {
  double best = largest_;
  search(
      x, [&best](double bound) { return bound * kTolerance < best; },
      [&best](double size) {
        best = std::min(best, size);
        return true;
      });
  return best;
}

bool SizeField::is_under(const Vec3& x, double limit) const {
  if (largest_ < limit) return true;
  bool is_found = false;
  search(
      x, [&](double bound) { return bound < limit; },
      [&](double size) {
        is_found = size < limit;
        return !is_found;
      });
  return is_found;
}

template <class Worth, class Take>
void SizeField::search(const Vec3& x, Worth&& is_worth, Take&& take) const {
  std::pair<std::uint32_t, double> waiting[kDeepest];
  int n_waiting = 0;
  waiting[n_waiting++] = {0, lower_bound(nodes_[0], x)};
  while (n_waiting > 0) {
    const auto [number, bound] = waiting[--n_waiting];
    if (!is_worth(bound)) continue;
    const Node& node = nodes_[number];
    if (node.second == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (!take(sources_[i].size + slope_ * distance(sources_[i].point, x))) return;
      }
      continue;
    }
    std::pair<std::uint32_t, double> near{number + 1, lower_bound(nodes_[number + 1], x)};
    std::pair<std::uint32_t, double> far{node.second, lower_bound(nodes_[node.second], x)};
    if (far.second < near.second) std::swap(near, far);
    if (is_worth(far.second)) waiting[n_waiting++] = far;
    waiting[n_waiting++] = near;
  }
}

}  // namespace nearwall::volume

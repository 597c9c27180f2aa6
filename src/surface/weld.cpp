#include "nearwall/surface/weld.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "nearwall/core/errors.h"

namespace nearwall::surface {
namespace {

using Key = std::array<std::int64_t, 3>;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Points by key, chained in a table of heads.
class KeyTable {
 public:
  explicit KeyTable(std::size_t n)
      : heads_(std::bit_ceil(2 * n + 1), kNone), next_(n, kNone), keys_(n), mask_(heads_.size() - 1) {}

  void insert(const Key& key, std::uint32_t point) {
    std::uint32_t& head = heads_[slot(key)];
    keys_[point] = key;
    next_[point] = head;
    head = point;
  }

  template <class Visit>
  void for_each(const Key& key, Visit&& visit) const {
    for (std::uint32_t point = heads_[slot(key)]; point != kNone; point = next_[point]) {
      if (keys_[point] == key) visit(point);
    }
  }

 private:
  std::size_t slot(const Key& key) const {
    std::uint64_t hash = 0;
    for (const std::int64_t part : key) {
      // Multiplication spreads the bits upwards, the shift brings them down again (the constant is 2^64 / golden
      // ratio).
      hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash) & mask_;
  }

  std::vector<std::uint32_t> heads_, next_;
  std::vector<Key> keys_;
  std::size_t mask_;
};

Key bits_of(const Vec3& p) {
  Key key;
  for (int axis = 0; axis < 3; ++axis) key[static_cast<std::size_t>(axis)] = std::bit_cast<std::int64_t>(p[axis] + 0.0);
  return key;
}

std::vector<std::uint32_t> equal_points(std::span<const Vec3> points) {
  KeyTable table(points.size());
  std::vector<std::uint32_t> kept(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Key key = bits_of(points[i]);
    kept[i] = i;
    table.for_each(key, [&](std::uint32_t other) { kept[i] = other; });
    if (kept[i] == i) table.insert(key, i);
  }
  return kept;
}

/// Edge of the cells in which near points are looked for: the tolerance, but wide enough for cell numbers to be exact.
double cell_width(std::span<const Vec3> points, double tolerance) {
  double extent = 0;
  for (const Vec3& p : points) {
    if (is_finite(p)) extent = std::max(extent, max_norm(p));
  }
  return std::max(tolerance, std::ldexp(extent, -50));
}

Key cell_of(const Vec3& p, double width) {
  Key cell;
  for (int axis = 0; axis < 3; ++axis) {
    cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(p[axis] / width));
  }
  return cell;
}

template <class Visit>
void for_each_neighbour(const Key& cell, Visit&& visit) {
  for (std::int64_t i = -1; i <= 1; ++i) {
    for (std::int64_t j = -1; j <= 1; ++j) {
      for (std::int64_t k = -1; k <= 1; ++k) visit(Key{cell[0] + i, cell[1] + j, cell[2] + k});
    }
  }
}

/// Merges kept points within the tolerance further; `kept` is as equal_points leaves it.
void merge_near(std::span<const Vec3> points, double tolerance, std::vector<std::uint32_t>& kept) {
  const double width = cell_width(points, tolerance);
  KeyTable table(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (kept[i] != i) {
      kept[i] = kept[kept[i]];
      continue;
    }
    if (!is_finite(points[i])) continue;
    const Key cell = cell_of(points[i], width);
    std::uint32_t nearest_id = i;
    for_each_neighbour(cell, [&](const Key& key) {
      table.for_each(key, [&](std::uint32_t other) {
        if (other < nearest_id && distance(points[i], points[other]) <= tolerance) nearest_id = other;
      });
    });
    kept[i] = nearest_id;
    if (nearest_id == i) table.insert(cell, i);
  }
}

}  // namespace

std::vector<std::uint32_t> merged_points(std::span<const Vec3> points, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
    throw InputError(fmt::format("weld: expected a length of 0 or more, found {}", tolerance));
  }
  std::vector<std::uint32_t> kept = equal_points(points);
  if (tolerance > 0) merge_near(points, tolerance, kept);
  return kept;
}

mesh::SurfaceMesh weld(const mesh::SurfaceMesh& surface, double tolerance) {
  mesh::SurfaceMesh welded = surface;
  drop_unused_points(welded);
  const std::vector<std::uint32_t> kept = merged_points(welded.points.raw(), tolerance);
  for (auto& face : welded.faces) {
    for (VertexId& v : face) v = VertexId(kept[v.index()]);
  }
  for (mesh::PointArray& array : welded.point_arrays) {
    for (const VertexId v : array.values.ids()) {
      const double value = array.values[v];
      double& least = array.values[VertexId(kept[v.index()])];
      if (value < least || std::isnan(value)) least = value;
    }
  }
  drop_unused_points(welded);
  return welded;
}

void drop_unused_points(mesh::SurfaceMesh& surface) {
  IdVector<VertexId, VertexId> number(surface.points.size());
  std::vector<char> is_used(surface.points.size(), 0);
  for (const auto& face : surface.faces) {
    for (const VertexId v : face) is_used[v.index()] = 1;
  }
  IdVector<VertexId, Vec3> points;
  for (const VertexId v : surface.points.ids()) {
    if (is_used[v.index()]) number[v] = points.push_back(surface.points[v]);
  }
  if (points.size() == surface.points.size()) return;
  for (mesh::PointArray& array : surface.point_arrays) {
    IdVector<VertexId, double> values;
    values.reserve(points.size());
    for (const VertexId v : array.values.ids()) {
      if (is_used[v.index()]) values.push_back(array.values[v]);
    }
    array.values = std::move(values);
  }
  surface.points = std::move(points);
  for (auto& face : surface.faces) {
    for (VertexId& v : face) v = number[v];
  }
}

}  // namespace nearwall::surface

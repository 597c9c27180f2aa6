#include "nearwall/surface/fitted_normals.h"

#include <algorithm>
#include <array>
#include <utility>

#include "surface/fitted_normals_local.h"
#include "surface/power_of_two.h"

namespace nearwall::surface {

namespace {

/// A graph that is steeper than this, upright to 1e-8 rad, says nothing about the surface: its normal would be square
/// to the axis but for rounding.
constexpr double kSteepest = 0x1p26;

/// Neighbours that are no wider than this share of their length, as seen along the axis, lie on a line but for
/// rounding.
constexpr double kOnALine = 0x1p-40;

/// Vectors to the neighbours, the nearest `kMaxFittedNeighbours` of them in the order given.
struct Offsets {
  std::array<Vec3, kMaxFittedNeighbours> to;
  std::size_t n = 0;
};

Offsets offsets(const Vec3& point, std::span<const Vec3> neighbours) {
  Offsets result;
  if (neighbours.size() <= kMaxFittedNeighbours) {
    for (const Vec3& neighbour : neighbours) result.to[result.n++] = neighbour - point;
    return result;
  }
  std::vector<std::pair<double, std::size_t>> nearest;
  for (std::size_t i = 0; i < neighbours.size(); ++i) nearest.emplace_back(distance(neighbours[i], point), i);
  const auto last = nearest.begin() + kMaxFittedNeighbours;
  std::nth_element(nearest.begin(), last, nearest.end());
  std::sort(nearest.begin(), last, [](const auto& a, const auto& b) { return a.second < b.second; });
  for (auto it = nearest.begin(); it != last; ++it) result.to[result.n++] = neighbours[it->second] - point;
  return result;
}

/// Scales by a power of two so that the largest component is near 1: squares below cannot leave the range.
bool scale_to_unit(Offsets& offsets) {
  double largest = 0;
  for (std::size_t i = 0; i < offsets.n; ++i) {
    if (!is_finite(offsets.to[i])) return false;
    largest = std::max(largest, max_norm(offsets.to[i]));
  }
  const double scale = 1 / power_above(largest);
  for (std::size_t i = 0; i < offsets.n; ++i) offsets.to[i] *= scale;
  return largest > 0;
}

std::optional<LocalHeights> local_heights(const Vec3& point, const Vec3& axis, std::span<const Vec3> neighbours) {
  const Vec3 n = normalized(axis);
  Offsets offset = offsets(point, neighbours);
  if (n == Vec3{} || !is_finite(n) || !scale_to_unit(offset)) return std::nullopt;
  double largest = 0;
  Vec3 farthest;
  for (std::size_t i = 0; i < offset.n; ++i) {
    const Vec3 flat = offset.to[i] - n * dot(n, offset.to[i]);
    if (squared_norm(flat) > largest) largest = squared_norm(flat), farthest = offset.to[i];
  }
  LocalHeights local;
  local.frame = tangent_frame(n, farthest);
  if (local.frame.t1 == Vec3{}) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(offset.n);
  local.x.resize(count), local.y.resize(count), local.z.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3& d = offset.to[static_cast<std::size_t>(i)];
    local.x[i] = dot(d, local.frame.t1), local.y[i] = dot(d, local.frame.t2), local.z[i] = dot(d, n);
  }
  // The heights may be much larger than what the plane sees of the neighbours.
  const double scale = 1 / power_above(std::max(local.x.abs().maxCoeff(), local.y.abs().maxCoeff()));
  local.x *= scale, local.y *= scale, local.z *= scale;
  return local;
}

std::optional<Slopes> slopes(Fit fit, const LocalHeights& local) {
  switch (fit) {
    case Fit::LinearLeastSquares:
      return linear_fit_slopes(local);
    case Fit::QuadraticLeastSquares:
      return quadratic_fit_slopes(local);
    case Fit::RenkaCline:
      return renka_cline_slopes(local);
    case Fit::Shepard:
      return shepard_slopes(local);
    case Fit::Hardy:
      return hardy_slopes(local);
    case Fit::ThinPlate:
      return thin_plate_slopes(local);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> fitted_normal(Fit fit, const Vec3& point, const Vec3& axis, std::span<const Vec3> neighbours) {
  const auto local = local_heights(point, axis, neighbours);
  if (!local) return std::nullopt;
  const bool is_line = local->y.abs().maxCoeff() < kOnALine * local->x.abs().maxCoeff();
  if (is_line && fit != Fit::Shepard) return std::nullopt;
  const auto slope = slopes(fit, *local);
  if (!slope || !(slope->array().abs() < kSteepest).all()) return std::nullopt;
  return normal_of_slopes(local->frame, (*slope)[0], (*slope)[1]);
}

}  // namespace nearwall::surface

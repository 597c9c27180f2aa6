#include <Eigen/LU>
#include <cmath>

#include "surface/fitted_normals_local.h"

namespace nearwall::surface {

namespace {

/// Reciprocal condition number below which a system counts as singular: its solution would have fewer than four digits.
constexpr double kSingular = 0x1p-40;

/// Hardy's R over the mean distance of the neighbours. The larger, the smoother and the more exact, and the worse the
/// condition; figures in docs/theory/fitted-normals.md, section 3.
constexpr double kHardyRadius = 0.5;

/// Neighbours and the point, and the three coefficients of the affine part.
constexpr int kMaxUnknowns = static_cast<int>(kMaxFittedNeighbours) + 4;
using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxUnknowns, kMaxUnknowns>;
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxUnknowns>;

/// d² ln d²; docs/theory/fitted-normals.md, Eq. (8).
struct ThinPlate {
  double value(double d2) const { return d2 > 0 ? d2 * std::log(d2) : 0.0; }
  /// Twice the derivative by d².
  double slope(double d2) const { return 2 * (std::log(d2) + 1); }
};

/// sqrt(d² + R²); Eq. (9).
struct Multiquadric {
  double r2;
  double value(double d2) const { return std::sqrt(d2 + r2); }
  double slope(double d2) const { return 1 / std::sqrt(d2 + r2); }
};

/// Slopes at the point of the function of Eq. (7) with the given kernel.
template <class Kernel>
std::optional<Slopes> interpolant_slopes(const LocalHeights& local, const Kernel& kernel) {
  const Eigen::Index n = local.size(), point = n, constant = n + 1;
  // Narrow neighbourhoods, along y since x runs to the farthest: the affine part in units of its own.
  const double width = local.y.abs().maxCoeff();
  if (n < 2 || !(width > 0)) return std::nullopt;
  System system = System::Zero(n + 4, n + 4);
  Unknowns heights = Unknowns::Zero(n + 4);
  const auto distance2 = [&](Eigen::Index i, Eigen::Index j) {
    const double dx = local.x[i] - local.x[j], dy = local.y[i] - local.y[j];
    return dx * dx + dy * dy;
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) system(i, j) = system(j, i) = kernel.value(distance2(i, j));
    system(i, i) = kernel.value(0);
    system(i, point) = system(point, i) = kernel.value(local.x[i] * local.x[i] + local.y[i] * local.y[i]);
    system(i, constant + 1) = system(constant + 1, i) = local.x[i];
    system(i, constant + 2) = system(constant + 2, i) = local.y[i] / width;
    heights[i] = local.z[i];
  }
  system(point, point) = kernel.value(0);
  system.col(constant).head(n + 1).setOnes();
  system.row(constant).head(n + 1).setOnes();
  const Eigen::PartialPivLU<System> lu(system);
  if (!(lu.rcond() > kSingular)) return std::nullopt;
  const Unknowns c = lu.solve(heights);
  Slopes slopes(c[constant + 1], c[constant + 2] / width);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double d2 = local.x[i] * local.x[i] + local.y[i] * local.y[i];
    slopes -= c[i] * kernel.slope(d2) * Slopes(local.x[i], local.y[i]);
  }
  return slopes;
}

}  // namespace

std::optional<Slopes> shepard_slopes(const LocalHeights& local) {
  constexpr Eigen::Index kFewest = 3;
  if (local.size() < kFewest) return std::nullopt;
  const auto d2 = (local.x.square() + local.y.square()).eval();
  if (!(d2 > 0).all()) return std::nullopt;
  const auto weight = d2.inverse().eval();
  const double sum = weight.sum(), mean = (weight * local.z).sum() / sum;
  const auto pull = (2 * weight.square() * (local.z - mean)).eval();
  return Slopes((pull * local.x).sum() / sum, (pull * local.y).sum() / sum);
}

std::optional<Slopes> hardy_slopes(const LocalHeights& local) {
  if (local.size() == 0) return std::nullopt;
  const double r = kHardyRadius * (local.x.square() + local.y.square()).sqrt().mean();
  return interpolant_slopes(local, Multiquadric{r * r});
}

std::optional<Slopes> thin_plate_slopes(const LocalHeights& local) { return interpolant_slopes(local, ThinPlate{}); }

}  // namespace nearwall::surface

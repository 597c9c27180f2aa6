#include <Eigen/QR>

#include "surface/fitted_normals_local.h"

namespace nearwall::surface {

namespace {

/// Columns (of unit length) whose part square to the others is shorter are taken to depend on them.
constexpr double kDependent = 0x1p-30;

/// Radius of influence of Renka and Cline's weights over the distance of the farthest neighbour: more than 1, or that
/// one would not count at all, and a ring of equally far neighbours would leave nothing. Figures for other radii in
/// docs/theory/fitted-normals.md, section 3.
constexpr double kInfluence = 1.0625;

/// One row a node: the point itself may be one of them.
constexpr int kMaxRows = static_cast<int>(kMaxFittedNeighbours) + 1;

template <int n_columns>
using Design = Eigen::Array<double, Eigen::Dynamic, n_columns, Eigen::ColMajor, kMaxRows>;
using Heights = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxRows>;

/// Coefficients `first` and `first + 1` of the least squares solution.
template <int n_columns>
std::optional<Slopes> least_squares(Design<n_columns> design, const Heights& heights, int first) {
  if (design.rows() < n_columns) return std::nullopt;
  // Columns of one length: whether they are independent does not depend on the units of the coefficients.
  const Eigen::Array<double, 1, n_columns> lengths = design.matrix().colwise().norm();
  if (!(lengths > 0).all()) return std::nullopt;
  design.rowwise() /= lengths;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, n_columns, Eigen::ColMajor, kMaxRows>;
  Eigen::ColPivHouseholderQR<Matrix> solver(design.matrix());
  solver.setThreshold(kDependent);
  if (solver.rank() < n_columns) return std::nullopt;
  const Eigen::Array<double, n_columns, 1> coefficients = solver.solve(heights.matrix());
  return Slopes(coefficients[first] / lengths[first], coefficients[first + 1] / lengths[first + 1]);
}

}  // namespace

std::optional<Slopes> linear_fit_slopes(const LocalHeights& local) {
  const Eigen::Index n = local.size();
  Design<3> design = Design<3>::Zero(n + 1, 3);
  design.col(0) = 1;
  design.col(1).head(n) = local.x;
  design.col(2).head(n) = local.y;
  Heights heights = Heights::Zero(n + 1);
  heights.head(n) = local.z;
  return least_squares<3>(design, heights, 1);
}

std::optional<Slopes> quadratic_fit_slopes(const LocalHeights& local) {
  const Eigen::Index n = local.size();
  Design<6> design = Design<6>::Zero(n + 1, 6);
  design.col(0) = 1;
  design.col(1).head(n) = local.x;
  design.col(2).head(n) = local.y;
  design.col(3).head(n) = local.x.square();
  design.col(4).head(n) = local.x * local.y;
  design.col(5).head(n) = local.y.square();
  Heights heights = Heights::Zero(n + 1);
  heights.head(n) = local.z;
  return least_squares<6>(design, heights, 1);
}

std::optional<Slopes> renka_cline_slopes(const LocalHeights& local) {
  const Eigen::Index n = local.size();
  if (local.size() == 0) return std::nullopt;
  const Heights d = (local.x.square() + local.y.square()).sqrt();
  if (!(d > 0).all()) return std::nullopt;
  const Heights weight = d.inverse() - 1 / (kInfluence * d.maxCoeff());
  Design<5> design(n, 5);
  design.col(0) = weight * local.x;
  design.col(1) = weight * local.y;
  design.col(2) = weight * local.x.square();
  design.col(3) = weight * local.x * local.y;
  design.col(4) = weight * local.y.square();
  return least_squares<5>(design, weight * local.z, 0);
}

}  // namespace nearwall::surface

#include "lean_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

namespace nearwall::layers {

namespace {

using mesh::Topology;
using Matrix = Eigen::SparseMatrix<double>;
using Directions = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Relative residual: directions need no more digits than the limits that follow from them.
constexpr double kTolerance = 1e-3;
constexpr int kMostIterations = 400;

Eigen::RowVector3d row_of(const Vec3& d) { return {d.x(), d.y(), d.z()}; }

/// The line of a vertex that stands in face f.
LineId line_in(const Wall& wall, const LinePlan& plan, FaceId f, VertexId v) {
  const auto& corners = wall.surface.faces[f];
  const std::size_t k = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
  return plan.front.faces[FrontFaceId(f.index())].lines[k];
}

Vec3 direction_of(const LinePlan& plan, LineId line, double thickness) {
  if (!(thickness > 0)) return plan.direction[line];
  const Vec3 chord = plan.offset(line, thickness);
  return chord / norm(chord);
}

}  // namespace

std::vector<Vec3> solve_lean(const Wall& wall, const VertexField& field, const LinePlan& plan,
                             const std::vector<VertexId>& vertices, const IdVector<VertexId, int>& number,
                             double length) {
  const auto n = static_cast<Eigen::Index>(vertices.size());
  std::vector<Eigen::Triplet<double>> entries;
  Directions right = Directions::Zero(n, 3), x(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const VertexId v = vertices[static_cast<std::size_t>(i)];
    const bool is_on_ridge = wall.features.kind[v] == surface::PointKind::Ridge;
    x.row(i) = row_of(direction_of(plan, plan.front.line_of(v), field.thickness[v]));
    double sum = 0, n_edges = 0;
    for (const HalfedgeId h : wall.topology.fan(v)) {
      if (is_on_ridge && !wall.features.is_ridge[h]) continue;
      const VertexId u = wall.topology.target(h);
      const double weight = 1 / squared_norm(wall.surface.points[u] - wall.surface.points[v]);
      ++n_edges;
      sum += weight;
      if (number[u] >= 0) {
        entries.emplace_back(i, number[u], -weight);
      } else {
        const LineId line = line_in(wall, plan, Topology::face(h), u);
        right.row(i) += weight * row_of(direction_of(plan, line, field.thickness[u]));
      }
    }
    // With weights 1 / e² the sum over n neighbours is n / 4 of the Laplacian in the plane, n / 2 of it along a ridge.
    const double l = length * field.thickness[v], screen = n_edges / ((is_on_ridge ? 2 : 4) * l * l);
    right.row(i) += screen * x.row(i);
    entries.emplace_back(i, i, sum + screen);
  }
  Matrix a(n, n);
  a.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(kTolerance);
  solver.setMaxIterations(kMostIterations);
  solver.compute(a);
  x = solver.solveWithGuess(right, x).eval();
  std::vector<Vec3> directions;
  directions.reserve(vertices.size());
  for (Eigen::Index i = 0; i < n; ++i) directions.emplace_back(x(i, 0), x(i, 1), x(i, 2));
  return directions;
}

}  // namespace nearwall::layers

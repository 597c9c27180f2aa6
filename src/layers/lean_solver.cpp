#include "lean_solver.h"

#include <cmath>
#include <unordered_map>
#include <utility>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include "nearwall/core/parallel.h"

namespace nearwall::layers {

namespace {

using mesh::Topology;
using Matrix = Eigen::SparseMatrix<double>;
using Directions = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Of the change of directions: they need no more digits than the limits that follow from them.
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

/// What a vertex says of its direction: (sum of weights + screen) d - sum of weight d_neighbour = screen d0, divided by
/// the root of its own and of the neighbour's factor, so that small triangles do not outweigh large ones.
struct Row {
  double factor = 0;
  std::vector<std::pair<VertexId, double>> neighbours;  ///< those that are solved for, and their weights
  Eigen::RowVector3d right = Eigen::RowVector3d::Zero();
};

/// Gathers rows and solves for one part of the vertices that hangs together after the other: what is done in one place
/// does not depend on what there is elsewhere.
class LeanSystem {
 public:
  LeanSystem(const Wall& wall, const VertexField& field, const LinePlan& plan, const std::vector<VertexId>& vertices,
             const IdVector<VertexId, int>& number, double length)
      : wall_(wall), field_(field), plan_(plan), number_(number), vertices_(vertices), rows_(vertices.size()) {
    parallel_for(vertices.size(), [&](std::size_t i) { rows_[i] = row(vertices[i], length); });
  }

  std::vector<Vec3> solve() const {
    std::vector<Vec3> directions(vertices_.size());
    std::vector<char> is_done(vertices_.size(), 0);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (!is_done[i]) solve_part(part_of(i, is_done), directions);
    }
    return directions;
  }

 private:
  Row row(VertexId v, double length) const {
    const bool is_on_ridge = wall_.features.kind[v] == surface::PointKind::Ridge;
    Row row;
    double n_edges = 0;
    const auto add = [&](VertexId u, FaceId f) {
      const double weight = 1 / squared_norm(wall_.surface.points[u] - wall_.surface.points[v]);
      ++n_edges;
      row.factor += weight;
      if (number_[u] >= 0) {
        row.neighbours.emplace_back(u, weight);
      } else {
        row.right += weight * row_of(direction_of(plan_, line_in(wall_, plan_, f, u), field_.thickness[u]));
      }
    };
    if (is_on_ridge) {
      for (const HalfedgeId h : wall_.topology.fan(v)) {
        if (wall_.features.is_ridge[h]) add(wall_.topology.target(h), Topology::face(h));
      }
    } else {
      wall_.topology.for_each_spoke(v, add);
    }
    // With weights 1 / e² the sum over n neighbours is n / 4 of the Laplacian in the plane, n / 2 of it along a ridge.
    const double l = length * field_.thickness[v], screen = n_edges / ((is_on_ridge ? 2 : 4) * l * l);
    row.right += screen * row_of(direction_of(plan_, plan_.front.line_of(v), field_.thickness[v]));
    row.factor += screen;
    return row;
  }

  std::vector<std::size_t> part_of(std::size_t start, std::vector<char>& is_done) const {
    std::vector<std::size_t> part{start};
    is_done[start] = 1;
    for (std::size_t k = 0; k < part.size(); ++k) {
      for (const auto& [u, weight] : rows_[part[k]].neighbours) {
        const auto i = static_cast<std::size_t>(number_[u]);
        if (!is_done[i]) part.push_back(i);
        is_done[i] = 1;
      }
    }
    return part;
  }

  /// For the change of the present directions: the tolerance is a share of that, not of the directions.
  void solve_part(const std::vector<std::size_t>& part, std::vector<Vec3>& directions) const {
    const auto n = static_cast<Eigen::Index>(part.size());
    std::unordered_map<std::size_t, Eigen::Index> place;
    for (Eigen::Index k = 0; k < n; ++k) place[part[static_cast<std::size_t>(k)]] = k;
    std::vector<Eigen::Triplet<double>> entries;
    Directions present(n, 3), miss(n, 3);
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::size_t i = part[static_cast<std::size_t>(k)];
      present.row(k) = row_of(direction_of(plan_, plan_.front.line_of(vertices_[i]), field_.thickness[vertices_[i]]));
    }
    for (Eigen::Index k = 0; k < n; ++k) {
      const Row& own = rows_[part[static_cast<std::size_t>(k)]];
      miss.row(k) = own.right - own.factor * present.row(k);
      entries.emplace_back(k, k, 1.0);
      for (const auto& [u, weight] : own.neighbours) {
        const auto i = static_cast<std::size_t>(number_[u]);
        const Eigen::Index other = place.at(i);
        miss.row(k) += weight * present.row(other);
        entries.emplace_back(k, other, -weight / std::sqrt(own.factor * rows_[i].factor));
      }
      miss.row(k) /= std::sqrt(own.factor);
    }
    Matrix a(n, n);
    a.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Eigen::IdentityPreconditioner> solver;
    solver.setTolerance(kTolerance);
    solver.setMaxIterations(kMostIterations);
    solver.compute(a);
    const Directions change = solver.solve(miss);
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::size_t i = part[static_cast<std::size_t>(k)];
      const Eigen::RowVector3d d = present.row(k) + change.row(k) / std::sqrt(rows_[i].factor);
      directions[i] = Vec3(d.x(), d.y(), d.z());
    }
  }

  const Wall& wall_;
  const VertexField& field_;
  const LinePlan& plan_;
  const IdVector<VertexId, int>& number_;
  const std::vector<VertexId>& vertices_;
  std::vector<Row> rows_;
};

}  // namespace

std::vector<Vec3> solve_lean(const Wall& wall, const VertexField& field, const LinePlan& plan,
                             const std::vector<VertexId>& vertices, const IdVector<VertexId, int>& number,
                             double length) {
  return LeanSystem(wall, field, plan, vertices, number, length).solve();
}

}  // namespace nearwall::layers

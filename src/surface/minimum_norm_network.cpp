#include "nearwall/surface/minimum_norm_network.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "surface/power_of_two.h"
#include "surface/tangent_frame.h"

namespace nearwall::surface {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using mesh::Topology;

/// Edges steeper than this as seen from the axes' plane, and edges between axes whose mean is shorter, are no graphs.
constexpr double kVertical = 0x1p-20;

/// Directions of a vertex' edges count as one if the smaller eigenvalue of their energy is below this part of the
/// other.
constexpr double kOneDirection = 0x1p-40;

/// Part of the longest edge over an edge's length above which the edge is left out, as if its ends were one point:
/// squares of its energy would leave the range of doubles.
constexpr double kLargestWeight = 0x1p500;

/// Steps of the iteration, some four times as many as Eq. (14) asks for.
constexpr int kMostSteps = 100;

/// What an end's slopes do to the slope of an edge relative to its chord: p . slopes + q; Eq. (11).
struct End {
  Vector2d p;
  double q;
};

struct Edge {
  VertexId v, w;
  End at_v, at_w;
  double weight;  // 1 / L, L in units of the network
};

/// Power of two above the largest extent of an edge along an axis. In units of it all scales give the same bits: the
/// square roots below would tell even powers from odd ones.
double unit_length(const mesh::SurfaceMesh& surface) {
  double largest = 0;
  for (const auto& [a, b, c] : surface.faces) {
    const Vec3 &pa = surface.points[a], &pb = surface.points[b], &pc = surface.points[c];
    largest = std::max({largest, max_norm(pb - pa), max_norm(pc - pb), max_norm(pa - pc)});
  }
  if (!std::isfinite(largest))
    throw InputError("minimum_norm_network_normals: an edge is longer than doubles can hold");
  return power_above(largest);
}

/// The quadratic energy of the network in the slopes at all vertices.
class Network {
 public:
  Network(const mesh::SurfaceMesh& surface, const Topology& topology, const IdVector<VertexId, Vec3>& axes);

  NetworkNormals normals() const;

 private:
  TangentFrame frame_at(VertexId v, const Vec3& axis) const;
  void add_edge(VertexId v, VertexId w);
  void make_blocks();
  Eigen::VectorXd solved() const;
  bool has_slopes(VertexId v) const { return factors_[v](0, 0) > 0; }

  const mesh::SurfaceMesh& surface_;
  const Topology& topology_;
  double unit_;
  IdVector<VertexId, TangentFrame> frames_;
  std::vector<Edge> edges_;
  /// Inverse of the triangular factor of each vertex' block: slopes = factor^T . unknowns. Zero: slopes are held at 0.
  IdVector<VertexId, Matrix2d> factors_;
};

Network::Network(const mesh::SurfaceMesh& surface, const Topology& topology, const IdVector<VertexId, Vec3>& axes)
    : surface_(surface),
      topology_(topology),
      unit_(unit_length(surface)),
      frames_(axes.size()),
      factors_(axes.size(), Matrix2d::Zero()) {
  for (const VertexId v : axes.ids()) frames_[v] = frame_at(v, axes[v]);
  for (std::size_t i = 0; i < 3 * topology.n_faces(); ++i) {
    const HalfedgeId h(i), twin = topology.twin(h);
    if (!twin.is_valid() || h < twin) add_edge(topology.origin(h), topology.target(h));
  }
  make_blocks();
}

/// First vector along the first edge that is not along the axis.
TangentFrame Network::frame_at(VertexId v, const Vec3& axis) const {
  TangentFrame frame{{}, {}, normalized(axis)};
  if (frame.n == Vec3{}) return frame;
  for (const HalfedgeId h : topology_.fan(v)) {
    frame = tangent_frame(frame.n, normalized(surface_.points[topology_.target(h)] - surface_.points[v]));
    if (frame.t1 != Vec3{}) break;
  }
  return frame;
}

void Network::add_edge(VertexId v, VertexId w) {
  const TangentFrame &fv = frames_[v], &fw = frames_[w];
  const Vec3 sum = fv.n + fw.n, d = surface_.points[w] - surface_.points[v];
  if (fv.t1 == Vec3{} || fw.t1 == Vec3{} || !(norm(sum) > kVertical)) return;
  const Vec3 n = normalized(sum), along = normalized(d), flat = along - n * dot(along, n);
  if (!(norm(flat) > kVertical)) return;
  const Vec3 u = normalized(flat);
  const double weight = unit_ / dot(d, u);
  if (!(weight < kLargestWeight)) return;
  const double chord_slope = dot(along, n) / dot(along, u);
  const auto end = [&](const TangentFrame& frame) {
    const double up = dot(frame.n, n);
    return End{Vector2d(dot(frame.t1, u), dot(frame.t2, u)) / up, -dot(frame.n, u) / up - chord_slope};
  };
  edges_.push_back({v, w, end(fv), end(fw), weight});
}

/// A vertex' own part of the energy, a 2 x 2 block, as the sum of two squares; Eq. (13).
void Network::make_blocks() {
  IdVector<VertexId, Matrix2d> blocks(frames_.size(), Matrix2d::Zero());
  for (const Edge& e : edges_) {
    blocks[e.v] += 2 * e.weight * e.at_v.p * e.at_v.p.transpose();
    blocks[e.w] += 2 * e.weight * e.at_w.p * e.at_w.p.transpose();
  }
  for (const VertexId v : blocks.ids()) {
    const double trace = blocks[v].trace();
    if (!(blocks[v].determinant() > kOneDirection * trace * trace)) continue;
    const Matrix2d lower = blocks[v].llt().matrixL();
    factors_[v] << 1 / lower(0, 0), 0, -lower(1, 0) / (lower(0, 0) * lower(1, 1)), 1 / lower(1, 1);
  }
}

/// Solves Eq. (13), whose matrix has its eigenvalues from 1/2 to 3/2 on any mesh, Eq. (14): no preconditioner, and some
/// 25 steps.
Eigen::VectorXd Network::solved() const {
  const auto size = static_cast<Eigen::Index>(2 * frames_.size());
  // Some 26 entries a vertex: 32 bits would number those of 82 million vertices.
  using Index = std::int64_t;
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(2 * frames_.size() + 8 * edges_.size());
  for (Eigen::Index i = 0; i < size; ++i) entries.emplace_back(i, i, 1.0);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  for (const Edge& e : edges_) {
    const Vector2d pv = factors_[e.v] * e.at_v.p, pw = factors_[e.w] * e.at_w.p;
    const Eigen::Index iv = 2 * Eigen::Index{e.v.index()}, iw = 2 * Eigen::Index{e.w.index()};
    right.segment<2>(iv) -= e.weight * (2 * e.at_v.q + e.at_w.q) * pv;
    right.segment<2>(iw) -= e.weight * (2 * e.at_w.q + e.at_v.q) * pw;
    const Matrix2d coupling = e.weight * pv * pw.transpose();
    for (Eigen::Index i = 0; i < 2; ++i) {
      for (Eigen::Index j = 0; j < 2; ++j) {
        entries.emplace_back(iv + i, iw + j, coupling(i, j));
        entries.emplace_back(iw + j, iv + i, coupling(i, j));
      }
    }
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor, Index> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<decltype(matrix), Eigen::Lower | Eigen::Upper, Eigen::IdentityPreconditioner> solver(matrix);
  solver.setMaxIterations(kMostSteps);
  const Eigen::VectorXd unknowns = solver.solve(right);
  if (solver.info() == Eigen::Success) return unknowns;
  throw InternalError(fmt::format("minimum_norm_network_normals: not solved after {} steps, relative residual {:.2e}",
                                  solver.iterations(), solver.error()));
}

NetworkNormals Network::normals() const {
  const Eigen::VectorXd unknowns = solved();
  NetworkNormals normals{IdVector<VertexId, Vec3>(frames_.size()), IdVector<VertexId, char>(frames_.size())};
  for (const VertexId v : frames_.ids()) {
    const Vector2d slopes = factors_[v].transpose() * unknowns.segment<2>(2 * Eigen::Index{v.index()});
    normals.direction[v] = normal_of_slopes(frames_[v], slopes[0], slopes[1]);
    normals.is_axis[v] = !has_slopes(v);
  }
  return normals;
}

}  // namespace

NetworkNormals minimum_norm_network_normals(const mesh::SurfaceMesh& surface, const Topology& topology,
                                            const IdVector<VertexId, Vec3>& axes) {
  expect(surface.points.size() == topology.n_vertices() && axes.size() == topology.n_vertices(),
         "minimum_norm_network_normals: surface, topology and axes are of the same mesh");
  for (const VertexId v : axes.ids()) {
    const Vec3 &axis = axes[v], &p = surface.points[v];
    if (is_finite(axis) && is_finite(p)) continue;
    throw InputError(
        fmt::format("minimum_norm_network_normals: expected finite points and axes, found vertex {} at ({}, {}, {}) "
                    "with the axis ({}, {}, {})",
                    v.index(), p.x(), p.y(), p.z(), axis.x(), axis.y(), axis.z()));
  }
  return Network(surface, topology, axes).normals();
}

}  // namespace nearwall::surface

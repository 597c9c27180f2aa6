#include "nearwall/volume/hybrid_mesh.h"

#include <algorithm>

namespace nearwall::volume {

namespace {

constexpr std::size_t kInBatch = 16384;

std::size_t n_blocks(std::size_t n) { return (n + kInBatch - 1) / kInBatch; }

}  // namespace

HybridMesh::HybridMesh(const mesh::MeshSource& layers, const RestBoundary& rest, const Fill& fill)
    : layers_(&layers), fill_(&fill), node_(fill.points.size()) {
  for (std::uint32_t i = 0; i < fill.points.size(); ++i) {
    if (i < rest.node.size() && rest.node[i] != kNoLayerNode) {
      node_[i] = rest.node[i];
    } else {
      node_[i] = layers.n_points() + added_.size();
      added_.push_back(i);
    }
  }
}

std::array<CellIndex, mesh::kNCellTypes> HybridMesh::n_cells_by_type() const {
  auto n = layers_->n_cells_by_type();
  n[static_cast<std::size_t>(mesh::CellType::Tetrahedron)] += fill_->tetrahedra.size();
  return n;
}

std::size_t HybridMesh::n_point_batches() const { return layers_->n_point_batches() + n_blocks(added_.size()); }
std::size_t HybridMesh::n_cell_batches() const {
  return layers_->n_cell_batches() + n_blocks(fill_->tetrahedra.size());
}

void HybridMesh::read_points(std::size_t batch, mesh::PointBatch& out) const {
  if (batch < layers_->n_point_batches()) return layers_->read_points(batch, out);
  out.clear();
  const std::size_t begin = (batch - layers_->n_point_batches()) * kInBatch;
  const std::size_t end = std::min(added_.size(), begin + kInBatch);
  out.first = layers_->n_points() + begin;
  for (std::size_t i = begin; i < end; ++i) {
    out.position.push_back(fill_->points[added_[i]]);
    out.line.push_back(-1);
    out.level.push_back(0);
  }
}

void HybridMesh::read_cells(std::size_t batch, mesh::CellBatch& out) const {
  if (batch < layers_->n_cell_batches()) return layers_->read_cells(batch, out);
  out.clear();
  const std::size_t begin = (batch - layers_->n_cell_batches()) * kInBatch;
  const std::size_t end = std::min(fill_->tetrahedra.size(), begin + kInBatch);
  out.first = layers_->n_cells() + begin;
  for (std::size_t i = begin; i < end; ++i) {
    std::array<NodeIndex, 8> nodes{};
    std::array<Vec3, 8> corners{};
    for (std::size_t k = 0; k < 4; ++k) {
      nodes[k] = node_[fill_->tetrahedra[i][k]];
      corners[k] = fill_->points[fill_->tetrahedra[i][k]];
    }
    out.type.push_back(mesh::CellType::Tetrahedron);
    out.nodes.push_back(nodes);
    out.corners.push_back(corners);
    out.layer.push_back(0);
    out.column.push_back(-1);
    out.patch.push_back(-1);
  }
}

}  // namespace nearwall::volume

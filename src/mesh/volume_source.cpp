#include "nearwall/mesh/volume_source.h"

#include <algorithm>

#include "nearwall/core/expect.h"

namespace nearwall::mesh {

namespace {

constexpr std::size_t kInBatch = 32768;

std::size_t n_batches(std::size_t n) { return (n + kInBatch - 1) / kInBatch; }

}  // namespace

VolumeSource::VolumeSource(const VolumeMesh& mesh) : mesh_(&mesh), is_all_(true) {
  for (const CellType type : mesh.type) ++n_by_type_[static_cast<std::size_t>(type)];
}

VolumeSource::VolumeSource(const VolumeMesh& mesh, std::span<const CellIndex> cells)
    : mesh_(&mesh), is_all_(false), cells_(cells.begin(), cells.end()) {
  for (const CellIndex cell : cells_) {
    expect(cell < mesh.n_cells(), "cells of the mesh");
    ++n_by_type_[static_cast<std::size_t>(mesh.type[cell])];
    const auto nodes = mesh.nodes_of(cell);
    points_.insert(points_.end(), nodes.begin(), nodes.end());
  }
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
}

NodeIndex VolumeSource::n_points() const { return is_all_ ? mesh_->points.size() : points_.size(); }

CellIndex VolumeSource::n_cells() const { return is_all_ ? mesh_->n_cells() : cells_.size(); }

std::size_t VolumeSource::n_point_batches() const { return n_batches(n_points()); }

std::size_t VolumeSource::n_cell_batches() const { return n_batches(n_cells()); }

NodeIndex VolumeSource::own_point(std::uint32_t node) const {
  if (is_all_) return node;
  return static_cast<NodeIndex>(std::lower_bound(points_.begin(), points_.end(), node) - points_.begin());
}

void VolumeSource::read_points(std::size_t batch, PointBatch& out) const {
  out.clear();
  out.first = batch * kInBatch;
  const NodeIndex end = std::min<NodeIndex>(n_points(), out.first + kInBatch);
  for (NodeIndex i = out.first; i < end; ++i) out.position.push_back(mesh_->points[mesh_point(i)]);
  out.line.assign(out.position.size(), -1);
  out.level.assign(out.position.size(), 0);
}

void VolumeSource::read_cells(std::size_t batch, CellBatch& out) const {
  out.clear();
  out.first = batch * kInBatch;
  const CellIndex end = std::min<CellIndex>(n_cells(), out.first + kInBatch);
  for (CellIndex i = out.first; i < end; ++i) {
    const CellIndex cell = mesh_cell(i);
    std::array<NodeIndex, 8> nodes{};
    std::size_t k = 0;
    for (const std::uint32_t node : mesh_->nodes_of(cell)) nodes[k++] = own_point(node);
    out.type.push_back(mesh_->type[cell]);
    out.nodes.push_back(nodes);
    out.corners.push_back(mesh_->corners_of(cell));
    out.layer.push_back(mesh_->layer.empty() ? 0 : mesh_->layer[cell]);
  }
  out.column.assign(out.size(), -1);
  out.patch.assign(out.size(), -1);
}

}  // namespace nearwall::mesh

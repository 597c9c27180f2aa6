#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nearwall/mesh/mesh_source.h"
#include "nearwall/volume/rest_boundary.h"

namespace nearwall::volume {

/// Layers and the tetrahedra that fill the rest, as one mesh. Points: those of the layers in their numbering, then
/// those added on planes and within. Cells: those of the layers, then the tetrahedra, which have no layer (0), column
/// or patch (−1). What it is made from must outlive it; nothing is copied.
class HybridMesh final : public mesh::MeshSource {
 public:
  /// \param layers  as the writers read them: a source of `n_nodes` points of the layer mesh and its cells
  HybridMesh(const mesh::MeshSource& layers, const RestBoundary& rest, const Fill& fill);

  NodeIndex n_points() const override { return layers_->n_points() + added_.size(); }
  CellIndex n_cells() const override { return layers_->n_cells() + fill_->tetrahedra.size(); }
  std::array<CellIndex, mesh::kNCellTypes> n_cells_by_type() const override;
  std::size_t n_point_batches() const override;
  void read_points(std::size_t batch, mesh::PointBatch& out) const override;
  std::size_t n_cell_batches() const override;
  void read_cells(std::size_t batch, mesh::CellBatch& out) const override;

  /// Node of a point of the fill.
  NodeIndex node(std::uint32_t fill_point) const { return node_[fill_point]; }

 private:
  const mesh::MeshSource* layers_;
  const Fill* fill_;
  std::vector<NodeIndex> node_;       // (n_fill_points)
  std::vector<std::uint32_t> added_;  // points of the fill that no layer has
};

}  // namespace nearwall::volume

#pragma once

#include <span>
#include <vector>

#include "nearwall/mesh/mesh_source.h"
#include "nearwall/mesh/volume_mesh.h"

namespace nearwall::mesh {

/// A volume mesh, or some of its cells, as a mesh source. The mesh must outlive it. Cells carry the mesh's layers,
/// no column or patch (−1), points no line (−1).
class VolumeSource final : public MeshSource {
 public:
  /// All cells and all points.
  explicit VolumeSource(const VolumeMesh& mesh);
  /// The cells of that list (numbers in the mesh), in its order, and the points that they use, in the mesh's order.
  /// Memory: in proportion to the list.
  VolumeSource(const VolumeMesh& mesh, std::span<const CellIndex> cells);

  NodeIndex n_points() const override;
  CellIndex n_cells() const override;
  std::array<CellIndex, kNCellTypes> n_cells_by_type() const override { return n_by_type_; }
  std::size_t n_point_batches() const override;
  void read_points(std::size_t batch, PointBatch& out) const override;
  std::size_t n_cell_batches() const override;
  void read_cells(std::size_t batch, CellBatch& out) const override;

  /// Number of cell i of this source in the mesh, and in the file that the mesh comes from.
  CellIndex mesh_cell(CellIndex i) const { return is_all_ ? i : cells_[i]; }
  CellIndex file_cell(CellIndex i) const { return mesh_->file_cell[mesh_cell(i)]; }

 private:
  NodeIndex mesh_point(NodeIndex i) const { return is_all_ ? i : points_[i]; }
  NodeIndex own_point(std::uint32_t node) const;

  const VolumeMesh* mesh_;
  bool is_all_;
  std::vector<CellIndex> cells_;
  std::vector<std::uint32_t> points_;  ///< ascending
  std::array<CellIndex, kNCellTypes> n_by_type_{};
};

}  // namespace nearwall::mesh

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/mesh/cell.h"
#include "nearwall/mesh/layer_mesh.h"

namespace nearwall::mesh {

/// A run of consecutive cells, as arrays of one entry each.
struct CellBatch {
  CellIndex first = 0;
  std::vector<CellType> type;
  std::vector<std::array<NodeIndex, 8>> nodes;  ///< order of predicates/cells.h; the first size_of(type) are used
  std::vector<std::array<Vec3, 8>> corners;     ///< their coordinates
  std::vector<std::int32_t> layer;              ///< 1 at the wall; 0 outside the layers
  std::vector<std::int64_t> column;             ///< wall triangle; −1 over virtual faces and outside the layers
  std::vector<std::int32_t> patch;              ///< patch of the wall triangle; −1 outside the layers

  std::size_t size() const { return type.size(); }
  void clear();
};

/// A run of consecutive points.
struct PointBatch {
  NodeIndex first = 0;
  std::vector<Vec3> position;
  std::vector<std::int64_t> line;   ///< −1 for points of no line
  std::vector<std::int32_t> level;  ///< 0 at the wall

  std::size_t size() const { return position.size(); }
  void clear();
};

/// A mesh of tetrahedra, pyramids, wedges and hexahedra as writers and the certificate read it: in batches, so that
/// nobody needs the whole of it in memory. Batches may be asked for in any order and on several threads.
class MeshSource {
 public:
  virtual ~MeshSource() = default;
  virtual NodeIndex n_points() const = 0;
  virtual CellIndex n_cells() const = 0;
  virtual std::array<CellIndex, kNCellTypes> n_cells_by_type() const = 0;

  virtual std::size_t n_point_batches() const = 0;
  virtual void read_points(std::size_t batch, PointBatch& out) const = 0;
  virtual std::size_t n_cell_batches() const = 0;
  virtual void read_cells(std::size_t batch, CellBatch& out) const = 0;
};

/// The layers as a mesh source. Points: the wall's vertices first, then line by line, then the apices of the caps;
/// cells: column by column, then the caps.
class LayerSource final : public MeshSource {
 public:
  /// \param face_patch  patch of each wall triangle (n_wall_faces)
  LayerSource(const LayerMesh& layers, const IdVector<FaceId, PatchId>& face_patch, std::span<const Vec3> wall_points);

  NodeIndex n_points() const override { return layers_->n_nodes(); }
  CellIndex n_cells() const override { return layers_->n_cells(); }
  std::array<CellIndex, kNCellTypes> n_cells_by_type() const override { return layers_->n_cells_by_type(); }
  std::size_t n_point_batches() const override;
  void read_points(std::size_t batch, PointBatch& out) const override;
  std::size_t n_cell_batches() const override;
  void read_cells(std::size_t batch, CellBatch& out) const override;

 private:
  std::size_t n_line_batches() const;
  std::size_t n_column_batches() const;
  std::size_t n_cap_batches() const;
  void read_wall(std::size_t batch, PointBatch& out) const;
  void read_lines(std::size_t batch, PointBatch& out) const;
  void read_apices(std::size_t batch, PointBatch& out) const;
  void read_columns(std::size_t batch, CellBatch& out) const;
  void read_caps(std::size_t batch, CellBatch& out) const;

  const LayerMesh* layers_;
  const IdVector<FaceId, PatchId>* face_patch_;
  std::span<const Vec3> wall_points_;
  std::size_t n_vertex_batches_;
};

}  // namespace nearwall::mesh

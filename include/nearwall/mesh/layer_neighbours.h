#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "nearwall/mesh/cell_faces.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/mesh/neighbours.h"

namespace nearwall::mesh {

/// What lies behind a face that no other cell of the columns has: asked for by the face's nodes.
using Beyond = std::function<Neighbour(const FaceNodes& face)>;

/// Neighbours within the columns of a layer mesh, found from the front and the windows of the lines: nothing is stored
/// for cells. Memory: 16 bytes a front face. Cost: O(1) for a cell of a column of wedges, for others O(levels).
/// Source: docs/theory/columns.md
class LayerNeighbours {
 public:
  /// \param layers  must outlive this, with less than 2^32 − 1 nodes
  explicit LayerNeighbours(const LayerMesh& layers);

  /// \param cells   of whole columns one after the other, as a LayerSource gives them; no caps among them
  /// \param beyond  for faces at the wall, on planes and on the front
  void read(const CellBatch& cells, const Beyond& beyond, NeighbourBatch& out) const;

  /// The uppermost cell of a column; nullopt where it has none.
  std::optional<CellIndex> top_cell(FrontFaceId f) const;

 private:
  /// Where a column's cells stand in a batch.
  struct Run {
    const CellBatch& cells;
    FrontFaceId column;
    std::size_t begin, end;
  };
  /// An edge of a front face.
  struct Side {
    FrontFaceId face;
    int edge = 0;
  };

  std::optional<Side> across(Side side) const;
  std::optional<CellIndex> cell_at(FrontFaceId f, Level level) const;
  std::optional<FaceNodes> side_nodes(Side side, Level level) const;
  std::optional<CellIndex> cell_beyond(Side side, Level level) const;
  void read_wedges(const Run& run, const Beyond& beyond, NeighbourBatch& out) const;
  void read_mixed(const Run& run, const Beyond& beyond, NeighbourBatch& out) const;

  const LayerMesh* layers_;
  std::vector<std::array<std::uint32_t, 4>> across_;  // (n_front_faces) 4 face + edge
};

}  // namespace nearwall::mesh

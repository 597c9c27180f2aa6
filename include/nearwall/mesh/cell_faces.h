#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearwall/mesh/cell.h"
#include "nearwall/mesh/volume_mesh.h"

namespace nearwall::mesh {

/// A face of a cell type: places of its corners among the cell's nodes, counterclockwise seen from outside.
struct CellFace {
  std::uint8_t size = 3;
  std::array<std::uint8_t, 4> corners{};  ///< the first `size` are used
};

/// Faces of a cell type, in the node order of predicates/cells.h: 4, 5, 5 and 6 of them.
std::span<const CellFace> cell_faces(CellType type);

/// Names one face of one cell of a volume mesh; in the order of cells, then of `cell_faces`.
class FaceName {
 public:
  FaceName() = default;
  FaceName(std::size_t cell, std::size_t face) : code_(kMaxFaces * cell + face) {}

  std::size_t cell() const { return code_ / kMaxFaces; }
  std::size_t face() const { return code_ % kMaxFaces; }
  friend auto operator<=>(FaceName, FaceName) = default;

 private:
  static constexpr std::uint64_t kMaxFaces = 8;  ///< a power of two, at least 6
  std::uint64_t code_ = 0;
};

/// In place of the fourth corner of a triangle. No mesh has as many points.
inline constexpr std::uint32_t kNoNode = 0xffffffff;

/// Nodes of a face of a cell, counterclockwise seen from outside the cell; kNoNode in the fourth place of a triangle.
using FaceNodes = std::array<std::uint32_t, 4>;

FaceNodes nodes_of(const VolumeMesh& mesh, FaceName face);

constexpr int size_of(const FaceNodes& face) { return face[3] == kNoNode ? 3 : 4; }

/// The same nodes in an order that does not depend on where the cycle begins: the smallest first, then the smaller of
/// its neighbours in the cycle. `is_turned` tells whether the cycle had to be run through backwards for that.
struct FaceKey {
  FaceNodes nodes{};
  bool is_turned = false;
};

FaceKey key_of(const FaceNodes& face);

/// For meshes from outside. \throws InputError  naming the first cell that has a node which the mesh has not
void require_nodes(const VolumeMesh& mesh);

/// All faces of all cells by their smallest node. Memory: 8 bytes a face and a point.
/// Cost: O(n_cells), on all threads; the same whatever their number.
class FaceIndex {
 public:
  /// \throws InputError  as require_nodes
  explicit FaceIndex(const VolumeMesh& mesh);

  std::size_t n_nodes() const { return offset_.size() - 1; }
  /// Faces whose smallest node is this, in increasing order.
  std::span<const FaceName> faces_at(std::size_t node) const {
    return {faces_.data() + offset_[node], faces_.data() + offset_[node + 1]};
  }
  /// The face of another cell over the same nodes as this one, seen from the other side, if there is exactly one.
  /// \returns  the face itself where there is none, or more than one
  FaceName opposite(const VolumeMesh& mesh, FaceName face) const;

 private:
  std::vector<std::uint64_t> offset_;  // (n_points + 1)
  std::vector<FaceName> faces_;        // (n_faces)
};

}  // namespace nearwall::mesh

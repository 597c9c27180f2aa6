#pragma once

#include <cstdint>
#include <vector>

#include "nearwall/mesh/boundary.h"
#include "nearwall/mesh/cell_faces.h"
#include "nearwall/mesh/neighbours.h"
#include "nearwall/mesh/volume_mesh.h"

namespace nearwall::mesh {

/// Faces of a volume mesh that belong to one cell alone and are in no patch become a patch of this name; with a number
/// behind it where the mesh has one of that name.
inline constexpr const char* kUnnamedPatch = "boundary";

/// Faces of a boundary that did not fit.
struct BoundaryChanges {
  std::size_t n_dropped = 0;
  std::size_t n_added = 0;
};

/// Gives a boundary as a file has it the orientation and the completeness that writers expect: faces are turned so that
/// they are counterclockwise seen from outside, those that no cell has, or two cells, or that stand twice, are dropped,
/// those that lack are added as a patch of their own. Cost: O(n log n) in the faces of all cells; memory: 8 bytes each.
BoundaryChanges fit_boundary(const VolumeMesh& mesh, Boundary& boundary);

/// Neighbours in a volume mesh, as the batches of a VolumeSource over all of it. Memory: 24 bytes a cell's face.
/// \pre  the boundary fits (fit_boundary)
class VolumeNeighbours final : public NeighbourSource {
 public:
  /// \throws InputError  if a face belongs to more than two cells, or to two cells on the same side of it
  VolumeNeighbours(const VolumeMesh& mesh, const Boundary& boundary);

  void read_neighbours(std::size_t batch, const CellBatch& cells, NeighbourBatch& out) const override;

 private:
  std::vector<std::uint64_t> first_;  // (n_cells + 1) into behind_
  std::vector<Neighbour> behind_;
};

}  // namespace nearwall::mesh

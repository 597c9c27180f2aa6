#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nearwall/mesh/mesh_source.h"

namespace nearwall::mesh {

/// What lies behind a face of a cell: a cell, by its number, or a face of the boundary.
class Neighbour {
 public:
  Neighbour() = default;
  static Neighbour cell(CellIndex cell) { return Neighbour(static_cast<std::int64_t>(cell)); }
  static Neighbour boundary(std::size_t face) { return Neighbour(-1 - static_cast<std::int64_t>(face)); }

  bool is_cell() const { return code_ >= 0; }
  CellIndex cell() const { return static_cast<CellIndex>(code_); }
  std::size_t boundary_face() const { return static_cast<std::size_t>(-1 - code_); }
  friend bool operator==(Neighbour, Neighbour) = default;

 private:
  explicit Neighbour(std::int64_t code) : code_(code) {}
  std::int64_t code_ = 0;
};

/// For each cell of a batch, behind each of its faces in the order of `cell_faces`; the others are not set.
using NeighbourBatch = std::vector<std::array<Neighbour, 6>>;

/// Which cells of a mesh source meet in a face, in batches, for formats that list faces. Batches may be asked for in
/// any order and on several threads.
class NeighbourSource {
 public:
  virtual ~NeighbourSource() = default;
  /// \param cells  what the mesh source gives for this batch
  virtual void read_neighbours(std::size_t batch, const CellBatch& cells, NeighbourBatch& out) const = 0;
};

}  // namespace nearwall::mesh

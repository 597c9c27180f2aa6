#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "nearwall/mesh/boundary.h"
#include "nearwall/mesh/layer_neighbours.h"
#include "nearwall/volume/hybrid_mesh.h"

namespace nearwall::volume {

class FaceTable;

/// What fills the rest of a mesh.
struct FilledRest {
  const RestBoundary& rest;
  const Fill& fill;
  const HybridMesh& mesh;
};

/// Neighbours in layers, alone or with the tetrahedra that fill the rest. Memory: in proportion to the boundary, the
/// front and the tetrahedra, not to the cells of the layers.
class HybridNeighbours final : public mesh::NeighbourSource {
 public:
  /// \param boundary  every face of the mesh that belongs to one cell alone
  /// \param filled    null: the layers alone
  /// All must outlive this.
  HybridNeighbours(const mesh::LayerMesh& layers, const mesh::Boundary& boundary, const FilledRest* filled);
  ~HybridNeighbours() override;

  void read_neighbours(std::size_t batch, const mesh::CellBatch& cells, mesh::NeighbourBatch& out) const override;

 private:
  struct NodesHash {
    std::size_t operator()(const mesh::FaceNodes& nodes) const;
  };

  void add_caps();
  void add_fill(const FilledRest& filled);
  mesh::Neighbour within_front(FrontFaceId f, const mesh::FaceNodes& triangle) const;
  mesh::Neighbour beyond(const mesh::FaceNodes& face) const;
  void read_caps(const mesh::CellBatch& cells, mesh::NeighbourBatch& out) const;
  void read_tetrahedra(const mesh::CellBatch& cells, mesh::NeighbourBatch& out) const;

  const mesh::LayerMesh* layers_;
  mesh::LayerNeighbours columns_;
  // What lies behind faces of columns and caps, by their nodes: boundary, caps, tetrahedra on the front.
  std::unordered_map<mesh::FaceNodes, mesh::Neighbour, NodesHash> beyond_;
  std::unique_ptr<const FaceTable> tetrahedra_;
  std::vector<mesh::Neighbour> behind_triangle_;  // of the rest's boundary, seen from the tetrahedra
};

}  // namespace nearwall::volume

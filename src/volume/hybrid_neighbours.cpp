#include "nearwall/volume/hybrid_neighbours.h"

#include <algorithm>

#include "nearwall/core/expect.h"
#include "volume/face_table.h"

namespace nearwall::volume {

namespace {

using mesh::FaceNodes;
using mesh::kNoNode;
using mesh::Neighbour;

/// The face of a tetrahedron in a face table, whose faces are numbered by the corner opposite, of each of cell_faces.
constexpr std::array<int, 4> kOppositeCorner = {3, 2, 0, 1};

FaceNodes key(const mesh::BoundaryFace& face) {
  FaceNodes nodes;
  for (std::size_t k = 0; k < 4; ++k) {
    nodes[k] = face[k] == mesh::kNoFourthNode ? kNoNode : static_cast<std::uint32_t>(face[k]);
  }
  return mesh::key_of(nodes).nodes;
}

FaceNodes key_of_triangle(const FilledRest& filled, std::size_t triangle) {
  FaceNodes nodes{0, 0, 0, kNoNode};
  for (std::size_t k = 0; k < 3; ++k) {
    nodes[k] = static_cast<std::uint32_t>(filled.mesh.node(filled.rest.surface.triangles[triangle][k]));
  }
  return mesh::key_of(nodes).nodes;
}

}  // namespace

std::size_t HybridNeighbours::NodesHash::operator()(const FaceNodes& nodes) const {
  // Mixes as a linear congruential generator does (Knuth's multiplier).
  constexpr std::uint64_t kMultiplier = 6364136223846793005;
  std::uint64_t hash = 0;
  for (const std::uint32_t node : nodes) hash = (hash ^ node) * kMultiplier;
  constexpr int kHalf = 32;
  return hash ^ (hash >> kHalf);
}

HybridNeighbours::HybridNeighbours(const mesh::LayerMesh& layers, const mesh::Boundary& boundary,
                                   const FilledRest* filled)
    : layers_(&layers), columns_(layers) {
  beyond_.reserve(boundary.faces.size() + layers.caps().size() + (filled ? filled->rest.n_front : 0));
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) beyond_[key(boundary.faces[f])] = Neighbour::boundary(f);
  if (filled) add_fill(*filled);
  add_caps();
}

HybridNeighbours::~HybridNeighbours() = default;

/// The cell of the layers below a triangle of the front, or the wall where it has none.
Neighbour HybridNeighbours::within_front(FrontFaceId f, const FaceNodes& triangle) const {
  const auto& caps = layers_->caps();
  const auto cap = std::lower_bound(caps.begin(), caps.end(), f);
  if (cap != caps.end() && *cap == f) {
    return Neighbour::cell(layers_->n_cells() - caps.size() + static_cast<CellIndex>(cap - caps.begin()));
  }
  const auto top = columns_.top_cell(f);
  return top ? Neighbour::cell(*top) : beyond(triangle);
}

void HybridNeighbours::add_fill(const FilledRest& filled) {
  tetrahedra_ = std::make_unique<const FaceTable>(filled.fill.points.size(), filled.fill.tetrahedra,
                                                  filled.rest.surface.triangles);
  const std::size_t n_triangles = filled.rest.surface.triangles.size();
  for (std::size_t t = 0; t < n_triangles; ++t) {
    const FaceNodes nodes = key_of_triangle(filled, t);
    behind_triangle_.push_back(t < filled.rest.n_front ? within_front(filled.rest.front_face[t], nodes)
                                                       : beyond(nodes));
  }
  for (std::size_t t = 0; t < filled.fill.tetrahedra.size(); ++t) {
    for (int k = 0; k < 4; ++k) {
      const std::uint32_t triangle = tetrahedra_->beyond(t, k);
      if (!(triangle & FaceTable::kBoundary)) continue;
      const std::size_t on_front = triangle & ~FaceTable::kBoundary;
      if (on_front >= filled.rest.n_front || !behind_triangle_[on_front].is_cell()) continue;
      beyond_[key_of_triangle(filled, on_front)] = Neighbour::cell(layers_->n_cells() + t);
    }
  }
}

void HybridNeighbours::add_caps() {
  const auto& caps = layers_->caps();
  for (std::size_t i = 0; i < caps.size(); ++i) {
    const mesh::Cap cap = *mesh::cap_over(layers_->front(), layers_->lines(), caps[i]);
    FaceNodes base;
    for (std::size_t k = 0; k < 4; ++k) base[k] = static_cast<std::uint32_t>(layers_->node(cap.base[k]));
    beyond_[mesh::key_of(base).nodes] = Neighbour::cell(layers_->n_cells() - caps.size() + i);
  }
}

Neighbour HybridNeighbours::beyond(const FaceNodes& face) const {
  const auto found = beyond_.find(mesh::key_of(face).nodes);
  expect(found != beyond_.end(), "a face of one cell alone to be in the boundary");
  return found->second;
}

void HybridNeighbours::read_caps(const mesh::CellBatch& cells, mesh::NeighbourBatch& out) const {
  out.resize(cells.size());
  const auto faces = mesh::cell_faces(mesh::CellType::Pyramid);
  const CellIndex first_cap = layers_->n_cells() - layers_->caps().size();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const FrontFaceId column = layers_->caps()[cells.first + i - first_cap];
    for (std::size_t k = 0; k < faces.size(); ++k) {
      if (faces[k].size == 4) {
        out[i][k] = Neighbour::cell(columns_.top_cell(column).value());
        continue;
      }
      FaceNodes nodes{0, 0, 0, kNoNode};
      for (std::size_t j = 0; j < 3; ++j) nodes[j] = static_cast<std::uint32_t>(cells.nodes[i][faces[k].corners[j]]);
      out[i][k] = beyond(nodes);
    }
  }
}

void HybridNeighbours::read_tetrahedra(const mesh::CellBatch& cells, mesh::NeighbourBatch& out) const {
  out.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t t = cells.first + i - layers_->n_cells();
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t code = tetrahedra_->beyond(t, kOppositeCorner[k]);
      out[i][k] = code & FaceTable::kBoundary ? behind_triangle_[code & ~FaceTable::kBoundary]
                                              : Neighbour::cell(layers_->n_cells() + code);
    }
  }
}

void HybridNeighbours::read_neighbours(std::size_t, const mesh::CellBatch& cells, mesh::NeighbourBatch& out) const {
  if (cells.size() == 0) return out.clear();
  if (cells.first >= layers_->n_cells()) return read_tetrahedra(cells, out);
  if (cells.first >= layers_->n_cells() - layers_->caps().size()) return read_caps(cells, out);
  columns_.read(
      cells, [&](const FaceNodes& face) { return beyond(face); }, out);
}

}  // namespace nearwall::volume

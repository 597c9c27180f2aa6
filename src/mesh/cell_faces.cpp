#include "nearwall/mesh/cell_faces.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"

namespace nearwall::mesh {

namespace {

constexpr std::array<CellFace, 4> kTetrahedron{{{3, {0, 2, 1}}, {3, {0, 1, 3}}, {3, {1, 2, 3}}, {3, {2, 0, 3}}}};
constexpr std::array<CellFace, 5> kPyramid{
    {{4, {0, 3, 2, 1}}, {3, {0, 1, 4}}, {3, {1, 2, 4}}, {3, {2, 3, 4}}, {3, {3, 0, 4}}}};
constexpr std::array<CellFace, 5> kWedge{
    {{3, {0, 2, 1}}, {3, {3, 4, 5}}, {4, {0, 1, 4, 3}}, {4, {1, 2, 5, 4}}, {4, {2, 0, 3, 5}}}};
constexpr std::array<CellFace, 6> kHexahedron{
    {{4, {0, 3, 2, 1}}, {4, {4, 5, 6, 7}}, {4, {0, 1, 5, 4}}, {4, {1, 2, 6, 5}}, {4, {2, 3, 7, 6}}, {4, {3, 0, 4, 7}}}};

constexpr std::size_t kCellsInBlock = 4096;

/// Calls `visit(smallest node, name)` for all faces, on all threads.
template <class Visit>
void for_each_face(const VolumeMesh& mesh, Visit&& visit) {
  parallel_blocks(mesh.n_cells(), kCellsInBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const auto nodes = mesh.nodes_of(c);
      const auto faces = cell_faces(mesh.type[c]);
      for (std::size_t f = 0; f < faces.size(); ++f) {
        std::uint32_t least = nodes[faces[f].corners[0]];
        for (std::size_t k = 1; k < faces[f].size; ++k) least = std::min(least, nodes[faces[f].corners[k]]);
        visit(least, FaceName(c, f));
      }
    }
  });
}

}  // namespace

void require_nodes(const VolumeMesh& mesh) {
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    for (const std::uint32_t node : mesh.nodes_of(c)) {
      if (node < mesh.points.size()) continue;
      throw InputError("expected nodes 0 to " + std::to_string(mesh.points.size()) + " (exclusive), found node " +
                       std::to_string(node) + " in cell " + std::to_string(mesh.file_cell[c]));
    }
  }
}

std::span<const CellFace> cell_faces(CellType type) {
  switch (type) {
    case CellType::Tetrahedron:
      return kTetrahedron;
    case CellType::Pyramid:
      return kPyramid;
    case CellType::Wedge:
      return kWedge;
    case CellType::Hexahedron:
      return kHexahedron;
  }
  return {};
}

FaceNodes nodes_of(const VolumeMesh& mesh, FaceName face) {
  const CellFace& local = cell_faces(mesh.type[face.cell()])[face.face()];
  const auto nodes = mesh.nodes_of(face.cell());
  return {nodes[local.corners[0]], nodes[local.corners[1]], nodes[local.corners[2]],
          local.size == 4 ? nodes[local.corners[3]] : kNoNode};
}

FaceKey key_of(const FaceNodes& face) {
  const auto n = static_cast<std::size_t>(size_of(face));
  std::size_t first = 0;
  for (std::size_t k = 1; k < n; ++k) {
    if (face[k] < face[first]) first = k;
  }
  const auto at = [&](std::size_t k) { return face[(first + k) % n]; };
  FaceKey key;
  key.is_turned = at(n - 1) < at(1);
  key.nodes = key.is_turned ? FaceNodes{at(0), at(n - 1), at(n - 2), at(n - 3)} : FaceNodes{at(0), at(1), at(2), at(3)};
  if (n == 3) key.nodes[3] = kNoNode;
  return key;
}

FaceIndex::FaceIndex(const VolumeMesh& mesh) : offset_(mesh.points.size() + 1, 0) {
  require_nodes(mesh);
  for_each_face(mesh, [&](std::uint32_t least, FaceName) {
    std::atomic_ref(offset_[least]).fetch_add(1, std::memory_order_relaxed);
  });
  // Ends first: filling from behind turns them into beginnings.
  for (std::size_t i = 1; i < offset_.size(); ++i) offset_[i] += offset_[i - 1];
  faces_.resize(offset_.back());
  for_each_face(mesh, [&](std::uint32_t least, FaceName name) {
    faces_[std::atomic_ref(offset_[least]).fetch_sub(1, std::memory_order_relaxed) - 1] = name;
  });
  parallel_for(n_nodes(), [&](std::size_t node) {
    std::sort(faces_.begin() + static_cast<std::ptrdiff_t>(offset_[node]),
              faces_.begin() + static_cast<std::ptrdiff_t>(offset_[node + 1]));
  });
}

FaceName FaceIndex::opposite(const VolumeMesh& mesh, FaceName face) const {
  const FaceKey key = key_of(nodes_of(mesh, face));
  FaceName found = face;
  for (const FaceName other : faces_at(key.nodes[0])) {
    if (other == face) continue;
    const FaceKey other_key = key_of(nodes_of(mesh, other));
    if (other_key.nodes != key.nodes) continue;
    if (found != face || other_key.is_turned == key.is_turned) return face;
    found = other;
  }
  return found;
}

}  // namespace nearwall::mesh

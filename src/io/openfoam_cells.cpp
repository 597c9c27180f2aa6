#include "io/openfoam_cells.h"

#include <algorithm>

namespace nearwall::io {
namespace {

using mesh::CellType;
using mesh::FaceKey;
using mesh::FaceNodes;

bool has(const FaceNodes& face, std::uint32_t node) {
  return std::find(face.begin(), face.begin() + mesh::size_of(face), node) != face.begin() + mesh::size_of(face);
}

std::uint32_t smallest(const FaceNodes& face) { return *std::min_element(face.begin(), face.end()); }

std::optional<CellType> type_of(std::span<const FaceNodes> faces) {
  const auto n_quads =
      std::count_if(faces.begin(), faces.end(), [](const FaceNodes& face) { return mesh::size_of(face) == 4; });
  if (faces.size() == 4 && n_quads == 0) return CellType::Tetrahedron;
  if (faces.size() == 5 && n_quads == 1) return CellType::Pyramid;
  if (faces.size() == 5 && n_quads == 3) return CellType::Wedge;
  if (faces.size() == 6 && n_quads == 6) return CellType::Hexahedron;
  return std::nullopt;
}

/// Which face becomes the bottom: of a pyramid the quad, of others that with the smallest node, of a wedge a triangle.
std::size_t bottom_of(CellType type, std::span<const FaceNodes> faces) {
  const int size = type == CellType::Tetrahedron || type == CellType::Wedge ? 3 : 4;
  std::size_t bottom = faces.size();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (mesh::size_of(faces[f]) != size) continue;
    if (bottom == faces.size() || smallest(faces[f]) < smallest(faces[bottom])) bottom = f;
  }
  return bottom;
}

/// The node at the other end of the edge that leaves the bottom at that node; the node itself if there is none.
std::uint32_t above(std::uint32_t node, std::span<const FaceNodes> faces, const FaceNodes& bottom) {
  for (const FaceNodes& face : faces) {
    const auto n = static_cast<std::size_t>(mesh::size_of(face));
    for (std::size_t k = 0; k < n; ++k) {
      if (face[k] != node) continue;
      for (const std::uint32_t other : {face[(k + 1) % n], face[(k + n - 1) % n]}) {
        if (!has(bottom, other)) return other;
      }
    }
  }
  return node;
}

FacedCell candidate(CellType type, std::span<const FaceNodes> faces) {
  const FaceNodes& bottom = faces[bottom_of(type, faces)];
  const auto n = static_cast<std::size_t>(mesh::size_of(bottom));
  FacedCell cell;
  cell.type = type;
  // Seen from the top, a face that is counterclockwise from outside runs the other way round.
  const std::size_t first = static_cast<std::size_t>(std::min_element(bottom.begin(), bottom.end()) - bottom.begin());
  for (std::size_t k = 0; k < n; ++k) cell.nodes[k] = bottom[(first + n - k) % n];
  const auto n_top = static_cast<std::size_t>(mesh::size_of(type)) - n;
  for (std::size_t k = 0; k < n_top; ++k) cell.nodes[n + k] = above(cell.nodes[k], faces, bottom);
  return cell;
}

bool has_equal_nodes(const FacedCell& cell) {
  const auto begin = cell.nodes.begin(), end = begin + mesh::size_of(cell.type);
  for (auto node = begin; node != end; ++node) {
    if (std::find(begin, node, *node) != node) return true;
  }
  return false;
}

FaceKey key_of(const FacedCell& cell, const mesh::CellFace& face) {
  FaceNodes nodes;
  for (std::size_t k = 0; k < 4; ++k) nodes[k] = k < face.size ? cell.nodes[face.corners[k]] : mesh::kNoNode;
  return mesh::key_of(nodes);
}

}  // namespace

std::optional<FacedCell> cell_of(std::span<const FaceNodes> faces, bool& is_closed) {
  is_closed = true;
  const auto type = type_of(faces);
  if (!type) return std::nullopt;
  const FacedCell cell = candidate(*type, faces);
  if (has_equal_nodes(cell)) return std::nullopt;
  // The faces are all different, so as many as the cell's are the cell's if each of those is among them.
  for (const mesh::CellFace& expected : mesh::cell_faces(*type)) {
    const FaceKey key = key_of(cell, expected);
    const auto found = std::find_if(faces.begin(), faces.end(),
                                    [&](const FaceNodes& face) { return mesh::key_of(face).nodes == key.nodes; });
    if (found == faces.end()) return std::nullopt;
    if (mesh::key_of(*found).is_turned != key.is_turned) is_closed = false;
  }
  return cell;
}

}  // namespace nearwall::io

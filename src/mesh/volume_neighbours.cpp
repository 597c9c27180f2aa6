#include "nearwall/mesh/volume_neighbours.h"

#include <algorithm>
#include <string>
#include <utility>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"

namespace nearwall::mesh {

namespace {

/// Faces over the same nodes: of cells, or of the boundary.
struct KeyedFace {
  FaceKey key;
  FaceName face;

  friend bool operator<(const KeyedFace& a, const KeyedFace& b) {
    return a.key.nodes != b.key.nodes ? a.key.nodes < b.key.nodes : a.face < b.face;
  }
};

/// Calls visit(faces over the same nodes) for all faces with that smallest node.
template <class Visit>
void for_each_group(const VolumeMesh& mesh, const FaceIndex& index, std::size_t node, std::vector<KeyedFace>& keyed,
                    Visit&& visit) {
  keyed.clear();
  for (const FaceName face : index.faces_at(node)) keyed.push_back({key_of(nodes_of(mesh, face)), face});
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t begin = 0, end = 0; begin < keyed.size(); begin = end) {
    while (end < keyed.size() && keyed[end].key.nodes == keyed[begin].key.nodes) ++end;
    visit(std::span<const KeyedFace>(keyed.data() + begin, end - begin));
  }
}

FaceNodes nodes_of(const BoundaryFace& face) {
  FaceNodes nodes;
  for (std::size_t k = 0; k < 4; ++k)
    nodes[k] = face[k] == kNoFourthNode ? kNoNode : static_cast<std::uint32_t>(face[k]);
  return nodes;
}

BoundaryFace boundary_face(const FaceNodes& nodes) {
  return {nodes[0], nodes[1], nodes[2], nodes[3] == kNoNode ? kNoFourthNode : NodeIndex{nodes[3]}};
}

using NumberedFace = std::pair<FaceNodes, std::uint32_t>;

/// Faces of a boundary by their nodes, for finding them.
std::vector<NumberedFace> by_nodes(const Boundary& boundary) {
  std::vector<NumberedFace> faces;
  faces.reserve(boundary.faces.size());
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    faces.emplace_back(key_of(nodes_of(boundary.faces[f])).nodes, static_cast<std::uint32_t>(f));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The first boundary face over these nodes; null if there is none.
const NumberedFace* find(const std::vector<NumberedFace>& faces, const FaceNodes& nodes) {
  const auto found = std::lower_bound(faces.begin(), faces.end(), NumberedFace{nodes, 0});
  return found != faces.end() && found->first == nodes ? &*found : nullptr;
}

/// A patch of its own for faces without a name.
PatchId add_unnamed_patch(Boundary& boundary) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(boundary.patches.begin(), boundary.patches.end(),
                       [&](const BoundaryPatch& patch) { return patch.name == name; });
  };
  std::string name = kUnnamedPatch;
  for (int i = 2; is_taken(name); ++i) name = kUnnamedPatch + std::to_string(i);
  return boundary.patches.push_back({name, BoundaryType::Other});
}

}  // namespace

BoundaryChanges fit_boundary(const VolumeMesh& mesh, Boundary& boundary) {
  const FaceIndex index(mesh);
  const std::vector<NumberedFace> given = by_nodes(boundary);
  // The cell's face that each face of the boundary is; and those of cells alone that no patch has.
  std::vector<FaceName> face(boundary.faces.size());
  std::vector<char> is_kept(boundary.faces.size(), 0);
  std::vector<FaceName> missing;
  std::vector<KeyedFace> keyed;
  for (std::size_t node = 0; node < index.n_nodes(); ++node) {
    for_each_group(mesh, index, node, keyed, [&](std::span<const KeyedFace> group) {
      if (group.size() != 1) return;
      if (const NumberedFace* found = find(given, group[0].key.nodes)) {
        face[found->second] = group[0].face;
        is_kept[found->second] = 1;
      } else {
        missing.push_back(group[0].face);
      }
    });
  }
  BoundaryChanges changes;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    if (!is_kept[f]) continue;
    boundary.faces[kept] = boundary_face(nodes_of(mesh, face[f]));
    boundary.patch[kept++] = boundary.patch[f];
  }
  changes.n_dropped = boundary.faces.size() - kept;
  boundary.faces.resize(kept);
  boundary.patch.resize(kept);
  if (missing.empty()) return changes;
  std::sort(missing.begin(), missing.end());
  const PatchId patch = add_unnamed_patch(boundary);
  for (const FaceName name : missing) {
    boundary.faces.push_back(boundary_face(nodes_of(mesh, name)));
    boundary.patch.push_back(patch);
  }
  changes.n_added = missing.size();
  return changes;
}

VolumeNeighbours::VolumeNeighbours(const VolumeMesh& mesh, const Boundary& boundary) : first_(mesh.n_cells() + 1, 0) {
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) first_[c + 1] = first_[c] + cell_faces(mesh.type[c]).size();
  behind_.resize(first_.back());
  const FaceIndex index(mesh);
  const std::vector<NumberedFace> given = by_nodes(boundary);
  const auto at = [&](FaceName name) -> Neighbour& { return behind_[first_[name.cell()] + name.face()]; };
  constexpr std::size_t kNodesInBlock = 4096;
  parallel_blocks(index.n_nodes(), kNodesInBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<KeyedFace> keyed;
    for (std::size_t node = begin; node < end; ++node) {
      for_each_group(mesh, index, node, keyed, [&](std::span<const KeyedFace> group) {
        if (group.size() == 1) {
          const NumberedFace* found = find(given, group[0].key.nodes);
          expect(found != nullptr, "every face of one cell alone to be in the boundary");
          at(group[0].face) = Neighbour::boundary(found->second);
          return;
        }
        if (group.size() != 2 || group[0].key.is_turned == group[1].key.is_turned) {
          throw InputError("a face of cell " + std::to_string(mesh.file_cell[group[0].face.cell()]) +
                           " is also one of " + std::to_string(group.size() - 1) +
                           " other cell(s), not on its other side: the mesh is not " +
                           "conforming; `nearwall certify` names all such faces");
        }
        at(group[0].face) = Neighbour::cell(group[1].face.cell());
        at(group[1].face) = Neighbour::cell(group[0].face.cell());
      });
    }
  });
}

void VolumeNeighbours::read_neighbours(std::size_t, const CellBatch& cells, NeighbourBatch& out) const {
  out.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::uint64_t begin = first_[cells.first + i], end = first_[cells.first + i + 1];
    for (std::uint64_t k = begin; k < end; ++k) out[i][k - begin] = behind_[k];
  }
}

}  // namespace nearwall::mesh

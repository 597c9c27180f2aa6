#include "nearwall/mesh/volume_neighbours.h"

#include <gtest/gtest.h>

#include <set>

#include "nearwall/core/errors.h"
#include "nearwall/mesh/volume_source.h"
#include "tests/support/volume_meshes.h"

namespace nearwall::mesh {
namespace {

using namespace volume_meshes_for_tests;

FaceNodes behind(const VolumeMesh& mesh, const Boundary& boundary, Neighbour neighbour, const FaceKey& key) {
  if (!neighbour.is_cell()) {
    FaceNodes nodes;
    const BoundaryFace& face = boundary.faces[neighbour.boundary_face()];
    for (std::size_t k = 0; k < 4; ++k) nodes[k] = static_cast<std::uint32_t>(face[k]);
    return key_of(nodes).nodes;
  }
  for (std::size_t f = 0; f < cell_faces(mesh.type[neighbour.cell()]).size(); ++f) {
    const FaceKey other = key_of(nodes_of(mesh, FaceName(neighbour.cell(), f)));
    if (other.nodes == key.nodes && other.is_turned != key.is_turned) return other.nodes;
  }
  return {};
}

/// Every face of every cell has behind it what has the same nodes: a cell that sees it from the other side, or a face
/// of the boundary, and each of these once.
void expect_neighbours(const VolumeMesh& mesh, const Boundary& boundary) {
  const VolumeSource source(mesh);
  const VolumeNeighbours neighbours(mesh, boundary);
  std::set<std::size_t> seen;
  CellBatch cells;
  NeighbourBatch all;
  for (std::size_t b = 0; b < source.n_cell_batches(); ++b) {
    source.read_cells(b, cells);
    neighbours.read_neighbours(b, cells, all);
    ASSERT_EQ(all.size(), cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      for (std::size_t f = 0; f < cell_faces(cells.type[c]).size(); ++f) {
        const FaceKey key = key_of(nodes_of(mesh, FaceName(cells.first + c, f)));
        EXPECT_EQ(behind(mesh, boundary, all[c][f], key), key.nodes);
        if (!all[c][f].is_cell()) {
          EXPECT_TRUE(seen.insert(all[c][f].boundary_face()).second);
        }
      }
    }
  }
  EXPECT_EQ(seen.size(), boundary.faces.size());
}

TEST(FitBoundary, GivesAMeshWithoutPatchesOne) {
  const VolumeMesh mesh = block(3, as_tetrahedra());
  Boundary boundary;
  const BoundaryChanges changes = fit_boundary(mesh, boundary);
  EXPECT_EQ(changes.n_added, 6u * 9 * 2);
  EXPECT_EQ(changes.n_dropped, 0u);
  ASSERT_EQ(boundary.patches.size(), 1u);
  EXPECT_EQ(boundary.patches[PatchId(0)].name, kUnnamedPatch);
  expect_neighbours(mesh, boundary);
}

TEST(FitBoundary, TurnsFacesOutwardsAndDropsThoseWithin) {
  const VolumeMesh mesh = block(2, as_hexahedron());
  Boundary boundary;
  const PatchId named = boundary.patches.push_back({"boundary", BoundaryType::Wall});
  const auto add = [&](std::array<std::uint32_t, 4> n) {
    boundary.faces.push_back({n[0], n[1], n[2], n[3]});
    boundary.patch.push_back(named);
  };
  // On z = 0, seen from above: clockwise from outside; once more the other way round; and one on z = 1/2, within.
  add({block_node(2, 0, 0, 0), block_node(2, 1, 0, 0), block_node(2, 1, 1, 0), block_node(2, 0, 1, 0)});
  add({block_node(2, 0, 0, 0), block_node(2, 0, 1, 0), block_node(2, 1, 1, 0), block_node(2, 1, 0, 0)});
  add({block_node(2, 0, 0, 1), block_node(2, 1, 0, 1), block_node(2, 1, 1, 1), block_node(2, 0, 1, 1)});
  const BoundaryChanges changes = fit_boundary(mesh, boundary);
  EXPECT_EQ(changes.n_dropped, 2u);
  EXPECT_EQ(changes.n_added, 23u);
  ASSERT_EQ(boundary.patches.size(), 2u);
  EXPECT_EQ(boundary.patches[PatchId(1)].name, "boundary2");
  EXPECT_EQ(boundary.patch[0], named);
  const auto& f = boundary.faces[0];
  const Vec3 normal = cross(mesh.points[f[1]] - mesh.points[f[0]], mesh.points[f[2]] - mesh.points[f[0]]);
  EXPECT_LT(normal.z(), 0);
  expect_neighbours(mesh, boundary);
}

TEST(VolumeNeighbours, KnowPyramidsAndWedges) {
  for (const VolumeMesh& mesh : {six_pyramids(), block(3, as_wedges()), five_tetrahedra()}) {
    Boundary boundary;
    fit_boundary(mesh, boundary);
    expect_neighbours(mesh, boundary);
  }
}

TEST(VolumeNeighbours, RefusesAFaceOfThreeCells) {
  VolumeMesh mesh = block(1, as_tetrahedra());
  const auto nodes = mesh.nodes_of(0);
  add_cell(mesh, CellType::Tetrahedron, {nodes.begin(), nodes.end()});
  Boundary boundary;
  fit_boundary(mesh, boundary);
  EXPECT_THROW(VolumeNeighbours(mesh, boundary), InputError);
}

}  // namespace
}  // namespace nearwall::mesh

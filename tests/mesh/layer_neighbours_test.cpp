#include "nearwall/mesh/layer_neighbours.h"

#include <gtest/gtest.h>

#include <map>

#include "nearwall/mesh/volume_neighbours.h"
#include "tests/mesh/small_layers.h"
#include "tests/support/volume_meshes.h"

namespace nearwall::mesh {
namespace {

/// A layer mesh, once as columns and once as a mesh of which nothing but nodes is known.
class BothWays {
 public:
  explicit BothWays(const Layers& layers)
      : layers_(layers.front, layers.lines),
        source_(layers_, layers.wall.face_patch, layers.wall.points.raw()),
        volume_(volume_meshes_for_tests::read(source_)) {
    fit_boundary(volume_, boundary_);
  }

  void expect_same() const {
    const VolumeNeighbours expected(volume_, boundary_);
    const LayerNeighbours neighbours(layers_);
    const auto faces = faces_beyond(expected);
    CellBatch cells;
    NeighbourBatch found, all;
    for (std::size_t b = 0; b < source_.n_cell_batches(); ++b) {
      source_.read_cells(b, cells);
      if (cells.size() == 0 || cells.first >= n_in_columns()) continue;
      neighbours.read(
          cells, [&](const FaceNodes& face) { return faces.at(key_of(face).nodes); }, found);
      expected.read_neighbours(b, cells, all);
      for (std::size_t c = 0; c < cells.size(); ++c) {
        for (std::size_t f = 0; f < cell_faces(cells.type[c]).size(); ++f) EXPECT_EQ(found[c][f], all[c][f]);
      }
    }
  }

 private:
  CellIndex n_in_columns() const { return layers_.n_cells() - layers_.caps().size(); }

  /// Faces that lie on the boundary or under a cap: the only ones that may be asked for.
  std::map<FaceNodes, Neighbour> faces_beyond(const VolumeNeighbours& expected) const {
    std::map<FaceNodes, Neighbour> faces;
    CellBatch cell;
    NeighbourBatch behind;
    for (CellIndex c = 0; c < layers_.n_cells(); ++c) {
      cell.clear();
      cell.first = c;
      cell.type.push_back(volume_.type[c]);
      expected.read_neighbours(0, cell, behind);
      for (std::size_t f = 0; f < cell_faces(volume_.type[c]).size(); ++f) {
        const Neighbour n = behind[0][f];
        const FaceNodes nodes = key_of(nodes_of(volume_, FaceName(c, f))).nodes;
        if (!n.is_cell() || n.cell() >= n_in_columns()) faces[nodes] = n;
      }
    }
    return faces;
  }

  LayerMesh layers_;
  LayerSource source_;
  VolumeMesh volume_;
  Boundary boundary_;
};

void expect_same_whatever_the_windows(Layers layers, bool late_starts) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    if (trial > 0) randomise_windows(layers, random, late_starts);
    BothWays(layers).expect_same();
    if (testing::Test::HasFailure()) FAIL() << "first at trial " << trial;
  }
}

TEST(LayerNeighbours, AreThoseOfTheMeshWhateverTheWindows) {
  expect_same_whatever_the_windows(plain_cube(), false);
  expect_same_whatever_the_windows(plain_cube(), true);
}

TEST(LayerNeighbours, AreThoseOfTheMeshOverVirtualQuads) {
  expect_same_whatever_the_windows(cube_with_two_lines_round_its_top(), false);
}

TEST(LayerNeighbours, NameTheUppermostCell) {
  Layers layers = plain_cube();
  for (const VertexId v : layers.wall.faces[FaceId(0)]) layers.lines.windows[LineId(v.index())] = {0, 0};
  const LayerMesh mesh(layers.front, layers.lines);
  const LayerNeighbours neighbours(mesh);
  EXPECT_FALSE(neighbours.top_cell(FrontFaceId(0)));
  for (const FrontFaceId f : layers.front.faces.ids()) {
    if (const auto top = neighbours.top_cell(f)) {
      EXPECT_EQ(*top + 1, mesh.column_end(f));
    }
  }
}

}  // namespace
}  // namespace nearwall::mesh

#include "nearwall/mesh/layer_mesh.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace nearwall::mesh {
namespace {

/// A cube with four levels on plain lines along z, which is all that counting needs.
struct Stack {
  SurfaceMesh wall = shapes_for_tests::cube();
  Front front = plain_front(wall);
  Lines lines;

  Stack() {
    lines.table = HeightTable({{0, 1, 2, 3, 4}});
    for (const Vec3& p : wall.points) {
      lines.first_piece.push_back(static_cast<std::uint32_t>(lines.base.size()));
      lines.base.push_back(p);
      lines.pieces.push_back({{0, 0, 1}, 0});
      lines.heights.push_back({});
      lines.windows.push_back({0, 4});
    }
    lines.first_piece.push_back(static_cast<std::uint32_t>(lines.base.size()));
  }
};

TEST(LayerMesh, CountsWhatTheoryCounts) {
  const Stack s;
  const LayerMesh mesh(s.front, s.lines);
  EXPECT_EQ(mesh.n_cells(), 4 * s.wall.faces.size());
  EXPECT_EQ(mesh.n_nodes(), 5 * s.wall.points.size());
  EXPECT_EQ(mesh.n_cells_by_type()[static_cast<std::size_t>(CellType::Wedge)], mesh.n_cells());
}

TEST(LayerMesh, NumbersEveryNodeOnceAndTheWallFirst) {
  Stack s;
  s.lines.windows[LineId(2)] = {0, 0};
  s.lines.windows[LineId(3)] = {1, 3};
  const LayerMesh mesh(s.front, s.lines);
  std::set<NodeIndex> nodes;
  for (const LineId line : s.front.line_vertex.ids()) {
    EXPECT_EQ(mesh.node(line, 0), line.index());
    for (Level j = 0; j <= 4; ++j) nodes.insert(mesh.node(line, j));
  }
  EXPECT_EQ(nodes.size(), mesh.n_nodes());
  EXPECT_EQ(*nodes.rbegin() + 1, mesh.n_nodes());
  EXPECT_EQ(mesh.n_nodes(), 5 * s.wall.points.size() - 4 - 2);
  EXPECT_EQ(mesh.node(LineId(2), 4), 2u) << "a blocked line has its wall vertex only";
  EXPECT_EQ(mesh.node(LineId(3), 1), 3u) << "a late line is at the wall at level 1";
  EXPECT_EQ(mesh.node(LineId(3), 4), mesh.node(LineId(3), 3));
}

TEST(LayerMesh, HasNoCellsWhereNothingMoves) {
  Stack s;
  for (Window& w : s.lines.windows) w = {0, 0};
  const LayerMesh mesh(s.front, s.lines);
  EXPECT_EQ(mesh.n_cells(), 0u);
  EXPECT_EQ(mesh.n_nodes(), s.wall.points.size());
}

}  // namespace
}  // namespace nearwall::mesh

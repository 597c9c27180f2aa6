#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/predicates/cells.h"
#include "tests/mesh/cell_faces.h"
#include "tests/mesh/small_layers.h"

// The one rule of columns, tried on whole fronts with random windows: whatever the windows are, cells fit face to face,
// what is left over is wall and front, and every cell is positive where the lines are short.

namespace nearwall::mesh {
namespace {

using namespace shapes_for_tests;
using predicates::Positivity;

Positivity positivity(const Layers& layers, const LayerCell& cell) {
  std::array<Vec3, 8> p;
  for (std::size_t k = 0; k < 8; ++k) {
    if (cell.nodes[k].line.is_valid()) p[k] = layers.lines.position(cell.nodes[k].line, cell.nodes[k].level);
  }
  const std::span<const Vec3, 8> all(p);
  switch (cell.type) {
    case CellType::Tetrahedron:
      return predicates::tetrahedron(all.first<4>());
    case CellType::Pyramid:
      return predicates::pyramid(all.first<5>());
    case CellType::Wedge:
      return predicates::wedge(all.first<6>());
    case CellType::Hexahedron:
      return predicates::hexahedron(all);
  }
  return Positivity::Undecided;
}

/// Nodes of a front face at the wall or at the ends of its lines, repeats dropped, counterclockwise seen from the
/// fluid.
NodeCycle outline(const LayerMesh& mesh, FrontFaceId f, bool at_the_ends) {
  NodeCycle cycle;
  const FrontFace& face = mesh.front().faces[f];
  for (int k = 0; k < face.size(); ++k) {
    const LineId line = face.lines[static_cast<std::size_t>(k)];
    const NodeIndex node = mesh.node(line, at_the_ends ? mesh.lines().windows[line].end : Level{0});
    if (std::find(cycle.begin(), cycle.end(), node) == cycle.end()) cycle.push_back(node);
  }
  return canonical(cycle);
}

/// Every face of a cell is shared by two cells that see it from opposite sides, or lies on the wall or the front.
void expect_conforming(const LayerMesh& mesh) {
  auto faces = oriented_faces(mesh);
  std::map<NodeCycle, int> boundary;
  for (const FrontFaceId f : mesh.front().faces.ids()) {
    if (mesh.column_offset(f) == mesh.column_end(f)) continue;
    if (mesh.front().is_wall(f)) ++boundary[reversed(outline(mesh, f, false))];
    if (outline(mesh, f, true).size() > 2) ++boundary[outline(mesh, f, true)];
  }
  for (const auto& [face, count] : faces) {
    ASSERT_EQ(count, 1) << "two cells see one face from the same side";
    const auto other = faces.find(reversed(face));
    const bool is_on_boundary = boundary.contains(face);
    EXPECT_NE(other != faces.end(), is_on_boundary);
    if (is_on_boundary) --boundary[face];
  }
  // Where a virtual column has cells only between windows that end alike, its outline may lie within the mesh.
  for (const auto& [face, count] : boundary) EXPECT_LE(count, face.size() == 4 ? 1 : 0);
}

void expect_sound(Layers& layers, bool late_starts) {
  std::mt19937 random(11);
  std::array<CellIndex, kNCellTypes> seen{};
  for (int trial = 0; trial < 300; ++trial) {
    if (trial > 0) randomise_windows(layers, random, late_starts);
    const LayerMesh mesh(layers.front, layers.lines);
    expect_conforming(mesh);
    CellIndex n = 0;
    for (const FrontFaceId f : layers.front.faces.ids()) {
      mesh.for_each_cell(f, [&](const LayerCell& cell, Level) {
        ++n;
        ++seen[static_cast<std::size_t>(cell.type)];
        EXPECT_EQ(positivity(layers, cell), Positivity::Positive)
            << kCellTypeNames[static_cast<std::size_t>(cell.type)];
      });
      EXPECT_EQ(mesh.column_end(f), n);
    }
    EXPECT_EQ(mesh.n_cells(), n + mesh.caps().size());
    if (testing::Test::HasFailure()) FAIL() << "first at trial " << trial;
  }
  EXPECT_GT(seen[0], 0u);
  EXPECT_GT(seen[1], 0u);
  EXPECT_GT(seen[2], 0u);
}

TEST(ColumnCell, FitsFaceToFaceWhateverTheWindows) {
  Layers layers = plain_cube();
  expect_sound(layers, false);
}

TEST(ColumnCell, FitsFaceToFaceWithLateStarts) {
  Layers layers = plain_cube();
  expect_sound(layers, true);
}

TEST(ColumnCell, FitsFaceToFaceOverVirtualQuads) {
  Layers layers = cube_with_two_lines_round_its_top();
  const LayerMesh full(layers.front, layers.lines);
  EXPECT_EQ(full.n_cells_by_type()[static_cast<std::size_t>(CellType::Hexahedron)],
            2 * (layers.front.faces.size() - layers.front.n_wall_faces));
  expect_sound(layers, false);
}

TEST(ColumnCell, MakesATetrahedronWhereTheLinesOfACornerPart) {
  Layers layers;
  layers.wall = make_surface({{0, 0, 0}}, {});
  layers.front.first_line = {0};
  for (const Vec3& d : {Vec3(1, 0, 1), Vec3(0, 1, 1), Vec3(-1, -1, 1)}) add_line(layers, VertexId(0), d);
  finish(layers, 3);
  layers.front.faces.push_back({{LineId(0), LineId(1), LineId(2), {}}});
  const LayerMesh mesh(layers.front, layers.lines);
  EXPECT_EQ(mesh.n_cells_by_type(), (std::array<CellIndex, kNCellTypes>{1, 0, 2, 0}));
  mesh.for_each_cell(FrontFaceId(0),
                     [&](const LayerCell& cell, Level) { EXPECT_EQ(positivity(layers, cell), Positivity::Positive); });
}

TEST(ColumnCell, MakesNoneWhereOnlyTheLoneLineOfAFansEndMoves) {
  Layers layers;
  layers.wall = make_surface({{0, 0, 0}, {1, 0, 0}}, {});
  layers.front.first_line = {0, 1};
  for (const int v : {0, 1, 1}) add_line(layers, VertexId(static_cast<std::size_t>(v)), {0, 0, 1});
  finish(layers, 3);
  layers.lines.windows[LineId(1)] = layers.lines.windows[LineId(2)] = {0, 0};
  layers.front.faces.push_back({{LineId(0), LineId(1), LineId(2), {}}});
  EXPECT_EQ(LayerMesh(layers.front, layers.lines).n_cells(), 0u);
}

TEST(ColumnCell, MakesATetrahedronAndWedgesWhereAFanEnds) {
  Layers layers;
  layers.wall = make_surface({{0, 0, 0}, {1, 0, 0}}, {});
  layers.front.first_line = {0, 1};
  add_line(layers, VertexId(0), {0, 0, 1});
  add_line(layers, VertexId(1), {0, -0.5, 1});
  add_line(layers, VertexId(1), {0, 0.5, 1});
  finish(layers, 3);
  layers.lines.windows[LineId(0)].start = 1;  // the lone line starts late
  layers.front.faces.push_back({{LineId(0), LineId(1), LineId(2), {}}});
  const LayerMesh mesh(layers.front, layers.lines);
  EXPECT_EQ(mesh.n_cells_by_type(), (std::array<CellIndex, kNCellTypes>{1, 0, 2, 0}));
  mesh.for_each_cell(FrontFaceId(0),
                     [&](const LayerCell& cell, Level) { EXPECT_EQ(positivity(layers, cell), Positivity::Positive); });
}

}  // namespace
}  // namespace nearwall::mesh

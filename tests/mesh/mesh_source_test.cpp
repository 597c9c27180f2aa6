#include "nearwall/mesh/mesh_source.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace nearwall::mesh {
namespace {

/// An icosphere with radial lines, windows of all kinds.
struct Shell {
  SurfaceMesh wall = shapes_for_tests::sphere(3);
  Front front = plain_front(wall);
  Lines lines;

  Shell() {
    lines.table = HeightTable({{0, 0.01, 0.02, 0.04}});
    for (const Vec3& p : wall.points) {
      lines.first_piece.push_back(static_cast<std::uint32_t>(lines.base.size()));
      lines.base.push_back(p);
      lines.pieces.push_back({p, 0});
      lines.heights.push_back({});
      lines.windows.push_back({0, static_cast<Level>(lines.base.size() % 4)});
    }
    lines.first_piece.push_back(static_cast<std::uint32_t>(lines.base.size()));
  }
};

TEST(LayerSource, YieldsEveryPointOnceInOrder) {
  const Shell s;
  const LayerMesh layers(s.front, s.lines);
  const LayerSource source(layers, s.wall.face_patch, s.wall.points.raw());
  NodeIndex next = 0;
  PointBatch batch;
  for (std::size_t b = 0; b < source.n_point_batches(); ++b) {
    source.read_points(b, batch);
    if (batch.size() == 0) continue;
    EXPECT_EQ(batch.first, next);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      const LineId line(static_cast<std::size_t>(batch.line[k]));
      const auto level = static_cast<Level>(batch.level[k]);
      EXPECT_EQ(layers.node(line, level), next + k);
      EXPECT_EQ(batch.position[k], s.lines.position(line, level));
    }
    next += batch.size();
  }
  EXPECT_EQ(next, source.n_points());
}

TEST(LayerSource, YieldsEveryCellOnceWithThePointsItNames) {
  const Shell s;
  const LayerMesh layers(s.front, s.lines);
  const LayerSource source(layers, s.wall.face_patch, s.wall.points.raw());
  std::vector<Vec3> points;
  PointBatch point_batch;
  for (std::size_t b = 0; b < source.n_point_batches(); ++b) {
    source.read_points(b, point_batch);
    points.insert(points.end(), point_batch.position.begin(), point_batch.position.end());
  }
  CellIndex next = 0;
  CellBatch batch;
  for (std::size_t b = 0; b < source.n_cell_batches(); ++b) {
    source.read_cells(b, batch);
    EXPECT_EQ(batch.first, next);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(size_of(batch.type[k])); ++i) {
        EXPECT_EQ(batch.corners[k][i], points.at(batch.nodes[k][i]));
      }
      EXPECT_GE(batch.layer[k], 1);
      EXPECT_LE(batch.layer[k], 3);
      EXPECT_EQ(batch.patch[k], 0);
    }
    next += batch.size();
  }
  EXPECT_EQ(next, source.n_cells());
}

}  // namespace
}  // namespace nearwall::mesh

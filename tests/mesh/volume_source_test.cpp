#include "nearwall/mesh/volume_source.h"

#include <gtest/gtest.h>

namespace nearwall::mesh {
namespace {

/// A row of n pyramids on a strip of squares; each has an apex of its own.
VolumeMesh pyramids(std::size_t n) {
  VolumeMesh mesh;
  mesh.first_node.push_back(0);
  for (std::size_t i = 0; i <= n; ++i) {
    const auto x = static_cast<double>(i);
    mesh.points.insert(mesh.points.end(), {Vec3(x, 0, 0), Vec3(x, 1, 0), Vec3(x + 0.5, 0.5, 1)});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto a = static_cast<std::uint32_t>(3 * i);
    mesh.nodes.insert(mesh.nodes.end(), {a, a + 3, a + 4, a + 1, a + 2});
    mesh.type.push_back(CellType::Pyramid);
    mesh.first_node.push_back(mesh.nodes.size());
    mesh.file_cell.push_back(10 * i);
  }
  return mesh;
}

/// Reads the whole source; checks that batches follow each other and that nodes and corners agree.
std::vector<std::array<Vec3, 8>> corners_of_all(const MeshSource& source) {
  std::vector<Vec3> points;
  PointBatch point_batch;
  for (std::size_t b = 0; b < source.n_point_batches(); ++b) {
    source.read_points(b, point_batch);
    EXPECT_EQ(point_batch.first, points.size());
    EXPECT_EQ(point_batch.line, std::vector<std::int64_t>(point_batch.size(), -1));
    EXPECT_EQ(point_batch.level, std::vector<std::int32_t>(point_batch.size(), 0));
    points.insert(points.end(), point_batch.position.begin(), point_batch.position.end());
  }
  EXPECT_EQ(points.size(), source.n_points());
  std::vector<std::array<Vec3, 8>> all;
  CellBatch cells;
  for (std::size_t b = 0; b < source.n_cell_batches(); ++b) {
    source.read_cells(b, cells);
    EXPECT_EQ(cells.first, all.size());
    EXPECT_EQ(cells.column, std::vector<std::int64_t>(cells.size(), -1));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(points[cells.nodes[i][k]], cells.corners[i][k]);
    }
    all.insert(all.end(), cells.corners.begin(), cells.corners.end());
  }
  EXPECT_EQ(all.size(), source.n_cells());
  return all;
}

TEST(VolumeSource, YieldsTheWholeMesh) {
  const VolumeMesh mesh = pyramids(70000);  // several batches
  const VolumeSource source(mesh);
  EXPECT_EQ(source.n_points(), mesh.points.size());
  EXPECT_EQ(source.n_cells_by_type(), (std::array<CellIndex, kNCellTypes>{0, 70000, 0, 0}));
  const auto all = corners_of_all(source);
  for (std::size_t c = 0; c < all.size(); ++c) ASSERT_EQ(all[c], mesh.corners_of(c));
  EXPECT_EQ(source.file_cell(7), 70u);
}

TEST(VolumeSource, YieldsChosenCellsAndOnlyTheirPoints) {
  const VolumeMesh mesh = pyramids(100);
  const std::vector<CellIndex> chosen{41, 40, 3};
  const VolumeSource source(mesh, chosen);
  EXPECT_EQ(source.n_points(), 5u + 8u);  // 40 and 41 share an edge
  EXPECT_EQ(source.n_cells_by_type(), (std::array<CellIndex, kNCellTypes>{0, 3, 0, 0}));
  const auto all = corners_of_all(source);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    EXPECT_EQ(all[i], mesh.corners_of(chosen[i]));
    EXPECT_EQ(source.mesh_cell(i), chosen[i]);
    EXPECT_EQ(source.file_cell(i), 10 * chosen[i]);
  }
}

TEST(VolumeSource, MayBeEmpty) {
  const VolumeMesh mesh = pyramids(3);
  const VolumeSource source(mesh, {});
  EXPECT_EQ(source.n_points(), 0u);
  EXPECT_TRUE(corners_of_all(source).empty());
}

}  // namespace
}  // namespace nearwall::mesh

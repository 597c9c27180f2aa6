#include "nearwall/quality/wall_layers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nearwall/core/parallel.h"
#include "tests/support/shapes.h"
#include "tests/support/volume_meshes.h"

namespace nearwall::quality {
namespace {

using namespace shapes_for_tests;
using namespace volume_meshes_for_tests;

using Start = IdVector<FaceId, std::optional<mesh::FaceName>>;

/// Wedges over the triangles of a plate, up to the given heights; those of triangle f come first to last at
/// f * n_layers.
VolumeMesh stack(const mesh::SurfaceMesh& plate, const std::vector<double>& heights) {
  VolumeMesh mesh;
  const auto n = static_cast<std::uint32_t>(plate.points.size());
  for (std::size_t level = 0; level <= heights.size(); ++level) {
    for (const Vec3& p : plate.points) mesh.points.push_back(p + Vec3(0, 0, level == 0 ? 0 : heights[level - 1]));
  }
  for (const auto& [a, b, c] : plate.faces) {
    for (std::uint32_t level = 0; level < heights.size(); ++level) {
      const std::uint32_t low = level * n, high = low + n;
      add_cell(
          mesh, CellType::Wedge,
          {a.index() + low, b.index() + low, c.index() + low, a.index() + high, b.index() + high, c.index() + high});
    }
  }
  return mesh;
}

Start bottoms(const mesh::SurfaceMesh& plate, std::size_t n_layers) {
  Start start(plate.faces.size());
  for (const FaceId f : plate.faces.ids()) start[f] = mesh::FaceName(f.index() * n_layers, 0);
  return start;
}

TEST(WallLayers, MeasuresAStackOfWedges) {
  const mesh::SurfaceMesh wall = plate(4);
  const VolumeMesh mesh = stack(wall, {0.1, 0.3, 0.7});
  const WallPatchLayers l = wall_layers(mesh, wall, bottoms(wall, 3))[PatchId(0)];
  EXPECT_NEAR(l.area, 1, 1e-15);
  EXPECT_EQ(l.count, 3u);
  EXPECT_EQ(l.matched_percent, 100);
  EXPECT_EQ(l.all_layers_percent, 100);
  EXPECT_EQ(l.any_percent, 100);
  EXPECT_NEAR(l.mean_layers, 3, 1e-14);
  EXPECT_NEAR(l.first_height.p01, 0.1, 1e-15);
  EXPECT_NEAR(l.first_height.p99, 0.1, 1e-15);
  EXPECT_NEAR(l.thickness.median, 0.7, 1e-15);
  EXPECT_NEAR(l.growth.min, 2, 1e-14);
  EXPECT_NEAR(l.growth.max, 2, 1e-14);
  EXPECT_EQ(l.growth.count, wall.faces.size() * 3 * 2);
}

TEST(WallLayers, CountsWhatIsThere) {
  const mesh::SurfaceMesh wall = plate(2);  // 8 triangles of the same area
  const VolumeMesh mesh = stack(wall, {0.1, 0.2, 0.3});
  Start start = bottoms(wall, 3);
  start[FaceId(0)].reset();                         // no face of the mesh
  start[FaceId(1)] = mesh::FaceName(3 * 1 + 2, 0);  // as if only the topmost cell were there
  const WallPatchLayers l = wall_layers(mesh, wall, start)[PatchId(0)];
  EXPECT_EQ(l.count, 3u);
  EXPECT_NEAR(l.matched_percent, 87.5, 1e-12);
  EXPECT_NEAR(l.any_percent, 87.5, 1e-12);
  EXPECT_NEAR(l.all_layers_percent, 75, 1e-12);
  EXPECT_NEAR(l.mean_layers, (6 * 3 + 1) / 8.0, 1e-12);
  EXPECT_EQ(l.first_height.min, 0) << "a triangle without layers counts, with none";
  const WallPatchLayers asked = wall_layers(mesh, wall, start, 4)[PatchId(0)];
  EXPECT_EQ(asked.count, 4u);
  EXPECT_EQ(asked.all_layers_percent, 0);
}

TEST(WallLayers, KeepsPatchesApart) {
  mesh::SurfaceMesh wall = plate(2);
  wall.patch_names.push_back("other");
  for (const FaceId f : wall.faces.ids()) wall.face_patch[f] = PatchId(f.index() < 2 ? 1 : 0);
  Start start = bottoms(wall, 2);
  start[FaceId(0)].reset();
  start[FaceId(1)].reset();
  const auto patches = wall_layers(stack(wall, {0.1, 0.2}), wall, start);
  EXPECT_EQ(patches[PatchId(0)].any_percent, 100);
  EXPECT_NEAR(patches[PatchId(0)].area, 0.75, 1e-15);
  EXPECT_EQ(patches[PatchId(1)].any_percent, 0);
  EXPECT_EQ(patches[PatchId(1)].count, 0u);
}

TEST(WallLayers, ClimbsThroughHexahedraFromAnyFace) {
  const std::uint32_t n = 3;
  const VolumeMesh mesh = block(n, as_hexahedron());
  // Wall: the lower half of the face of each boundary cell on x = 0, x = 1, y = 0, … as triangles of their own.
  for (std::size_t face = 0; face < 6; ++face) {
    mesh::SurfaceMesh wall;
    wall.patch_names.push_back("wall");
    Start start;
    for (std::size_t cell = 0; cell < mesh.n_cells(); ++cell) {
      const mesh::FaceNodes nodes = nodes_of(mesh, mesh::FaceName(cell, face));
      const auto on_boundary = [&](int axis) {
        const double x = mesh.points[nodes[0]][axis];
        return (x == 0 || x == 1) && mesh.points[nodes[1]][axis] == x && mesh.points[nodes[2]][axis] == x;
      };
      if (!on_boundary(0) && !on_boundary(1) && !on_boundary(2)) continue;
      std::array<VertexId, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = wall.points.push_back(mesh.points[nodes[k]]);
      wall.faces.push_back(corners);
      wall.face_patch.push_back(PatchId(0));
      start.push_back(mesh::FaceName(cell, face));
    }
    ASSERT_EQ(wall.faces.size(), n * n);
    const WallPatchLayers l = wall_layers(mesh, wall, start)[PatchId(0)];
    EXPECT_EQ(l.count, n);
    EXPECT_EQ(l.all_layers_percent, 100);
    EXPECT_NEAR(l.first_height.median, 1.0 / n, 1e-15);
    EXPECT_NEAR(l.thickness.min, 1, 1e-15);
    EXPECT_NEAR(l.growth.max, 1, 1e-14);
  }
}

TEST(WallLayers, PassesThroughAPyramidWhereALineStartsLate) {
  // Over one triangle: corner 0 rests at first, then all three move; at the end corner 2 stays behind.
  VolumeMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 1}, {0, 1, 1},
                 {0, 0, 3}, {1, 0, 3}, {0, 1, 3}, {0, 0, 6}, {1, 0, 6}};
  add_cell(mesh, CellType::Pyramid, {1, 3, 4, 2, 0});
  add_cell(mesh, CellType::Wedge, {0, 3, 4, 5, 6, 7});
  add_cell(mesh, CellType::Pyramid, {5, 8, 9, 6, 7});
  const mesh::SurfaceMesh wall = make_surface({mesh.points[0], mesh.points[1], mesh.points[2]}, {{0, 1, 2}});
  Start start(1);
  const mesh::FaceNodes bottom = {0, 1, 2, mesh::kNoNode};
  for (std::size_t f = 0; f < 5; ++f) {
    if (mesh::key_of(nodes_of(mesh, mesh::FaceName(0, f))).nodes == mesh::key_of(bottom).nodes) {
      start[FaceId(0)] = mesh::FaceName(0, f);
    }
  }
  ASSERT_TRUE(start[FaceId(0)].has_value());
  const WallPatchLayers l = wall_layers(mesh, wall, start)[PatchId(0)];
  EXPECT_EQ(l.count, 2u) << "the pyramid above is of the lines that go on";
  EXPECT_NEAR(l.first_height.median, (3 + 1 + 1) / 3.0, 1e-14) << "of a line that starts late its first node";
  EXPECT_NEAR(l.thickness.median, (6 + 6 + 3) / 3.0, 1e-14);
  EXPECT_NEAR(l.growth.max, 2, 1e-14);
  EXPECT_EQ(l.growth.count, 4u);  // 3 → 3 from corner 0; 1 → 2 → 3 from corner 1; 1 → 2 from corner 2
}

TEST(WallLayers, PassesThroughATetrahedronWhereTwoLinesStartLate) {
  VolumeMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 3}, {1, 0, 3}, {0, 1, 3}};
  add_cell(mesh, CellType::Tetrahedron, {0, 1, 2, 3});
  add_cell(mesh, CellType::Wedge, {3, 1, 2, 4, 5, 6});
  const mesh::SurfaceMesh wall = make_surface({mesh.points[0], mesh.points[1], mesh.points[2]}, {{0, 1, 2}});
  Start start(1);
  const mesh::FaceNodes bottom = {0, 1, 2, mesh::kNoNode};
  for (std::size_t f = 0; f < 4; ++f) {
    if (mesh::key_of(nodes_of(mesh, mesh::FaceName(0, f))).nodes == mesh::key_of(bottom).nodes) {
      start[FaceId(0)] = mesh::FaceName(0, f);
    }
  }
  ASSERT_TRUE(start[FaceId(0)].has_value());
  const WallPatchLayers l = wall_layers(mesh, wall, start)[PatchId(0)];
  EXPECT_EQ(l.count, 2u);
  EXPECT_NEAR(l.first_height.median, (1 + 3 + 3) / 3.0, 1e-14);
  EXPECT_NEAR(l.thickness.median, 3, 1e-14);
}

TEST(WallLayers, HasNoLayersWhereTetrahedraLieOnTheWall) {
  const VolumeMesh mesh = five_tetrahedra();
  const mesh::SurfaceMesh wall = make_surface({mesh.points[0], mesh.points[1], mesh.points[3]}, {{0, 1, 2}});
  Start start(1);
  start[FaceId(0)] = mesh::FaceName(0, 0);
  const WallPatchLayers l = wall_layers(mesh, wall, start)[PatchId(0)];
  EXPECT_EQ(l.count, 0u);
  EXPECT_EQ(l.any_percent, 0);
  EXPECT_EQ(l.all_layers_percent, 0);
  EXPECT_EQ(l.matched_percent, 100);
}

}  // namespace
}  // namespace nearwall::quality

#include "nearwall/certify/wall_match.h"

#include <gtest/gtest.h>

#include "nearwall/certify/mesh_certificate.h"
#include "tests/support/shapes.h"
#include "tests/support/volume_meshes.h"

namespace nearwall::certify {
namespace {

using namespace shapes_for_tests;
using namespace volume_meshes_for_tests;

/// One layer of wedges on each triangle of a surface, along the way from the origin.
VolumeMesh layer_on(const mesh::SurfaceMesh& surface, double stretch) {
  VolumeMesh mesh;
  const auto n = static_cast<std::uint32_t>(surface.points.size());
  for (const double factor : {1.0, stretch}) {
    for (const Vec3& p : surface.points) mesh.points.push_back(p * factor);
  }
  for (const auto& [a, b, c] : surface.faces) {
    add_cell(mesh, CellType::Wedge, {a.index(), b.index(), c.index(), a.index() + n, b.index() + n, c.index() + n});
  }
  return mesh;
}

WallMatch match(const VolumeMesh& mesh, const mesh::SurfaceMesh& wall) {
  return match_wall(mesh, conformity(mesh).boundary, wall);
}

TEST(WallMatch, FindsEachTriangleBitForBit) {
  const mesh::SurfaceMesh wall = sphere(3);
  const WallMatch found = match(layer_on(wall, 1.1), wall);
  EXPECT_EQ(found.n_exact, wall.faces.size());
  EXPECT_EQ(found.n_near, 0u);
  for (const FaceId f : wall.faces.ids()) EXPECT_EQ(found.face[f], mesh::FaceName(f.index(), 0));
}

TEST(WallMatch, FindsTrianglesOfSinglePrecisionUnderThinLayers) {
  // The top of the layer, too, is within the tolerance: the nearest face is the right one.
  const mesh::SurfaceMesh wall = sphere(3);
  const VolumeMesh mesh = layer_on(wall, 1 + 1e-5);
  const mesh::SurfaceMesh rounded = mapped(as_soup(wall), [](const Vec3& p) {
    const auto as_float = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    return Vec3(as_float(p.x()), as_float(p.y()), as_float(p.z()));
  });
  const WallMatch found = match(mesh, rounded);
  EXPECT_EQ(found.n_exact + found.n_near, wall.faces.size());
  EXPECT_GT(found.n_near, wall.faces.size() / 2);
  for (const FaceId f : wall.faces.ids()) EXPECT_EQ(found.face[f], mesh::FaceName(f.index(), 0));
}

TEST(WallMatch, LeavesOutWhatTheMeshHasNot) {
  const mesh::SurfaceMesh wall = sphere(3);
  const VolumeMesh mesh = without_cell(layer_on(wall, 1.1), 5);
  const WallMatch found = match(mesh, joined(wall, sphere(1, 1, {5, 0, 0})));
  EXPECT_EQ(found.n_exact, wall.faces.size() - 1);
  EXPECT_EQ(found.n_near, 0u);
  EXPECT_FALSE(found.face[FaceId(5)].has_value());
}

TEST(WallMatch, FindsTheQuadThatATriangleIsHalfOf) {
  const VolumeMesh mesh = block(1, as_hexahedron());
  const WallMatch found = match(mesh, box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(found.n_exact, 12u);
}

}  // namespace
}  // namespace nearwall::certify

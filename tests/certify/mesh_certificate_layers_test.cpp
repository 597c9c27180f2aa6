#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "nearwall/certify/certificate.h"
#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/geometry/box.h"
#include "nearwall/predicates/orientation.h"
#include "tests/support/gallery.h"
#include "tests/support/growing.h"
#include "tests/support/shapes.h"
#include "tests/support/volume_meshes.h"

// Layers as a mesh of a file: the two certificates, which share little, must agree; damage must be seen.

namespace nearwall::certify {
namespace {

using namespace shapes_for_tests;
using namespace volume_meshes_for_tests;
using predicates::Sign;

VolumeMesh read_layers(const mesh::LayerMesh& layers, const mesh::SurfaceMesh& wall) {
  return read(mesh::LayerSource(layers, wall.face_patch, wall.points.raw()));
}

/// Layers round a cube, some 1000 wedges.
VolumeMesh layers_round_a_cube() {
  const growing_for_tests::TestWall wall(gallery::catalogued("cube", {}, 0.34));
  const auto stack = layers::grow(
      wall.wall(), growing_for_tests::options_for(wall.surface(), growing_for_tests::geometric(0.1, 1.2, 5)));
  return read_layers(mesh::LayerMesh(stack.front, stack.lines), wall.surface());
}

struct GrownLayers : testing::TestWithParam<gallery::Shape> {};

TEST_P(GrownLayers, AreValidInBothCertificates) {
  const mesh::SurfaceMesh surface = gallery::into_the_fluid(GetParam());
  const growing_for_tests::TestWall wall(surface, GetParam().fluid_is_inside);
  const double diagonal = gallery::diagonal(surface);
  const auto stack = layers::grow(
      wall.wall(), growing_for_tests::options_for(surface, growing_for_tests::geometric(0.05 * diagonal, 1.3, 6)));
  const mesh::LayerMesh layers(stack.front, stack.lines);
  const Certificate direct = certify_layers(layers, wall.certified_wall());
  const MeshCertificate c = certify_mesh(read_layers(layers, surface));
  EXPECT_TRUE(direct.is_valid());
  EXPECT_TRUE(c.is_valid());
  EXPECT_EQ(c.n_cells(), direct.n_cells);
  EXPECT_LT(c.closure().value(), 1e-13);
  EXPECT_NEAR(c.cells_volume, direct.cells_volume, 1e-12 * direct.summed_volume);
}

/// Layers of all cell types, pinched fronts, several components, fluid inside.
std::vector<gallery::Shape> some_shapes() {
  std::vector<gallery::Shape> some;
  for (const char* name :
       {"tetrahedron", "blind_corner", "cube", "knife", "step", "groove", "narrow_notch", "saddle_block",
        "block_on_floor", "deep_star", "torus", "cone_tip", "needle_triangles", "wing_with_sharp_trailing_edge", "gap",
        "hair_gap", "small_body_before_a_large_one", "concentric_spheres", "bend"}) {
    const auto found = std::find_if(gallery::shapes().begin(), gallery::shapes().end(),
                                    [&](const gallery::Shape& shape) { return shape.name == name; });
    if (found != gallery::shapes().end()) some.push_back(*found);
  }
  return some;
}

INSTANTIATE_TEST_SUITE_P(Mesh, GrownLayers, testing::ValuesIn(some_shapes()),
                         [](const auto& shape) { return shape.param.name; });

TEST(DamagedLayers, AreNotValidWithOnePointMovedThroughTheBody) {
  const VolumeMesh good = layers_round_a_cube();
  ASSERT_TRUE(certify_mesh(good).is_valid());
  const Vec3 centre = geometry::bounding_box(good.points).centre();
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    VolumeMesh mesh = good;
    Vec3& p = mesh.points[random() % mesh.points.size()];
    p = centre * 2 - p;
    const MeshCertificate c = certify_mesh(mesh);
    EXPECT_FALSE(c.is_valid()) << i;
    EXPECT_FALSE(c.cells.offenders.empty()) << i;
  }
}

TEST(DamagedLayers, AreNotValidWithTwoNodesOfACellExchanged) {
  const VolumeMesh good = layers_round_a_cube();
  for (std::size_t cell = 0; cell < good.n_cells(); cell += 97) {
    VolumeMesh mesh = good;
    std::swap(mesh.nodes[mesh.first_node[cell]], mesh.nodes[mesh.first_node[cell] + 1]);
    const MeshCertificate c = certify_mesh(mesh);
    ASSERT_EQ(c.cells.offenders.size(), 1u);
    EXPECT_EQ(c.cells.offenders[0].cell, cell);
    EXPECT_FALSE(c.is_valid());
  }
}

TEST(DamagedLayers, AreValidWithACellMissing) {
  // What is left covers less, but still nothing twice: a hole is boundary.
  const VolumeMesh good = layers_round_a_cube();
  const std::size_t n_faces = certify_mesh(good).faces.boundary.size();
  for (std::size_t cell = 0; cell < good.n_cells(); cell += 211) {
    const MeshCertificate c = certify_mesh(without_cell(good, cell));
    EXPECT_TRUE(c.is_valid());
    EXPECT_NE(c.faces.boundary.size(), n_faces);
  }
}

TEST(DamagedLayers, AreNotValidWithACellTwice) {
  VolumeMesh mesh = layers_round_a_cube();
  const auto nodes = mesh.nodes_of(17);
  add_cell(mesh, mesh.type[17], {nodes.begin(), nodes.end()});
  const MeshCertificate c = certify_mesh(mesh);
  EXPECT_FALSE(c.faces.nonconforming.empty());
  EXPECT_FALSE(c.is_valid());
}

TEST(DamagedLayers, AreNotValidWithACellThatHasPointsOfItsOwn) {
  VolumeMesh mesh = layers_round_a_cube();
  const std::size_t cell = 40;
  for (std::size_t k = 0; k < 6; ++k) {
    std::uint32_t& node = mesh.nodes[mesh.first_node[cell] + k];
    mesh.points.push_back(mesh.points[node]);
    node = static_cast<std::uint32_t>(mesh.points.size() - 1);
  }
  const MeshCertificate c = certify_mesh(mesh);
  EXPECT_FALSE(c.is_valid());
  EXPECT_GT(c.n_coincident_points, 0u);
  EXPECT_TRUE(certify_mesh(merged(mesh)).is_valid());
}

/// Shell of wedges between a sphere and the same one scaled: all faces are planar, all cells convex.
VolumeMesh shell(double inner, double outer, const Vec3& centre = {}) {
  const mesh::SurfaceMesh ball = sphere(2);
  const auto n = static_cast<std::uint32_t>(ball.points.size());
  VolumeMesh mesh;
  for (const double radius : {inner, outer}) {
    for (const Vec3& p : ball.points) mesh.points.push_back(p * radius + centre);
  }
  for (const auto& [a, b, c] : ball.faces) {
    add_cell(mesh, CellType::Wedge, {a.index(), b.index(), c.index(), a.index() + n, b.index() + n, c.index() + n});
  }
  return mesh;
}

/// Cells with planar faces that contain a point, counted one by one.
int count_covers(const VolumeMesh& mesh, const Vec3& p) {
  int n = 0;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    bool is_inside = true;
    for (std::size_t f = 0; f < mesh::cell_faces(mesh.type[c]).size() && is_inside; ++f) {
      const mesh::FaceNodes face = nodes_of(mesh, mesh::FaceName(c, f));
      is_inside = predicates::orientation(mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]], p) ==
                  Sign::Negative;
    }
    n += is_inside ? 1 : 0;
  }
  return n;
}

/// Random points by how often they are covered.
std::map<int, int> sampled_covers(const VolumeMesh& mesh, double reach) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  std::map<int, int> found;
  for (int i = 0; i < 2000; ++i) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    ++found[count_covers(mesh, {x, y, z})];
  }
  return found;
}

TEST(Covers, AgreeWithCountingTheCellsAtRandomPoints) {
  struct Case {
    VolumeMesh mesh;
    bool is_valid;
  };
  const std::vector<Case> cases = {
      {shell(1, 2), true},
      {joined(shell(1, 2), shell(3, 4)), true},
      {joined(shell(1, 3), shell(2, 4)), false},                   // two shells in one gap
      {joined(shell(1, 4), shell(0.1, 0.3, {2.2, 0, 0})), false},  // a body swallowed
      {joined(shell(1, 2), shell(0.1, 0.3, {0.2, 0, 0})), true},   // a body within a hollow one
      {joined(shell(2, 4), block(4, as_tetrahedra())), true},      // the hollow holds a block …
      {joined(shell(0.1, 4), block(4, as_tetrahedra())), false},   // … or not
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const VolumeMesh small = mapped(cases[i].mesh, [](const Vec3& p) { return p * 0.25; });
    const auto covers = sampled_covers(small, 1.1);
    EXPECT_EQ(covers.rbegin()->first, cases[i].is_valid ? 1 : 2) << i;
    EXPECT_EQ(certify_mesh(small).is_valid(), cases[i].is_valid) << i;
  }
}

}  // namespace
}  // namespace nearwall::certify

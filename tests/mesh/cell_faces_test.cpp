#include "nearwall/mesh/cell_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "tests/support/volume_meshes.h"

namespace nearwall::mesh {
namespace {

using namespace volume_meshes_for_tests;

VolumeMesh one_cell(CellType type) {
  VolumeMesh mesh;
  if (type == CellType::Tetrahedron) mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (type == CellType::Pyramid) mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  if (type == CellType::Wedge) mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  if (type == CellType::Hexahedron) return block(1, as_hexahedron());
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t k = 0; k < mesh.points.size(); ++k) nodes.push_back(k);
  add_cell(mesh, type, nodes);
  return mesh;
}

struct FacesOfType : testing::TestWithParam<CellType> {};

TEST_P(FacesOfType, CloseTheCellAndLookOutward) {
  const VolumeMesh mesh = one_cell(GetParam());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double six_volumes = 0;
  for (std::size_t f = 0; f < cell_faces(GetParam()).size(); ++f) {
    const FaceNodes nodes = nodes_of(mesh, FaceName(0, f));
    const auto n = static_cast<std::size_t>(size_of(nodes));
    for (std::size_t k = 0; k < n; ++k) ++edges[{nodes[k], nodes[(k + 1) % n]}];
    const auto p = [&](std::size_t k) { return mesh.points[nodes[k]] - Vec3(0.3, 0.2, 0.1); };
    for (std::size_t k = 2; k < n; ++k) six_volumes += dot(cross(p(0), p(k - 1)), p(k));
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << "its neighbour runs along it the other way";
  }
  EXPECT_NEAR(six_volumes / 6, cell_volume(GetParam(), mesh.corners_of(0)), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(CellFaces, FacesOfType,
                         testing::Values(CellType::Tetrahedron, CellType::Pyramid, CellType::Wedge,
                                         CellType::Hexahedron),
                         [](const auto& type) {
                           return std::string(kCellTypeNames[static_cast<std::size_t>(type.param)]);
                         });

TEST(FaceKey, IsTheSameForAllRotationsAndTurnedForTheOtherSide) {
  for (const FaceNodes& face : {FaceNodes{7, 3, 9, 5}, FaceNodes{4, 8, 2, kNoNode}}) {
    const auto n = static_cast<std::ptrdiff_t>(size_of(face));
    const FaceKey key = key_of(face);
    FaceNodes turned = face;
    std::reverse(turned.begin(), turned.begin() + n);
    for (std::ptrdiff_t k = 0; k < n; ++k) {
      FaceNodes same = face, other = turned;
      std::rotate(same.begin(), same.begin() + k, same.begin() + n);
      std::rotate(other.begin(), other.begin() + k, other.begin() + n);
      EXPECT_EQ(key_of(same).nodes, key.nodes);
      EXPECT_EQ(key_of(same).is_turned, key.is_turned);
      EXPECT_EQ(key_of(other).nodes, key.nodes);
      EXPECT_NE(key_of(other).is_turned, key.is_turned);
    }
  }
  EXPECT_NE(key_of({0, 1, 2, 3}).nodes, key_of({0, 2, 1, 3}).nodes) << "not a rotation";
}

TEST(FaceIndex, HoldsEachFaceOnceAtItsSmallestNode) {
  const VolumeMesh mesh = joined(block(3, as_wedges()), block(2, as_tetrahedra()));
  const FaceIndex index(mesh);
  ASSERT_EQ(index.n_nodes(), mesh.points.size());
  std::vector<FaceName> all;
  for (std::size_t node = 0; node < index.n_nodes(); ++node) {
    const auto faces = index.faces_at(node);
    EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
    for (const FaceName face : faces) {
      EXPECT_EQ(key_of(nodes_of(mesh, face)).nodes[0], node);
      all.push_back(face);
    }
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::unique(all.begin(), all.end()), all.end());
  EXPECT_EQ(all.size(), 54u * 5u + 48u * 4u);
}

TEST(FaceIndex, FindsTheCellOnTheOtherSide) {
  const VolumeMesh mesh = block(2, as_hexahedron());
  const FaceIndex index(mesh);
  // Face 3 of a hexahedron looks along +x, face 5 along −x.
  EXPECT_EQ(index.opposite(mesh, FaceName(0, 3)), FaceName(1, 5));
  EXPECT_EQ(index.opposite(mesh, FaceName(1, 5)), FaceName(0, 3));
  EXPECT_EQ(index.opposite(mesh, FaceName(1, 3)), FaceName(1, 3)) << "on the boundary";
}

TEST(FaceIndex, FindsNoOtherSideWhereThereAreSeveral) {
  VolumeMesh mesh = block(2, as_hexahedron());
  const auto nodes = mesh.nodes_of(1);
  add_cell(mesh, CellType::Hexahedron, {nodes.begin(), nodes.end()});
  const FaceIndex index(mesh);
  EXPECT_EQ(index.opposite(mesh, FaceName(0, 3)), FaceName(0, 3));
}

TEST(FaceIndex, NamesACellWithANodeThatThereIsNot) {
  VolumeMesh mesh = block(2, as_hexahedron());
  mesh.nodes[8 * 5 + 2] = 27;
  try {
    const FaceIndex index(mesh);
    FAIL() << "accepted node 27 of 27";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cell 5"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace nearwall::mesh

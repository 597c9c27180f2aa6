#include "nearwall/mesh/topology.h"

#include <set>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "tests/support/shapes.h"

namespace nearwall::mesh {
namespace {

using namespace shapes_for_tests;

TEST(Topology, GoesRoundEveryVertexCounterclockwise) {
  const SurfaceMesh cube = shapes_for_tests::cube();
  const Topology topology(cube);
  EXPECT_TRUE(topology.is_closed());
  std::size_t n = 0;
  for (const VertexId v : cube.points.ids()) {
    const auto fan = topology.fan(v);
    n += fan.size();
    for (std::size_t k = 0; k < fan.size(); ++k) {
      EXPECT_EQ(topology.origin(fan[k]), v);
      // Counterclockwise: the side of this face that comes into v is the twin of the next halfedge that leaves it.
      EXPECT_EQ(topology.twin(Topology::previous(fan[k])), fan[(k + 1) % fan.size()]);
    }
  }
  EXPECT_EQ(n, 3 * cube.faces.size());
}

TEST(Topology, StartsTheFanOfABoundaryVertexAtTheBoundary) {
  const SurfaceMesh fan = make_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 2, 3}, {0, 1, 2}});
  const Topology topology(fan);
  EXPECT_FALSE(topology.is_closed());
  EXPECT_TRUE(topology.is_boundary(VertexId(0)));
  ASSERT_EQ(topology.fan(VertexId(0)).size(), 2u);
  EXPECT_EQ(topology.target(topology.fan(VertexId(0))[0]), VertexId(1));
  EXPECT_EQ(topology.target(topology.fan(VertexId(0))[1]), VertexId(2));
}

TEST(Topology, RefusesAnEdgeWithThreeTriangles) {
  const SurfaceMesh book =
      make_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_THROW(Topology{book}, GeometryError);
}

TEST(Topology, RefusesTwoFansAtOneVertex) {
  const SurfaceMesh bow =
      make_surface({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  EXPECT_THROW(Topology{bow}, GeometryError);
}

TEST(ConnectedComponents, AreNumberedByTheirFirstFace) {
  const SurfaceMesh two = joined(cube(), translated(cube(), {5, 0, 0}));
  const auto component = connected_components(Topology(two));
  for (const FaceId f : two.faces.ids()) {
    EXPECT_EQ(component[f].index(), f.index() < two.faces.size() / 2 ? 0u : 1u);
  }
}

}  // namespace
}  // namespace nearwall::mesh

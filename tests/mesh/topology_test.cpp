#include "nearwall/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

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

TEST(Topology, NamesTheSpokesOfAVertexCounterclockwise) {
  const SurfaceMesh plate = shapes_for_tests::plate(3);
  const Topology topology(plate);
  for (const VertexId v : plate.points.ids()) {
    std::set<VertexId> expected, found;
    for (const auto& f : plate.faces) {
      if (std::find(f.begin(), f.end(), v) != f.end()) expected.insert(f.begin(), f.end());
    }
    expected.erase(v);
    std::vector<double> angles;
    topology.for_each_spoke(v, [&](VertexId w, FaceId f) {
      EXPECT_TRUE(found.insert(w).second) << "each once";
      const auto& corners = plate.faces[f];
      EXPECT_NE(std::find(corners.begin(), corners.end(), v), corners.end());
      EXPECT_NE(std::find(corners.begin(), corners.end(), w), corners.end());
      const Vec3 way = plate.points[w] - plate.points[v];
      angles.push_back(std::atan2(way.y(), way.x()));
    });
    EXPECT_EQ(found, expected);
    const auto is_less = [&](std::size_t k) { return angles[(k + 1) % angles.size()] < angles[k]; };
    int n_jumps = 0;
    for (std::size_t k = 0; k < angles.size(); ++k) n_jumps += is_less(k);
    EXPECT_EQ(n_jumps, 1) << "counterclockwise once round";
    std::set<VertexId> neighbours;
    topology.for_each_neighbour(v, [&](VertexId w) { neighbours.insert(w); });
    EXPECT_EQ(neighbours, expected);
  }
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

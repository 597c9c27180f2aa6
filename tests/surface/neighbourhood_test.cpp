#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "nearwall/surface/fitted_normals.h"
#include "tests/support/shapes.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;

/// Vertices within n_rings edges, by brute force over all faces.
std::set<VertexId> within(const mesh::SurfaceMesh& surface, VertexId v, int n_rings) {
  std::set<VertexId> found = {v};
  for (int ring = 0; ring < n_rings; ++ring) {
    std::set<VertexId> next = found;
    for (const auto& face : surface.faces) {
      const bool touches = std::any_of(face.begin(), face.end(), [&](VertexId w) { return found.contains(w); });
      if (touches) next.insert(face.begin(), face.end());
    }
    found = next;
  }
  found.erase(v);
  return found;
}

TEST(Neighbourhood, HoldsEachVertexOfTheRingsOnce) {
  for (const auto& surface : {shapes::sphere(2), shapes::plate(5), shapes::cube()}) {
    const mesh::Topology topology(surface);
    Neighbourhood neighbourhood(topology);
    for (const VertexId v : surface.points.ids()) {
      for (const int n_rings : {1, 2, 3}) {
        const auto found = neighbourhood.of(v, n_rings);
        const std::set<VertexId> unique(found.begin(), found.end());
        EXPECT_EQ(unique.size(), found.size());
        EXPECT_EQ(unique, within(surface, v, n_rings)) << v.index() << " with rings: " << n_rings;
      }
      EXPECT_TRUE(neighbourhood.of(v, 0).empty());
    }
  }
}

TEST(Neighbourhood, StartsWithTheFirstRingInItsOrder) {
  const auto surface = shapes::plate(4);
  const mesh::Topology topology(surface);
  Neighbourhood neighbourhood(topology);
  for (const VertexId v : surface.points.ids()) {
    std::vector<VertexId> ring;
    for (const HalfedgeId h : topology.fan(v)) ring.push_back(topology.target(h));
    if (topology.is_boundary(v)) ring.push_back(topology.origin(mesh::Topology::previous(topology.fan(v).back())));
    const auto found = neighbourhood.of(v);
    ASSERT_GE(found.size(), ring.size());
    EXPECT_TRUE(std::equal(ring.begin(), ring.end(), found.begin()));
  }
}

TEST(Neighbourhood, DoesNotReachThroughAHub) {
  const std::size_t n = 3000;
  const auto surface = shapes::cone(n, 1);
  const mesh::Topology topology(surface);
  Neighbourhood neighbourhood(topology);
  EXPECT_EQ(neighbourhood.of(VertexId(0)).size(), n + 1);  // the tip sees the whole rim and, through it, the base
  EXPECT_EQ(neighbourhood.of(VertexId(2)).size(), 6u);     // two rim vertices on either side, tip and base
}

}  // namespace
}  // namespace nearwall::surface

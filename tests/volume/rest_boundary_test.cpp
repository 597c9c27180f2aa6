#include "nearwall/volume/rest_boundary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/geometry/measures.h"
#include "tests/support/gallery.h"
#include "tests/volume/open_shapes.h"

namespace nearwall::volume {
namespace {

using namespace open_shapes;
using growing_for_tests::geometric;

/// Layers on an open wall and the boundary of what they leave.
struct Rest {
  TestOpenWall wall;
  layers::Growth growth;
  mesh::LayerMesh layers;
  certify::FrontSurface front;
  RestBoundary boundary;

  Rest(surface::OpenWall open, const std::set<std::string>& with_layers, const std::vector<double>& heights,
       double rate = 1.3)
      : wall(std::move(open)),
        growth(layers::grow(wall.wall(), wall.options(heights, with_layers))),
        layers(growth.front, growth.lines),
        front(certify::front_surface(growth.front, growth.lines)),
        boundary(rest_boundary(layers, wall.certified_wall(), rate)) {}

  Vec3 point(std::uint32_t p) const { return boundary.surface.points[p]; }
  double triangle_area(std::size_t t) const {
    const auto& [a, b, c] = boundary.surface.triangles[t];
    return geometry::triangle_area(point(a), point(b), point(c));
  }
};

using DirectedEdge = std::array<std::uint32_t, 2>;

std::map<DirectedEdge, int> edges_of(const FillBoundary& surface) {
  std::map<DirectedEdge, int> edges;
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  return edges;
}

double enclosed_volume(const FillBoundary& surface) {
  geometry::CompensatedSum six;
  const Vec3& origin = surface.points.front();
  for (const auto& [a, b, c] : surface.triangles) {
    six.add(dot(cross(surface.points[a] - origin, surface.points[b] - origin), surface.points[c] - origin));
  }
  return six.value() / 6;
}

class RestOfShapes : public testing::TestWithParam<OpenShape> {
 protected:
  static Rest make() {
    surface::OpenWall open = GetParam().make();
    const double diagonal = size_of(open.surface, GetParam().with_layers);
    return {std::move(open), GetParam().with_layers, geometric(0.02 * diagonal, 1.2, 8)};
  }
};

TEST_P(RestOfShapes, IsClosedAndManifold) {
  const Rest rest = make();
  const auto edges = edges_of(rest.boundary.surface);
  for (const auto& [edge, n] : edges) {
    ASSERT_EQ(n, 1) << "each edge once in each direction";
    ASSERT_TRUE(edges.contains({edge[1], edge[0]}));
  }
  EXPECT_EQ(rest.boundary.rest_plane.size(), rest.boundary.surface.triangles.size() - rest.boundary.n_front);
  EXPECT_EQ(rest.boundary.front_face.size(), rest.boundary.n_front);
  EXPECT_EQ(rest.boundary.node.size(), rest.boundary.surface.points.size());
  // As much as the front leaves when its sides are closed without new points.
  certify::FrontSurface closed = rest.front;
  ASSERT_TRUE(certify::close_front(rest.growth.front, rest.wall.planes(), closed).empty());
  const double volume = -enclosed_volume({closed.points, closed.triangles});
  EXPECT_NEAR(enclosed_volume(rest.boundary.surface), volume, 1e-12 * volume);
}

TEST_P(RestOfShapes, BeginsWithTheFrontAsItIs) {
  const Rest rest = make();
  const FillBoundary& surface = rest.boundary.surface;
  ASSERT_EQ(rest.boundary.n_front, rest.front.triangles.size());
  for (std::size_t t = 0; t < rest.boundary.n_front; ++t) {
    EXPECT_EQ(rest.boundary.front_face[t], rest.front.face[t]);
    // Seen from the layers, so the other way round.
    const auto& [a, b, c] = rest.front.triangles[t];
    const auto& [p, q, r] = surface.triangles[t];
    EXPECT_EQ(rest.point(p), rest.front.points[a]);
    EXPECT_EQ(rest.point(q), rest.front.points[c]);
    EXPECT_EQ(rest.point(r), rest.front.points[b]);
  }
  // A node of the layers lies where it says; others are new.
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const NodeIndex node = rest.boundary.node[i];
    if (node == kNoLayerNode) continue;
    ASSERT_LT(node, rest.layers.n_nodes());
    if (node < rest.wall.surface().points.size()) {
      EXPECT_EQ(rest.wall.surface().points[VertexId(node)], surface.points[i]);
    }
  }
  for (const LineId line : rest.growth.lines.windows.ids()) {
    const Level end = rest.growth.lines.windows[line].end;
    const auto at = std::find(rest.boundary.node.begin(), rest.boundary.node.end(), rest.layers.node(line, end));
    ASSERT_NE(at, rest.boundary.node.end());
    EXPECT_EQ(surface.points[static_cast<std::size_t>(at - rest.boundary.node.begin())],
              rest.growth.lines.position(line, end));
  }
  std::set<NodeIndex> nodes(rest.boundary.node.begin(), rest.boundary.node.end());
  nodes.erase(kNoLayerNode);
  const auto n_new = std::count(rest.boundary.node.begin(), rest.boundary.node.end(), kNoLayerNode);
  EXPECT_EQ(nodes.size() + static_cast<std::size_t>(n_new), rest.boundary.node.size()) << "each node once";
}

TEST_P(RestOfShapes, LiesOnItsPlanesAndLooksOutOfTheDomain) {
  const Rest rest = make();
  const double extent = geometry::bounding_box(rest.boundary.surface.points).diagonal();
  for (std::size_t t = rest.boundary.n_front; t < rest.boundary.surface.triangles.size(); ++t) {
    const mesh::SidePlane& plane = rest.wall.planes().planes[rest.boundary.rest_plane[t - rest.boundary.n_front]];
    const auto& [a, b, c] = rest.boundary.surface.triangles[t];
    EXPECT_LT(dot(cross(rest.point(b) - rest.point(a), rest.point(c) - rest.point(a)), plane.normal), 0);
    for (const std::uint32_t p : {a, b, c}) {
      EXPECT_LE(std::abs(plane.height(rest.point(p))), plane.axis >= 0 ? 0.0 : 1e-14 * extent);
    }
  }
}

TEST_P(RestOfShapes, SplitsNoEdgeOfTheLayers) {
  const Rest rest = make();
  // Edges of the rest of each plane, by the positions of their ends.
  std::map<mesh::PlaneIndex, std::set<std::pair<NodeIndex, NodeIndex>>> of_plane;
  for (std::size_t t = rest.boundary.n_front; t < rest.boundary.surface.triangles.size(); ++t) {
    const auto& corners = rest.boundary.surface.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      of_plane[rest.boundary.rest_plane[t - rest.boundary.n_front]].insert(
          {rest.boundary.node[corners[k]], rest.boundary.node[corners[(k + 1) % 3]]});
    }
  }
  const auto traces = certify::plane_traces(rest.growth.front, rest.wall.planes(), rest.front);
  const auto node = [&](std::uint32_t line) {
    return rest.layers.node(LineId(line), rest.growth.lines.windows[LineId(line)].end);
  };
  std::size_t n = 0;
  for (mesh::PlaneIndex p = 0; p < traces.size(); ++p) {
    for (const certify::TraceEdge& edge : traces[p]) {
      // The rest lies to the left, seen from the domain: to the right from outside.
      EXPECT_TRUE(of_plane[p].contains({node(edge.points[1]), node(edge.points[0])}));
      ++n;
    }
  }
  EXPECT_GT(n, 0u);
}

INSTANTIATE_TEST_SUITE_P(All, RestOfShapes, testing::ValuesIn(shapes_with_planes()),
                         [](const auto& instance) { return instance.param.name; });

/// Points on the edge between two planes belong to triangles of both, bit for bit on both.
TEST(RestBoundary, SharesPointsBetweenPlanes) {
  const Rest rest(cut_body("quarter-cylinder", {}, 0.15, {"symmetry-y", "symmetry-z"}), {"front", "side", "base"},
                  geometric(0.02, 1.2, 8));
  std::map<std::uint32_t, std::set<mesh::PlaneIndex>> planes_at;
  for (std::size_t t = rest.boundary.n_front; t < rest.boundary.surface.triangles.size(); ++t) {
    for (const std::uint32_t p : rest.boundary.surface.triangles[t]) {
      planes_at[p].insert(rest.boundary.rest_plane[t - rest.boundary.n_front]);
    }
  }
  int n_new = 0;
  for (const auto& [p, planes] : planes_at) {
    const bool is_on_axis = rest.point(p).y() == 0 && rest.point(p).z() == 0;
    EXPECT_EQ(planes.size() == 2, is_on_axis);
    n_new += is_on_axis && rest.boundary.node[p] == kNoLayerNode;
  }
  EXPECT_GT(n_new, 4) << "the seam is divided";
}

/// The sides of a room of edge 1 whose layers are of full thickness everywhere.
TEST(RestBoundary, LeavesTheSidesLessTheirLayers) {
  const double thickness = 0.2;
  const Rest rest(room(3), {"wall"}, geometric(thickness, 1.2, 8));
  std::vector<double> area(4, 0);
  for (std::size_t t = rest.boundary.n_front; t < rest.boundary.surface.triangles.size(); ++t) {
    area[rest.boundary.rest_plane[t - rest.boundary.n_front]] += rest.triangle_area(t);
  }
  for (const double a : area) EXPECT_NEAR(a, 1 - thickness, 1e-13);
  EXPECT_NEAR(enclosed_volume(rest.boundary.surface), 1 - thickness, 1e-13);
}

/// An edge may be as long as that of its neighbour and (growth − 1) times the way between them: with the far field far
/// away, triangles become large, but no faster. Smaller growth, more triangles.
TEST(RestBoundary, GrowsAtTheRateAskedFor) {
  const auto n_rest = [](double growth) {
    const Rest rest(cut_body("two-spheres", {{"half", 1}, {"gap", 0.1}}, 0.25, {"symmetry"}), {"first", "second"},
                    geometric(0.02, 1.2, 8), growth);
    return rest.boundary.rest_plane.size();
  };
  const std::size_t slow = n_rest(1.1), usual = n_rest(1.3), fast = n_rest(2);
  EXPECT_GT(slow, usual);
  EXPECT_GT(usual, fast);
}

TEST(RestBoundary, IsTheFrontAloneWithoutPlanes) {
  const growing_for_tests::TestWall wall(shapes_for_tests::sphere(2));
  const auto growth = layers::grow(wall.wall(), growing_for_tests::options_for(wall.surface(), geometric(0.1, 1.2, 4)));
  const mesh::LayerMesh layers(growth.front, growth.lines);
  const RestBoundary rest = rest_boundary(layers, wall.certified_wall(), 1.3);
  EXPECT_EQ(rest.n_front, wall.surface().faces.size());
  EXPECT_EQ(rest.surface.triangles.size(), rest.n_front);
  EXPECT_TRUE(rest.rest_plane.empty());
  EXPECT_EQ(rest.surface.points.size(), wall.surface().points.size()) << "points of the wall are left out";
}

/// A cavity that the fluid does not reach bounds nothing.
TEST(RestBoundary, LeavesOutWhatTheFluidDoesNotReach) {
  const auto outer = shapes_for_tests::sphere(2), inner = shapes_for_tests::flipped(shapes_for_tests::sphere(1, 0.3));
  growing_for_tests::TestWall wall(shapes_for_tests::joined(outer, inner));
  for (const FaceId f : wall.is_wetted().ids()) wall.is_wetted()[f] = f.index() < outer.faces.size() ? 1 : 0;
  const auto growth = layers::grow(wall.wall(), growing_for_tests::options_for(wall.surface(), geometric(0.1, 1.2, 4)));
  const mesh::LayerMesh layers(growth.front, growth.lines);
  const RestBoundary rest = rest_boundary(layers, wall.certified_wall(), 1.3);
  EXPECT_EQ(rest.surface.triangles.size(), outer.faces.size());
  for (const Vec3& p : rest.surface.points) EXPECT_GT(norm(p), 1);
}

}  // namespace
}  // namespace nearwall::volume

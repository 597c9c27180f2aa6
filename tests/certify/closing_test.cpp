#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/certify/certificate.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/shapes/shapes.h"
#include "tests/support/moved.h"
#include "tests/support/open_walls.h"

namespace nearwall::certify {
namespace {

using namespace open_walls_for_tests;
using namespace shapes_for_tests;

/// Lines of one piece that lead each vertex to where a function says, in one layer.
struct Moved {
  mesh::Front front;
  mesh::Lines lines;
  FrontSurface surface;

  Moved(const mesh::SurfaceMesh& wall, const std::function<Vec3(const Vec3&)>& to) : front(mesh::plain_front(wall)) {
    lines.table = mesh::HeightTable({{0, 1}});
    for (const Vec3& p : wall.points) {
      lines.base.push_back(p);
      lines.first_piece.push_back(static_cast<std::uint32_t>(lines.pieces.size()));
      lines.pieces.push_back({to(p) - p, 0});
      lines.heights.push_back({});
      lines.windows.push_back({0, static_cast<Level>(to(p) == p ? 0 : 1)});
    }
    lines.first_piece.push_back(static_cast<std::uint32_t>(lines.pieces.size()));
    surface = front_surface(front, lines);
  }
};

Vec3 stay(const Vec3& p) { return p; }

std::vector<double> rest_areas(const FrontSurface& surface, std::size_t n_planes) {
  std::vector<double> area(n_planes, 0);
  for (std::size_t i = 0; i < surface.rest_plane.size(); ++i) {
    const auto& [a, b, c] = surface.triangles[surface.face.size() + i];
    area[surface.rest_plane[i]] += geometry::triangle_area(surface.points[a], surface.points[b], surface.points[c]);
  }
  return area;
}

/// Each edge once in each direction.
void expect_closed(const FrontSurface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, n] : edges) {
    EXPECT_EQ(n, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

/// Volume to which the triangles look: the fluid that is left.
double fluid_volume(const FrontSurface& surface) {
  double six = 0;
  const Vec3& origin = surface.points.front();
  for (const auto& [a, b, c] : surface.triangles) {
    six -= dot(cross(surface.points[a] - origin, surface.points[b] - origin), surface.points[c] - origin);
  }
  return six / 6;
}

/// A room with a floor, a ceiling and four planes between.
surface::OpenWall room(int level, double height) {
  mesh::SurfaceMesh surface = box({0, 0, 0}, {1, 2, height});
  for (int i = 0; i < level; ++i) surface = subdivided(surface);
  paint(surface, "sides", [&](const Vec3& p) { return p.z() > 0 && p.z() < height; });
  return Closed(surface, {{"sides", SideRole::Opening}}, FluidSide::Inside).open();
}

TEST(CloseFront, GivesTheSidesBackWhereNothingMoves) {
  struct Shape {
    std::string name;
    shapes::ParameterValues parameters;
    double size;
    std::vector<std::string> sides;
  };
  const std::vector<Shape> all = {{"bend", {{"angle", 30}}, 0.3, {"inlet", "outlet"}},
                                  {"bend", {}, 0.3, {"inlet", "outlet"}},
                                  {"vessel", {}, 0, {"inlet", "outlet-1", "outlet-2"}}};
  for (const Shape& shape : all) {
    Roles roles;
    for (const std::string& side : shape.sides) roles[side] = SideRole::Opening;
    const Closed closed(shapes::make_shape(shape.name, shape.parameters, shape.size), roles, FluidSide::Inside);
    const surface::OpenWall wall = closed.open();
    ASSERT_EQ(wall.planes.planes.size(), shape.sides.size()) << shape.name;
    Moved moved(wall.surface, stay);
    EXPECT_TRUE(close_front(moved.front, wall.planes, moved.surface).empty()) << shape.name;
    expect_closed(moved.surface);
    const auto area = rest_areas(moved.surface, wall.planes.planes.size());
    for (std::size_t p = 0; p < area.size(); ++p) {
      double expected = 0;
      for (const FaceId f : wall.side_faces[p]) {
        const auto [a, b, c] = closed.surface.triangle(f);
        expected += geometry::triangle_area(a, b, c);
      }
      EXPECT_NEAR(area[p], expected, 1e-12 * expected) << shape.name;
    }
  }
}

TEST(CloseFront, LeavesThePolygonOverTheFloor) {
  const surface::OpenWall wall = room(2, 1);
  const double raised = 0.25;
  Moved moved(wall.surface, [&](const Vec3& p) { return p.z() == 0 ? Vec3(p.x(), p.y(), raised) : p; });
  EXPECT_TRUE(close_front(moved.front, wall.planes, moved.surface).empty());
  expect_closed(moved.surface);
  EXPECT_NEAR(fluid_volume(moved.surface), 2 * (1 - raised), 1e-14);
  const auto area = rest_areas(moved.surface, 4);
  for (std::size_t p = 0; p < 4; ++p) {
    const double width = wall.planes.planes[p].axis == 0 ? 2 : 1;
    EXPECT_NEAR(area[p], width * (1 - raised), 1e-14);
  }
  EXPECT_TRUE(front_intersections(moved.surface).empty());
  for (std::size_t i = 0; i < moved.surface.rest_plane.size(); ++i) {
    const auto& [a, b, c] = moved.surface.triangles[moved.surface.face.size() + i];
    const auto& points = moved.surface.points;
    EXPECT_GT(dot(cross(points[b] - points[a], points[c] - points[a]),
                  wall.planes.planes[moved.surface.rest_plane[i]].normal),
              0)
        << "into the domain";
  }
}

TEST(CloseFront, IsAsExactOnPlanesAlongNoAxis) {
  for (const gallery::Move& move : gallery::moves(2)) {
    mesh::SurfaceMesh surface = subdivided(subdivided(box({0, 0, 0}, {1, 2, 1})));
    paint(surface, "sides", [&](const Vec3& p) { return p.z() > 0 && p.z() < 1; });
    const surface::OpenWall wall = Closed(move(surface), {{"sides", SideRole::Opening}}, FluidSide::Inside).open();
    ASSERT_EQ(wall.planes.planes.size(), 4u) << move.name;
    const gallery::Rotation rotate(move.seed);
    const Vec3 up = rotate(Vec3(0, 0, 1));
    const double base = dot(move(box({0, 0, 0}, {1, 1, 1})).points[VertexId(0)], up);
    const double raised = 0.25 * move.scale;
    Moved moved(wall.surface,
                [&](const Vec3& p) { return dot(p, up) - base < 0.01 * move.scale ? p + up * raised : p; });
    EXPECT_TRUE(close_front(moved.front, wall.planes, moved.surface).empty()) << move.name;
    expect_closed(moved.surface);
    const double volume = move.scale * move.scale * move.scale;
    EXPECT_NEAR(fluid_volume(moved.surface), 1.5 * volume, 1e-9 * volume) << move.name;
  }
}

std::set<FrontFaceId> named(const std::vector<FrontFaceId>& faces) {
  EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
  return {faces.begin(), faces.end()};
}

TEST(CloseFront, NamesFacesThatRoseThroughTheCeiling) {
  const surface::OpenWall wall = room(1, 1);
  Moved moved(wall.surface, [&](const Vec3& p) { return p.z() == 0 ? Vec3(p.x(), p.y(), 1.5) : p; });
  const auto blamed = named(close_front(moved.front, wall.planes, moved.surface));
  EXPECT_FALSE(blamed.empty());
  for (const FrontFaceId f : blamed) {
    ASSERT_LT(f.index(), wall.surface.faces.size());
    const auto triangle = wall.surface.triangle(FaceId(f.index()));
    EXPECT_TRUE(std::any_of(triangle.begin(), triangle.end(), [](const Vec3& p) {
      return p.x() == 0 || p.x() == 1 || p.y() == 0 || p.y() == 2;
    })) << "at the sides";
  }
}

TEST(CloseFront, NamesTheFacesWhoseEdgesCross) {
  const surface::OpenWall wall = room(2, 1);
  // Of the points x = 0, 1/4, 1/2, 3/4, 1 of the floor's edge on y = 0 the third and the fourth change places: the edge
  // before them crosses the one behind.
  Moved moved(wall.surface, [&](const Vec3& p) {
    if (p == Vec3(0.5, 0, 0)) return Vec3(0.9, 0, 0.4);
    if (p == Vec3(0.75, 0, 0)) return Vec3(0.5, 0, 0.4);
    return p.z() == 0 ? Vec3(p.x(), p.y(), 0.25) : p;
  });
  const auto blamed = named(close_front(moved.front, wall.planes, moved.surface));
  std::set<FrontFaceId> expected;
  for (const HalfedgeId h : wall.planes.of_edge.ids()) {
    if (wall.planes.of_edge[h] == mesh::kNoPlane) continue;
    const auto& corners = wall.surface.faces[FaceId(h.index() / 3)];
    const Vec3 &a = wall.surface.points[corners[h.index() % 3]], &b = wall.surface.points[corners[(h.index() + 1) % 3]];
    const double middle = 0.5 * (a.x() + b.x());
    const bool is_there = a.y() == 0 && b.y() == 0 && a.z() == 0 && b.z() == 0;
    if (is_there && (middle == 0.375 || middle == 0.875)) expected.insert(FrontFaceId(h.index() / 3));
  }
  EXPECT_EQ(expected.size(), 2u);
  EXPECT_EQ(blamed, expected);
  for (const mesh::PlaneIndex p : moved.surface.rest_plane) {
    EXPECT_FALSE(wall.planes.planes[p].normal == Vec3(0, 1, 0)) << "that plane is not closed";
  }
}

/// Front faces that meet the rest of a plane are paired with themselves.
TEST(CloseFront, LetsTheFrontBeHeldAgainstTheRestOfPlanes) {
  const surface::OpenWall wall = room(2, 1);
  // A point inside the floor goes through the side y = 0.
  const Vec3 jumper(0.5, 0.5, 0), beyond(0.5, -0.3, 0.6);
  Moved moved(wall.surface, [&](const Vec3& p) {
    if (p == jumper) return beyond;
    return p.z() == 0 ? Vec3(p.x(), p.y(), 0.25) : p;
  });
  ASSERT_TRUE(close_front(moved.front, wall.planes, moved.surface).empty());
  expect_closed(moved.surface);
  const auto pairs = front_intersections(moved.surface);
  std::set<FrontFaceId> with_themselves;
  for (const auto& [a, b] : pairs) {
    if (a == b) with_themselves.insert(a);
  }
  EXPECT_FALSE(with_themselves.empty());
  for (const FrontFaceId f : with_themselves) {
    const auto triangle = wall.surface.triangle(FaceId(f.index()));
    EXPECT_NE(std::find(triangle.begin(), triangle.end(), jumper), triangle.end());
  }
}

/// Edges of a plane's trace as pairs of positions.
TEST(PlaneTraces, AreTheMovedEdgesSeenFromTheRest) {
  const surface::OpenWall wall = room(1, 1);
  const double raised = 0.25;
  const Moved moved(wall.surface, [&](const Vec3& p) { return p.z() == 0 ? Vec3(p.x(), p.y(), raised) : p; });
  const auto traces = plane_traces(moved.front, wall.planes, moved.surface);
  ASSERT_EQ(traces.size(), 4u);
  for (std::size_t p = 0; p < 4; ++p) {
    const mesh::SidePlane& plane = wall.planes.planes[p];
    EXPECT_EQ(traces[p].size(), 4u) << "two on the floor, two on the ceiling";
    for (const TraceEdge& edge : traces[p]) {
      const Vec3 &a = moved.surface.points[edge.points[0]], &b = moved.surface.points[edge.points[1]];
      EXPECT_EQ(plane.height(a), 0);
      EXPECT_EQ(plane.height(b), 0);
      const Vec3 left = cross(plane.normal, b - a);
      EXPECT_GT(dot(left, Vec3(0.5, 1, 0.6) - a), 0) << "the rest lies to the left";
      EXPECT_EQ(a.z(), b.z());
      EXPECT_TRUE(a.z() == raised || a.z() == 1);
    }
  }
}

TEST(CloseFront, WantsAnOuterEdgeRoundACutBody) {
  const Closed closed(shapes::make_shape("onera-m6", {{"half", 1}}, 0.1), {{"root", SideRole::Symmetry}},
                      FluidSide::Outside);
  const surface::OpenWall wall = closed.open();
  Moved moved(wall.surface, stay);
  EXPECT_FALSE(close_front(moved.front, wall.planes, moved.surface).empty()) << "the plane goes on without end";
}

TEST(CloseFront, HasNothingToDoWithoutPlanes) {
  const mesh::SurfaceMesh surface = cube();
  Moved moved(surface, stay);
  EXPECT_TRUE(close_front(moved.front, {}, moved.surface).empty());
  EXPECT_EQ(moved.surface.triangles.size(), surface.faces.size());
  EXPECT_TRUE(moved.surface.rest_plane.empty());
}

/// A body in the room, off its walls.
struct RoomWithBody {
  surface::OpenWall wall;
  IdVector<FaceId, ComponentId> components;

  explicit RoomWithBody(const Vec3& centre) {
    mesh::SurfaceMesh surface = subdivided(subdivided(box({0, 0, 0}, {1, 2, 1})));
    paint(surface, "sides", [](const Vec3& p) { return p.z() > 0 && p.z() < 1; });
    surface = joined(surface, flipped(cube(0.05, centre)));
    wall = Closed(surface, {{"sides", SideRole::Opening}}, FluidSide::Inside).open();
    components = mesh::connected_components(mesh::Topology(wall.surface));
  }
};

TEST(CoveredTwice, CountsWhatTheRestOfPlanesJoinsAsOne) {
  const RoomWithBody room({0.5, 1, 0.6});
  Moved moved(room.wall.surface, [&](const Vec3& p) { return p.z() == 0 ? Vec3(p.x(), p.y(), 0.25) : p; });
  ASSERT_TRUE(close_front(moved.front, room.wall.planes, moved.surface).empty());
  EXPECT_TRUE(front_intersections(moved.surface).empty());
  EXPECT_TRUE(covered_twice(moved.front, moved.surface, room.components, true).empty());
}

TEST(CoveredTwice, NamesABodyThatTheFloorsLayersSwallowed) {
  const RoomWithBody room({0.5, 1, 0.2});
  Moved moved(room.wall.surface, [&](const Vec3& p) { return p.z() == 0 ? Vec3(p.x(), p.y(), 0.5) : p; });
  ASSERT_TRUE(close_front(moved.front, room.wall.planes, moved.surface).empty());
  EXPECT_TRUE(front_intersections(moved.surface).empty());
  const auto wrong = covered_twice(moved.front, moved.surface, room.components, true);
  const ComponentId body = room.components.raw().back();
  EXPECT_NE(std::find(wrong.begin(), wrong.end(), body), wrong.end());
}

}  // namespace
}  // namespace nearwall::certify

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "layers/cut_wall.h"
#include "layers/fan_trial.h"
#include "layers/fans.h"
#include "layers/vertex_field.h"
#include "nearwall/geometry/angles.h"
#include "tests/mesh/cell_faces.h"
#include "tests/support/gallery.h"

namespace nearwall::layers {
namespace {

using growing_for_tests::geometric;
using growing_for_tests::options_for;
using growing_for_tests::TestWall;

/// A body with its layers grown.
struct Grown {
  explicit Grown(mesh::SurfaceMesh surface, double multi_angle_deg = 100, int n_layers = 6, double max_turn_deg = 45)
      : wall(std::move(surface)) {
    const double thickness = 0.01 * gallery::diagonal(wall.surface());
    GrowOptions options = options_for(wall.surface(), geometric(thickness, 1.2, n_layers));
    options.multi_angle = geometry::to_radians(multi_angle_deg);
    options.max_turn = geometry::to_radians(max_turn_deg);
    growth = grow(wall.wall(), options);
  }

  std::size_t n_lines(VertexId v) const { return growth.front.n_lines(v); }
  certify::Certificate certificate() const {
    return certify::certify_layers(mesh::LayerMesh(growth.front, growth.lines), wall.certified_wall());
  }

  TestWall wall;
  Growth growth;
};

Vec3 direction(const Growth& growth, LineId line) {
  return normalized(growth.lines.pieces[growth.lines.first_piece[line.index()]].direction);
}

TEST(Fans, TurnAboutATrailingEdgeInEqualAngles) {
  for (const double angle : {2.0, 5.0, 10.0, 20.0, 60.0}) {
    const Grown wedge(gallery::catalogued("wedge", {{"angle", angle}}, 0.15));
    ASSERT_TRUE(wedge.certificate().is_valid());
    const std::size_t expected = static_cast<std::size_t>(std::ceil((180 - angle) / 45)) + 1;
    std::size_t n_fans = 0;
    for (std::size_t i = wedge.growth.front.n_wall_faces; i < wedge.growth.front.faces.size(); ++i) {
      const mesh::FrontFace& quad = wedge.growth.front.faces[FrontFaceId(i)];
      const VertexId v = wedge.growth.front.line_vertex[quad.lines[0]];
      const Vec3& p = wedge.wall.surface().points[v];
      // Inner points of the trailing edge: at its ends the edges of the sides come in.
      if (quad.size() != 4 || wedge.wall.surface().points[wedge.growth.front.line_vertex[quad.lines[2]]].x() != p.x() ||
          wedge.n_lines(v) != expected) {
        continue;
      }
      ++n_fans;
      const double turn =
          geometry::angle_between(direction(wedge.growth, quad.lines[0]), direction(wedge.growth, quad.lines[1]));
      EXPECT_NEAR(geometry::to_degrees(turn), (180 - angle) / double(expected - 1), 1e-6);
    }
    EXPECT_GT(n_fans, 0u) << angle;
  }
}

TEST(Fans, OfACubeAreThreeLinesAndFourTrianglesAtACorner) {
  const Grown cube(gallery::catalogued("cube", {}, 0.25), 80);
  ASSERT_TRUE(cube.certificate().is_valid());
  std::map<std::size_t, int> vertices;
  for (const VertexId v : cube.wall.surface().points.ids()) ++vertices[cube.n_lines(v)];
  EXPECT_EQ(vertices[6], 8) << "three faces and three edges";
  EXPECT_EQ(vertices[3] % 12, 0) << "as many on each edge";
  EXPECT_GT(vertices[3], 0);
  std::size_t n_triangles = 0, n_quads = 0;
  for (std::size_t i = cube.growth.front.n_wall_faces; i < cube.growth.front.faces.size(); ++i) {
    (cube.growth.front.faces[FrontFaceId(i)].size() == 3 ? n_triangles : n_quads) += 1;
  }
  EXPECT_EQ(n_triangles, 8u * 4u);
  EXPECT_EQ(n_quads, 2u * (static_cast<std::size_t>(vertices[3]) + 12u)) << "two over each edge of a ridge";
}

TEST(Fans, FitTogetherFaceToFaceWithTheirCaps) {
  for (const auto& shape : gallery::shapes()) {
    if (shape.fluid_is_inside) continue;
    const Grown body(gallery::into_the_fluid(shape), 80, 3);
    const mesh::LayerMesh layers(body.growth.front, body.growth.lines);
    auto faces = mesh::oriented_faces(layers);
    for (const FrontFaceId f : layers.caps()) {
      const mesh::Cap cap = *mesh::cap_over(body.growth.front, body.growth.lines, f);
      mesh::NodeCycle base;
      for (const auto& node : cap.base) base.push_back(layers.node(node));
      EXPECT_EQ(faces[mesh::canonical(base)], 1) << shape.name << ": a cap sits on the outer face of a cell";
    }
    const std::size_t n_caps = layers.caps().size();
    std::size_t n_open_quads = 0;
    for (const auto& [face, count] : faces) {
      ASSERT_EQ(count, 1) << shape.name;
      n_open_quads += face.size() == 4 && !faces.contains(mesh::reversed(face));
    }
    EXPECT_EQ(n_open_quads, n_caps) << shape.name << ": no other quad is left open";
  }
}

TEST(Fans, EndInALineThatStartsLate) {
  const Grown body(gallery::catalogued("fin-on-plate", {}, 0.2));
  ASSERT_TRUE(body.certificate().is_valid());
  std::size_t n_late = 0;
  for (const VertexId v : body.wall.surface().points.ids()) {
    const mesh::Window window = body.growth.lines.windows[body.growth.front.line_of(v)];
    if (window.start == 0) continue;
    ++n_late;
    EXPECT_EQ(window.start, 1);
    EXPECT_EQ(body.n_lines(v), 1u);
  }
  EXPECT_EQ(n_late, 2u) << "where the leading and the trailing edge of the fin meet the plate";
}

TEST(Fans, EndBeforeAPatchWithOneLayer) {
  // The late line at the foot of the fin would have no level to go to: the fan ends a point above.
  const TestWall wall(gallery::catalogued("fin-on-plate", {}, 0.2));
  const mesh::SurfaceMesh& surface = wall.surface();
  GrowOptions options = options_for(surface, geometric(0.02, 1.2, 6));
  for (const PatchId p : surface.patch_names.ids()) {
    if (surface.patch_names[p] == "plate") options.schedules[p].heights = {0.02};
  }
  const Growth growth = grow(wall.wall(), options);
  for (const mesh::Window& window : growth.lines.windows) EXPECT_TRUE(window.moves());
  EXPECT_GT(growth.front.faces.size(), growth.front.n_wall_faces);
}

TEST(Fans, AreNotLaidForOneLayer) {
  const TestWall wall(gallery::catalogued("wedge", {{"angle", 10}}, 0.2));
  const Growth growth = grow(wall.wall(), options_for(wall.surface(), {0.01}));
  EXPECT_EQ(growth.front.faces.size(), growth.front.n_wall_faces);
  for (const mesh::Window& window : growth.lines.windows) EXPECT_TRUE(window.moves());
}

TEST(Fans, StayOnTheWettedComponents) {
  TestWall wall(gallery::catalogued("wedge", {{"angle", 10}}, 0.2));
  for (char& wetted : wall.is_wetted()) wetted = 0;
  const Growth growth = grow(wall.wall(), options_for(wall.surface(), geometric(0.02, 1.2, 6)));
  EXPECT_EQ(growth.front.faces.size(), growth.front.n_wall_faces);
}

TEST(Fans, RunOverTheOutsideOfAKnifeEdge) {
  // A turn of 179.9 degrees: the straight arc from one side to the other might run through the blade.
  const Grown knife(gallery::catalogued("wedge", {{"angle", 0.5}}, 0.1), 100, 3);
  ASSERT_TRUE(knife.certificate().is_valid());
  std::size_t n_fans = 0;
  for (const VertexId v : knife.wall.surface().points.ids()) {
    if (knife.n_lines(v) != 5) continue;
    ++n_fans;
    const std::uint32_t first = knife.growth.front.first_line[v.index()];
    for (std::uint32_t i = first + 2; i < first + 5; ++i) EXPECT_GT(direction(knife.growth, LineId(i)).x(), 0.6);
  }
  EXPECT_GT(n_fans, 0u);
}

TEST(Fans, LeaveACornerThatNoDirectionSees) {
  const Grown body(shapes_for_tests::blind_corner());
  ASSERT_TRUE(body.certificate().is_valid());
  for (const mesh::Window& window : body.growth.lines.windows) EXPECT_EQ(window.end, 6);
}

/// Two tetrahedra through each other: at each of six vertices four convex ridges and four valleys meet in turn.
mesh::SurfaceMesh stella_octangula() {
  std::vector<Vec3> points;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) points.emplace_back(x, y, z);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double s : {-1.0, 1.0}) {
      Vec3 p;
      p[axis] = s;
      points.push_back(p);
    }
  }
  std::vector<shapes_for_tests::Corners> faces;
  for (std::size_t tip = 0; tip < 8; ++tip) {
    std::array<std::size_t, 3> foot{};  // the corners of the octahedron's face below the tip, along x, y, z
    for (int axis = 0; axis < 3; ++axis) {
      foot[static_cast<std::size_t>(axis)] = 8 + 2 * static_cast<std::size_t>(axis) + (points[tip][axis] > 0 ? 1 : 0);
    }
    const bool is_even = points[tip].x() * points[tip].y() * points[tip].z() > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = foot[k], b = foot[(k + 1) % 3];
      faces.push_back(is_even ? shapes_for_tests::Corners{tip, a, b} : shapes_for_tests::Corners{tip, b, a});
    }
  }
  return shapes_for_tests::make_surface(points, faces);
}

TEST(Fans, OfCrossingRidgesDoNotRunThroughEachOther) {
  const Grown body(stella_octangula());
  ASSERT_TRUE(body.certificate().is_valid());
  EXPECT_EQ(body.growth.rounds, 0);
  for (const mesh::Window& window : body.growth.lines.windows) EXPECT_EQ(window.end, 6);
}

TEST(Fans, NameVerticesRoundWhichTheyTurnTheWrongWay) {
  const TestWall wall(gallery::catalogued("wedge", {{"angle", 10}}, 0.2));
  const GrowOptions options = options_for(wall.surface(), {0.01, 0.01});
  const Wall seen = wall.wall();
  const CutWall cut(seen, find_cuts(seen, options));
  IdVector<VertexId, Vec3> normal;
  for (const auto& n : surface::point_normals(cut.surface(), cut.topology(), cut.features())) {
    normal.push_back(n.direction);
  }
  EXPECT_TRUE(Fans(seen, cut, normal, options.max_turn).twisted().empty());
  VertexId inner;
  for (const VertexId v : wall.surface().points.ids()) {
    if (cut.n_copies(v) == 2) inner = v;
  }
  ASSERT_TRUE(inner.is_valid());
  std::swap(normal[cut.first_copy(inner)], normal[VertexId(cut.first_copy(inner).index() + 1)]);
  EXPECT_EQ(Fans(seen, cut, normal, options.max_turn).twisted(), std::vector<VertexId>{inner});
}

TEST(FanTrial, FindsTheVertexWhoseLinesTurnTheWrongWay) {
  TestWall wall(gallery::catalogued("wedge", {{"angle", 10}}, 0.2));
  GrowOptions options = options_for(wall.surface(), {0.01, 0.01});
  options.filter = surface::SmoothingFilter::None;
  const Stacks stacks(options.schedules);
  VertexField field = ask(wall.wall(), options, stacks);
  IdVector<VertexId, surface::PointNormal> normals;
  int sweeps = 0;
  LinePlan plan = set_lines(wall.wall(), options, find_cuts(wall.wall(), options), field, normals, sweeps);
  EXPECT_TRUE(find_unfit(wall.wall(), plan).empty());
  VertexId fan;
  for (const VertexId v : wall.surface().points.ids()) {
    if (plan.front.n_lines(v) == 5) fan = v;
  }
  ASSERT_TRUE(fan.is_valid());
  const std::uint32_t first = plan.front.first_line[fan.index()];
  std::swap(plan.direction[LineId(first + 2)], plan.direction[LineId(first + 3)]);
  const auto unfit = find_unfit(wall.wall(), plan);
  EXPECT_TRUE(std::find(unfit.begin(), unfit.end(), fan) != unfit.end());
  // It and its two neighbours along the edge: the cells between them have both ends' lines.
  EXPECT_GE(unfit.size(), 1u);
  EXPECT_LE(unfit.size(), 3u);
}

}  // namespace
}  // namespace nearwall::layers

#include "nearwall/layers/grow.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "tests/layers/bodies_beside_a_fan.h"
#include "tests/support/gallery.h"

namespace nearwall::layers {
namespace {

using growing_for_tests::geometric;
using growing_for_tests::options_for;
using growing_for_tests::TestWall;
using mesh::LimitReason;

TEST(Grow, MakesTheOffsetOfACubeWithSharpEdges) {
  const mesh::SurfaceMesh cube = shapes_for_tests::cube();
  const TestWall wall(cube);
  const Growth growth = grow(wall.wall(), options_for(cube, geometric(0.25, 1.2, 10)));
  for (const LineId line : growth.lines.base.ids()) {
    const Vec3 end = growth.lines.position(line, 10);
    EXPECT_NEAR(max_norm(end), 0.75, 1e-12);
    EXPECT_NEAR(std::abs(end.x()), 0.75, 1e-12);
    EXPECT_NEAR(std::abs(end.y()), 0.75, 1e-12);
  }
}

TEST(Grow, KeepsTheFirstHeightOfASphereToThreeThousandths) {
  const mesh::SurfaceMesh sphere = shapes_for_tests::sphere(4);
  const TestWall wall(sphere);
  const auto heights = geometric(0.01, 1.2, 20);
  const Growth growth = grow(wall.wall(), options_for(sphere, heights));
  for (const FaceId f : sphere.faces.ids()) {
    const auto t = sphere.triangle(f);
    const Vec3 normal = geometry::triangle_normal(t[0], t[1], t[2]);
    double mean = 0;
    for (const VertexId v : sphere.faces[f]) {
      mean += dot(growth.lines.position(LineId(v.index()), 1) - sphere.points[v], normal) / 3;
    }
    EXPECT_NEAR(mean, heights[0], 0.003 * heights[0]);
  }
}

TEST(Grow, EndsWithPyramidsAndTetrahedraAtAPatchWithoutLayers) {
  const mesh::SurfaceMesh cube = gallery::catalogued("cube", {}, 0.2);
  const TestWall wall(cube);
  GrowOptions options = options_for(cube, geometric(0.05, 1.2, 5));
  options.schedules[PatchId(0)].has_layers = false;
  const Growth growth = grow(wall.wall(), options);
  const mesh::LayerMesh layers(growth.front, growth.lines);
  EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
  EXPECT_GT(layers.n_cells_by_type()[static_cast<std::size_t>(mesh::CellType::Pyramid)], 0u);
  EXPECT_GT(layers.n_cells_by_type()[static_cast<std::size_t>(mesh::CellType::Tetrahedron)], 0u);
  for (const FaceId f : cube.faces.ids()) {
    const bool is_without = cube.face_patch[f] == PatchId(0);
    const FrontFaceId column(f.index());
    if (!is_without) continue;
    EXPECT_EQ(layers.column_offset(column), layers.column_end(column));
    for (const VertexId v : cube.faces[f]) {
      EXPECT_EQ(growth.lines.windows[LineId(v.index())], mesh::Window{});
    }
  }
}

TEST(Grow, BlocksAVertexThatNoDirectionSees) {
  const mesh::SurfaceMesh surface = shapes_for_tests::blind_corner();
  const auto at_origin = std::find(surface.points.begin(), surface.points.end(), Vec3()) - surface.points.begin();
  const LineId blind(static_cast<std::size_t>(at_origin));
  const TestWall wall(surface);
  GrowOptions options = options_for(surface, geometric(0.01, 1.2, 5));
  options.several_lines = false;
  const Growth growth = grow(wall.wall(), options);
  EXPECT_EQ(growth.reason[blind], LimitReason::Visibility);
  EXPECT_FALSE(growth.lines.windows[blind].moves());
  EXPECT_FALSE(growth.normals[VertexId(blind.index())].is_visible);
  const mesh::LayerMesh layers(growth.front, growth.lines);
  EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
  EXPECT_GT(layers.n_cells(), 0u) << "its neighbours grow all the same";
}

TEST(Grow, LeavesUnreachedComponentsAlone) {
  const auto hollow = shapes_for_tests::joined(shapes_for_tests::sphere(3, 2.0),
                                               shapes_for_tests::flipped(shapes_for_tests::sphere(3)));
  TestWall wall(hollow);
  const std::size_t n_outer = hollow.faces.size() / 2;
  for (std::size_t f = n_outer; f < hollow.faces.size(); ++f) wall.is_wetted()[FaceId(f)] = 0;
  const Growth growth = grow(wall.wall(), options_for(hollow, geometric(0.1, 1.2, 5)));
  const mesh::LayerMesh layers(growth.front, growth.lines);
  EXPECT_EQ(layers.n_cells(), 5 * n_outer);
  EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
}

TEST(Grow, BlocksWhatDoublesCannotResolve) {
  const auto far_away = shapes_for_tests::translated(shapes_for_tests::sphere(2), {1e9, 0, 0});
  const TestWall wall(far_away);
  const Growth growth = grow(wall.wall(), options_for(far_away, geometric(1e-6, 1.2, 3)));
  for (const LineId line : growth.lines.base.ids()) {
    EXPECT_FALSE(growth.lines.windows[line].moves());
    EXPECT_EQ(growth.reason[line], LimitReason::Quality);
  }
}

TEST(Grow, KeepsASmallBodyOutOfTheLayersOfALargeOne) {
  // The small one hides between the rays of the large one's lines: only the count of covers can tell.
  const auto surface =
      shapes_for_tests::joined(shapes_for_tests::cube(), shapes_for_tests::sphere(1, 0.01, {0.09, 0.17, 0.6}));
  const TestWall wall(surface);
  const Growth growth = grow(wall.wall(), options_for(surface, geometric(0.4, 1.2, 8)));
  const mesh::LayerMesh layers(growth.front, growth.lines);
  EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
  EXPECT_GT(layers.n_cells(), 0u);
}

TEST(Grow, KeepsASmallBodyOutOfAFan) {
  const TestWall wall(shapes_for_tests::bodies_beside_a_fan());
  GrowOptions options = options_for(wall.surface(), std::vector<double>(20, 9.8495413670741208));
  options.multi_angle = geometry::to_radians(65.763671570257216);
  options.schedules[PatchId(0)].max_level_step = 2;
  const Growth growth = grow(wall.wall(), options);
  const mesh::LayerMesh layers(growth.front, growth.lines);
  EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
}

TEST(Grow, LosesLayersAtAHairGapOnly) {
  const auto cubes = shapes_for_tests::joined(shapes_for_tests::cube(), shapes_for_tests::cube(0.5, {1 + 1e-12, 0, 0}));
  const TestWall wall(cubes);
  const Growth growth = grow(wall.wall(), options_for(cubes, geometric(0.01, 1.2, 10)));
  const mesh::LayerMesh layers(growth.front, growth.lines);
  EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
  for (const VertexId v : cubes.points.ids()) {
    const double x = cubes.points[v].x();
    const bool at_the_gap = x > 0.4 && x < 0.6;
    EXPECT_EQ(growth.lines.windows[LineId(v.index())].moves(), !at_the_gap);
    EXPECT_EQ(growth.reason[LineId(v.index())], at_the_gap ? LimitReason::Gap : LimitReason::None);
  }
}

TEST(Grow, EndsAtOnceWithoutPatience) {
  // Edges that cross half way between their vertices need several rounds; with none to spare both components are
  // blocked, and no other.
  const auto surface =
      shapes_for_tests::joined(shapes_for_tests::crossed_edges(0.1), shapes_for_tests::sphere(2, 1.0, {100, 0, 0}));
  const TestWall wall(surface);
  GrowOptions options = options_for(surface, geometric(1, 1.3, 8));
  EXPECT_GT(grow(wall.wall(), options).rounds, 1);
  options.patient_rounds = 0;
  const Growth growth = grow(wall.wall(), options);
  EXPECT_EQ(growth.rounds, 1);
  for (const LineId line : growth.lines.base.ids()) {
    EXPECT_EQ(growth.lines.windows[line].moves(), growth.lines.base[line].x() > 50);
  }
  EXPECT_TRUE(certify::certify_layers(mesh::LayerMesh(growth.front, growth.lines), wall.certified_wall()).is_valid());
}

TEST(Grow, ClosesUpToRoundingOnAFlatTiltedBody) {
  // A hundred millionth as thick as it is wide: the cones over its faces about its centre have next to no height.
  const Vec3 a(-0.16474081235394661, 0.29221463537269871, 0.94205683035524068);
  const Vec3 b(-1.0644317871089533, 0.63914409393967131, 0.67711136290426943);
  const Vec3 c(-0.89969098283997051, 0.34692944074282539, -0.26494546333598251);
  const auto surface =
      shapes_for_tests::make_surface({{0, 0, 0}, a, b, c}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
  const TestWall wall(surface);
  const Growth growth = grow(wall.wall(), options_for(surface, geometric(3e-10, 1, 3)));
  const auto certificate = certify::certify_layers(mesh::LayerMesh(growth.front, growth.lines), wall.certified_wall());
  EXPECT_TRUE(certificate.is_valid());
  EXPECT_LT(certificate.closure(), 1e-12);
}

TEST(Grow, RefusesAnglesThatAreNone) {
  const mesh::SurfaceMesh cube = shapes_for_tests::cube();
  const TestWall wall(cube);
  GrowOptions options = options_for(cube, {0.1});
  for (const double turn : {-1.0, 0.0, 1.6, std::nan("")}) {
    options.max_turn = turn;
    EXPECT_THROW(grow(wall.wall(), options), InputError) << turn;
  }
  options = options_for(cube, {0.1});
  options.multi_angle = std::nan("");
  EXPECT_THROW(grow(wall.wall(), options), InputError);
  options = options_for(cube, {0.1});
  options.schedules[PatchId(0)].max_level_step = 0;
  EXPECT_THROW(grow(wall.wall(), options), InputError);
}

TEST(Grow, RefusesSchedulesThatAreNone) {
  const mesh::SurfaceMesh cube = shapes_for_tests::cube();
  const TestWall wall(cube);
  EXPECT_THROW(grow(wall.wall(), GrowOptions()), InputError);
  EXPECT_THROW(grow(wall.wall(), options_for(cube, {})), InputError);
  EXPECT_THROW(grow(wall.wall(), options_for(cube, {0.1, 0})), InputError);
  EXPECT_THROW(grow(wall.wall(), options_for(cube, std::vector<double>(65535, 1e-9))), InputError);
}

TEST(Grow, GivesEachPatchItsOwnNumberOfLayers) {
  const mesh::SurfaceMesh box = gallery::catalogued("box", {}, 0.1);
  const TestWall wall(box);
  GrowOptions options = options_for(box, geometric(0.02, 1.2, 10));
  options.schedules[PatchId(0)].heights = geometric(0.02, 1.2, 4);
  const Growth growth = grow(wall.wall(), options);
  const mesh::LayerMesh layers(growth.front, growth.lines);
  EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
  for (const FaceId f : box.faces.ids()) {
    Level least = 100, most = 0;
    for (const VertexId v : box.faces[f]) {
      const Level end = growth.lines.windows[LineId(v.index())].end;
      least = std::min(least, end);
      most = std::max(most, end);
    }
    EXPECT_LE(most, box.face_patch[f] == PatchId(0) ? 4 : 10);
    EXPECT_GE(least, 4);
  }
}

}  // namespace
}  // namespace nearwall::layers

#include <cmath>

#include <gtest/gtest.h>

#include "tests/layers/asked.h"

namespace nearwall::layers {
namespace {

using growing_for_tests::options_for;
using growing_for_tests::TestWall;

TEST(SetLines, StretchesLinesSoThatHeightsAreNormalToTheWall) {
  const Asked a(shapes_for_tests::cube(), 0.01);
  // At a corner of a cube the line makes the same angle with three faces, of cosine 1 / √3.
  ASSERT_EQ(a.plan.stretch.size(), a.wall.surface().points.size());
  for (const double stretch : a.plan.stretch) EXPECT_NEAR(stretch, std::sqrt(3.0), 1e-12);
}

TEST(LimitByCurvature, StopsTheInsideOfASphereBeforeItsCentre) {
  const mesh::SurfaceMesh sphere = shapes_for_tests::flipped(shapes_for_tests::sphere(3));
  Asked a(sphere, 2.0, true);
  EXPECT_EQ(limit_by_curvature(a.wall.wall(), a.plan, a.field).size(), sphere.points.size());
  for (const VertexId v : sphere.points.ids()) {
    EXPECT_LT(a.field.thickness[v] * a.plan.stretch[LineId(v.index())], 1.0) << "the radius";
    EXPECT_GT(a.field.thickness[v], 0.2);
    EXPECT_EQ(a.field.reason[v], mesh::LimitReason::Curvature);
  }
}

TEST(LimitByCurvature, LeavesConvexBodiesAlone) {
  Asked a(shapes_for_tests::sphere(3), 5.0);
  EXPECT_TRUE(limit_by_curvature(a.wall.wall(), a.plan, a.field).empty());
}

TEST(LimitByCurvature, LowersTheTwoLinesThatCrossAndNotTheFarOne) {
  // A plate with a narrow slit in its top: lines lean into the slit from both of its sides, none far from it.
  Asked a(gallery::catalogued("groove", {}, 0.5), 0.2);
  const auto& surface = a.wall.surface();
  const auto lowered = limit_by_curvature(a.wall.wall(), a.plan, a.field);
  ASSERT_FALSE(lowered.empty());
  for (const FaceId f : surface.faces.ids()) {
    std::array<Vec3, 3> swept;
    for (std::size_t k = 0; k < 3; ++k) {
      const LineId line = a.plan.front.faces[FrontFaceId(f.index())].lines[k];
      const VertexId v = surface.faces[f][k];
      swept[k] = surface.points[v] + a.plan.direction[line] * (a.plan.stretch[line] * a.field.thickness[v]);
    }
    // The top of the thick wedge keeps its orientation.
    const auto t = surface.triangle(f);
    const Vec3 before = cross(t[1] - t[0], t[2] - t[0]), after = cross(swept[1] - swept[0], swept[2] - swept[0]);
    EXPECT_GT(dot(before, after), 0);
  }
  std::size_t n_mixed = 0;
  for (const FaceId f : surface.faces.ids()) {
    std::size_t n_full = 0;
    for (const VertexId v : surface.faces[f]) n_full += a.field.thickness[v] == a.field.asked[v];
    n_mixed += n_full == 1;
  }
  EXPECT_GT(n_mixed, 0u) << "triangles of which one line keeps all of its length";
}

TEST(Ask, GivesTheEdgeOfTwoPatchesTheSmallerStack) {
  mesh::SurfaceMesh cube = gallery::catalogued("cube", {}, 0.5);
  const TestWall wall(cube);
  GrowOptions options = options_for(cube, {0.1, 0.1, 0.1});
  options.schedules[PatchId(0)].heights = {0.2};
  options.schedules[PatchId(1)].has_layers = false;
  const VertexField field = ask(wall.wall(), options, Stacks(options.schedules));
  for (const VertexId v : cube.points.ids()) {
    bool on_0 = false, on_1 = false, on_others = false;
    for (const HalfedgeId h : wall.topology().fan(v)) {
      const std::uint32_t p = cube.face_patch[mesh::Topology::face(h)].index();
      on_0 = on_0 || p == 0;
      on_1 = on_1 || p == 1;
      on_others = on_others || p > 1;
    }
    const double asked = on_0 ? 0.2 : on_others ? 0.1 + 0.1 + 0.1 : 0;
    EXPECT_DOUBLE_EQ(field.asked[v], asked);
    EXPECT_EQ(field.thickness[v], on_1 ? 0 : field.asked[v]);
    EXPECT_EQ(field.reason[v] == mesh::LimitReason::PatchEdge, on_1 && asked > 0);
  }
}

}  // namespace
}  // namespace nearwall::layers

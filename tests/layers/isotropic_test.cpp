#include "nearwall/layers/isotropic.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "nearwall/core/parallel.h"
#include "tests/support/gallery.h"

// Lines that end where their layer is as high as their triangles are wide.

namespace nearwall::layers {
namespace {

using growing_for_tests::TestWall;

constexpr double kGrowth = 1.2;

/// A stack that grows by kGrowth from `first` to at least the largest isotropic height.
GrowOptions until_isotropic(const TestWall& wall, double first) {
  const auto wanted = isotropic_heights(wall.surface(), wall.topology());
  const double widest = *std::max_element(wanted.begin(), wanted.end());
  std::vector<double> heights = {first, first * kGrowth};
  while (heights.back() < widest) heights.push_back(heights.back() * kGrowth);
  GrowOptions options = growing_for_tests::options_for(wall.surface(), heights);
  for (PatchSchedule& schedule : options.schedules) schedule.is_until_isotropic = true;
  return options;
}

double mean_edge(const TestWall& wall, VertexId v) {
  double sum = 0;
  for (const HalfedgeId h : wall.topology().fan(v)) {
    sum += distance(wall.surface().points[v], wall.surface().points[wall.topology().target(h)]);
  }
  return sum / double(wall.topology().fan(v).size());
}

double last_height(const Growth& growth, LineId line) {
  const Level end = growth.lines.windows[line].end;
  return growth.lines.height(line, end) - growth.lines.height(line, static_cast<Level>(end - 1));
}

TEST(IsotropicLevel, IsTheNearestInRatio) {
  const std::vector<double> heights = growing_for_tests::geometric(1.0, kGrowth, 25);
  for (double wanted = heights.front() / 3; wanted < 3 * heights.back(); wanted *= 1.01) {
    const auto miss = [&](double h) { return std::abs(std::log(h / wanted)); };
    const auto nearest =
        std::min_element(heights.begin(), heights.end(), [&](double a, double b) { return miss(a) < miss(b); });
    const Level level = isotropic_level(heights, wanted);
    EXPECT_NEAR(miss(heights[level - 1u]), miss(*nearest), 1e-12) << wanted;
  }
  const double one[] = {3.0};
  EXPECT_EQ(isotropic_level(one, 1e9), 1);
}

TEST(IsotropicHeights, AreThoseOfTetrahedraOnEquilateralTriangles) {
  const mesh::SurfaceMesh icosahedron = shapes_for_tests::sphere(0);
  const mesh::Topology topology(icosahedron);
  const auto [a, b, c] = icosahedron.triangle(FaceId(0));
  for (const double height : isotropic_heights(icosahedron, topology)) {
    EXPECT_NEAR(height, std::sqrt(2.0 / 3.0) * distance(a, b), 1e-12);
  }
}

TEST(IsotropicHeights, AreScaledAndTurnedWithTheSurface) {
  const mesh::SurfaceMesh surface = gallery::catalogued("onera-m6", {}, 0.2);
  const auto heights = isotropic_heights(surface, mesh::Topology(surface));
  const auto scaled = shapes_for_tests::scaled(surface, 0x1p-30);
  const auto turned = shapes_for_tests::mapped(surface, [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()); });
  const auto of_scaled = isotropic_heights(scaled, mesh::Topology(scaled));
  const auto of_turned = isotropic_heights(turned, mesh::Topology(turned));
  for (const VertexId v : heights.ids()) {
    ASSERT_EQ(of_scaled[v], heights[v] * 0x1p-30);
    ASSERT_EQ(of_turned[v], heights[v]);
  }
}

TEST(UntilIsotropic, EndsWithinHalfALayerOfTheHeightWanted) {
  // Bodies whose triangles change so slowly that no neighbour holds a line back.
  for (const char* shape : {"sphere", "torus", "ellipsoid", "capsule"}) {
    const TestWall wall(gallery::catalogued(shape, {}, 0.06));
    const auto wanted = isotropic_heights(wall.surface(), wall.topology());
    const Growth growth = grow(wall.wall(), until_isotropic(wall, 1e-3));
    for (const VertexId v : wanted.ids()) {
      const LineId line = growth.front.line_of(v);
      ASSERT_EQ(growth.reason[line], mesh::LimitReason::Isotropic) << shape;
      ASSERT_LE(std::abs(std::log(last_height(growth, line) / wanted[v])), 0.5 * std::log(kGrowth) * (1 + 1e-9));
      // 0.82 of an edge, by half a layer, and by what triangles that are not equilateral are narrower than their edges.
      ASSERT_GT(last_height(growth, line), 0.6 * mean_edge(wall, v)) << shape;
      ASSERT_LT(last_height(growth, line), 1.1 * mean_edge(wall, v)) << shape;
    }
  }
}

class UntilIsotropicOnShapes : public testing::TestWithParam<gallery::Shape> {};

TEST_P(UntilIsotropicOnShapes, IsCertifiedAndStepsByOneLevelAtMost) {
  const TestWall wall(gallery::into_the_fluid(GetParam()), GetParam().fluid_is_inside);
  const double first = 1e-3 * gallery::diagonal(wall.surface());
  for (const auto& [step, on_conflict] :
       {std::pair{1, OnConflict::Auto}, std::pair{2, OnConflict::Compress}, std::pair{1, OnConflict::Stair}}) {
    GrowOptions options = until_isotropic(wall, first);
    for (PatchSchedule& schedule : options.schedules) {
      if (step > 1) schedule.max_level_step = step;
      schedule.on_conflict = on_conflict;
    }
    const Growth growth = grow(wall.wall(), options);
    const mesh::LayerMesh layers(growth.front, growth.lines);
    ASSERT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
    for (const VertexId v : wall.surface().points.ids()) {
      const LineId line = growth.front.line_of(v);
      const mesh::Window window = growth.lines.windows[line];
      ASSERT_LE(window.end, growth.asked_levels[line]);
      const bool has_all = growth.reached_thickness[line] == growth.asked_thickness[line];
      ASSERT_EQ(growth.reason[line] == mesh::LimitReason::Isotropic || growth.reason[line] == mesh::LimitReason::None,
                has_all);
      ASSERT_TRUE(!has_all || window.end == growth.asked_levels[line]);
      if (!window.moves()) continue;
      for (const HalfedgeId h : wall.topology().fan(v)) {
        const mesh::Window other = growth.lines.windows[growth.front.line_of(wall.topology().target(h))];
        ASSERT_LE(other.moves() ? window.end - other.end : 0, step);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Few, UntilIsotropicOnShapes, testing::ValuesIn(gallery::few_shapes()),
                         [](const auto& shape) { return shape.param.name; });

TEST(UntilIsotropic, LeavesLinesThatStartLateALayerToGoTo) {
  // Layers that want to end after the first one: it is the nearest to the height of the narrow triangles.
  const TestWall wall(gallery::catalogued("fin-on-sphere", {}, 0.2));
  const auto wanted = isotropic_heights(wall.surface(), wall.topology());
  const double first = *std::max_element(wanted.begin(), wanted.end());
  GrowOptions options = growing_for_tests::options_for(wall.surface(), {first, 2 * first, 4 * first});
  for (PatchSchedule& schedule : options.schedules) schedule.is_until_isotropic = true;
  const Growth growth = grow(wall.wall(), options);
  std::size_t n_late = 0;
  for (const LineId line : growth.lines.windows.ids()) {
    EXPECT_EQ(growth.asked_levels[line], 2);
    n_late += growth.lines.windows[line].start == 1 && growth.lines.windows[line].moves();
  }
  EXPECT_GT(n_late, 0u) << "fans end where the fin meets the sphere";
}

TEST(UntilIsotropic, TellsLinesThatTheCountEndsApart) {
  const TestWall wall(gallery::catalogued("sphere", {}, 0.3));
  GrowOptions options = growing_for_tests::options_for(wall.surface(), growing_for_tests::geometric(0.01, kGrowth, 4));
  options.schedules[PatchId(0)].is_until_isotropic = true;
  const Growth growth = grow(wall.wall(), options);
  for (const LineId line : growth.reason.ids()) {
    EXPECT_EQ(growth.asked_levels[line], 4);
    EXPECT_EQ(growth.reason[line], mesh::LimitReason::None) << "all layers of the count, none of them isotropic";
  }
}

TEST(UntilIsotropic, HoldsOnItsOwnPatchOnly) {
  const TestWall wall(gallery::catalogued("box", {}, 0.2));
  GrowOptions options = until_isotropic(wall, 1e-3);
  const auto fixed = growing_for_tests::geometric(0.05, kGrowth, 7);
  for (const PatchId p : {PatchId(0), PatchId(3)}) {
    options.schedules[p].heights = fixed;
    options.schedules[p].is_until_isotropic = false;
  }
  const Growth growth = grow(wall.wall(), options);
  const mesh::LayerMesh layers(growth.front, growth.lines);
  EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
  for (const FaceId f : wall.surface().faces.ids()) {
    for (const VertexId v : wall.surface().faces[f]) {
      const Level asked = growth.asked_levels[growth.front.line_of(v)];
      EXPECT_TRUE(asked == 7 || options.schedules[wall.surface().face_patch[f]].is_until_isotropic);
      for (const HalfedgeId h : wall.topology().fan(v)) {
        // Seven levels at the border, one more with each edge from there on.
        const Level other = growth.asked_levels[growth.front.line_of(wall.topology().target(h))];
        EXPECT_LE(std::abs(asked - other), 1);
      }
    }
  }
}

TEST(UntilIsotropic, IsTheSameAtAnyScaleAndOnAnyNumberOfThreads) {
  const mesh::SurfaceMesh surface = gallery::catalogued("naca", {{"span", 1.5}}, 0.15);
  const auto points = [](const mesh::SurfaceMesh& s, double first) {
    const TestWall wall(s);
    const Growth growth = grow(wall.wall(), until_isotropic(wall, first));
    std::vector<Vec3> all;
    for (const LineId line : growth.lines.base.ids()) {
      for (Level j = 0; j <= growth.lines.table.n_levels(); ++j) all.push_back(growth.lines.position(line, j));
    }
    return all;
  };
  const auto here = points(surface, 0x1p-9);
  auto far = points(shapes_for_tests::scaled(surface, 0x1p12), 0x1p3);
  for (Vec3& p : far) p *= 0x1p-12;
  EXPECT_EQ(here, far);
  const ThreadLimit limit(1);
  EXPECT_EQ(here, points(surface, 0x1p-9));
}

}  // namespace
}  // namespace nearwall::layers

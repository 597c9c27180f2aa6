#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "tests/support/gallery.h"

// First heights and thicknesses that each vertex has of its own.

namespace nearwall::layers {
namespace {

using growing_for_tests::geometric;
using growing_for_tests::TestWall;

constexpr int kLayers = 9;

mesh::SurfaceMesh with_array(mesh::SurfaceMesh surface, const std::function<double(const Vec3&)>& value) {
  mesh::PointArray array{"a", {}};
  for (const Vec3& p : surface.points) array.values.push_back(value(p));
  surface.point_arrays.push_back(std::move(array));
  return surface;
}

/// First heights that differ fourfold, thicknesses that differ twofold, at other places: thin enough for any room.
double first_height_at(const Vec3& p) { return 1e-4 * (2.5 + 1.5 * std::sin(2 * p.x())); }
double thickness_at(const Vec3& p) { return 3e-3 * (1.5 + 0.5 * std::cos(2 * p.y())); }

mesh::SurfaceMesh with_both(const mesh::SurfaceMesh& surface) {
  return with_array(with_array(surface, first_height_at), thickness_at);
}

GrowOptions options_with(const mesh::SurfaceMesh& surface, std::optional<VertexLength> first,
                         std::optional<VertexLength> total) {
  // Grows more than any vertex asks for: 6e-3 over 1e-4 is 60 first heights, this stack has 75.
  auto options = growing_for_tests::options_for(surface, geometric(1.0, 1.5, kLayers));
  for (PatchSchedule& schedule : options.schedules) {
    schedule.first_height = first;
    schedule.total_thickness = total;
  }
  return options;
}

/// Distance of a level from the wall, normal to it.
double normal_distance(const Growth& growth, LineId line, Level level) { return growth.lines.height(line, level); }

TEST(VertexLengths, OfFirstHeightsScaleTheStack) {
  const TestWall wall(with_both(gallery::catalogued("torus", {}, 0.15)));
  const auto options = options_with(wall.surface(), VertexLength{0, 2.0}, std::nullopt);
  const auto& heights = options.schedules[PatchId(0)].heights;
  const Growth growth = grow(wall.wall(), options);
  for (const VertexId v : wall.surface().points.ids()) {
    const LineId line = growth.front.line_of(v);
    const double scale = 2 * first_height_at(wall.surface().points[v]) / heights.front();
    double sum = 0;
    for (Level j = 1; j <= kLayers; ++j) {
      sum += scale * heights[j - 1u];
      ASSERT_NEAR(normal_distance(growth, line, j), sum, 1e-14 * sum);
    }
    EXPECT_EQ(growth.asked_first_height[line], normal_distance(growth, line, 1));
    EXPECT_NEAR(growth.asked_first_height[line], scale * heights.front(), 1e-15 * scale);
    EXPECT_EQ(growth.reason[line], mesh::LimitReason::None);
  }
}

TEST(VertexLengths, OfThicknessesScaleTheStack) {
  const TestWall wall(with_both(gallery::catalogued("torus", {}, 0.15)));
  const auto options = options_with(wall.surface(), std::nullopt, VertexLength{1, 1.0});
  const Growth growth = grow(wall.wall(), options);
  for (const VertexId v : wall.surface().points.ids()) {
    const LineId line = growth.front.line_of(v);
    const double thickness = thickness_at(wall.surface().points[v]);
    EXPECT_EQ(growth.asked_thickness[line], thickness);
    EXPECT_EQ(growth.reached_thickness[line], thickness);
    const double ratio = normal_distance(growth, line, kLayers) / normal_distance(growth, line, 1);
    EXPECT_NEAR(ratio, 1 / options.schedules[PatchId(0)].heights.front(), 1e-12 * ratio);
  }
}

TEST(VertexLengths, OfBothKindsAreBothMetByTheGrowth) {
  for (const char* shape : {"sphere", "torus", "ellipsoid"}) {
    const TestWall wall(with_both(gallery::catalogued(shape, {}, 0.15)));
    const Growth growth = grow(wall.wall(), options_with(wall.surface(), VertexLength{0, 1.0}, VertexLength{1, 1.0}));
    for (const VertexId v : wall.surface().points.ids()) {
      const LineId line = growth.front.line_of(v);
      const Vec3& p = wall.surface().points[v];
      ASSERT_EQ(growth.lines.windows[line].end, kLayers);
      ASSERT_NEAR(normal_distance(growth, line, 1), first_height_at(p), 1e-14 * first_height_at(p));
      ASSERT_NEAR(normal_distance(growth, line, kLayers), thickness_at(p), 1e-14 * thickness_at(p));
      double below = first_height_at(p);
      for (Level j = 2; j <= kLayers; ++j) {
        const double height =
            normal_distance(growth, line, j) - normal_distance(growth, line, static_cast<Level>(j - 1));
        ASSERT_GE(height, below * (1 - 1e-9));
        ASSERT_LE(height, below * 1.5 * (1 + 1e-9));
        below = height;
      }
    }
  }
}

TEST(VertexLengths, MayBeOneNumberForAll) {
  const TestWall wall(with_both(gallery::catalogued("sphere", {}, 0.3)));
  const Growth growth =
      grow(wall.wall(), options_with(wall.surface(), VertexLength{std::nullopt, 2e-4}, VertexLength{1, 1.0}));
  for (const VertexId v : wall.surface().points.ids()) {
    const LineId line = growth.front.line_of(v);
    EXPECT_NEAR(normal_distance(growth, line, 1), 2e-4, 1e-17);
    EXPECT_EQ(growth.reached_thickness[line], thickness_at(wall.surface().points[v]));
  }
}

TEST(VertexLengths, ThatLeaveNoRoomForTheFirstHeightMakeUniformLayers) {
  const TestWall wall(with_both(gallery::catalogued("sphere", {}, 0.3)));
  const Growth growth =
      grow(wall.wall(), options_with(wall.surface(), VertexLength{std::nullopt, 1e-2}, VertexLength{1, 1.0}));
  for (const VertexId v : wall.surface().points.ids()) {
    const LineId line = growth.front.line_of(v);
    const double thickness = thickness_at(wall.surface().points[v]);
    for (Level j = 1; j <= kLayers; ++j) {
      EXPECT_NEAR(normal_distance(growth, line, j), thickness * j / kLayers, 1e-15);
    }
    EXPECT_NEAR(growth.asked_first_height[line], thickness / kLayers, 1e-16);
  }
}

class VertexLengthsOnShapes : public testing::TestWithParam<gallery::Shape> {};

TEST_P(VertexLengthsOnShapes, AreCertifiedHoweverWildly) {
  // Tenfold from one point to the next, far beyond what grading lets stand.
  const mesh::SurfaceMesh plain = gallery::into_the_fluid(GetParam());
  const double diagonal = gallery::diagonal(plain);
  int i = 0;
  const auto wild = [&](double length) {
    return [&i, length](const Vec3&) { return length * std::pow(10.0, ++i * 7 % 5 - 2); };
  };
  const TestWall wall(with_array(with_array(plain, wild(1e-3 * diagonal)), wild(1e-2 * diagonal)),
                      GetParam().fluid_is_inside);
  using Lengths = std::pair<std::optional<VertexLength>, std::optional<VertexLength>>;
  const VertexLength first{0, 1.0}, total{1, 1.0};
  for (const auto& [h, t] : {Lengths{first, std::nullopt}, Lengths{std::nullopt, total}, Lengths{first, total}}) {
    for (const auto on_conflict : {OnConflict::Auto, OnConflict::Stair}) {
      auto options = options_with(wall.surface(), h, t);
      for (PatchSchedule& schedule : options.schedules) schedule.on_conflict = on_conflict;
      const Growth growth = grow(wall.wall(), options);
      const mesh::LayerMesh layers(growth.front, growth.lines);
      ASSERT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid());
      for (const LineId line : growth.reason.ids()) {
        ASSERT_LE(growth.reached_thickness[line], growth.asked_thickness[line]);
        ASSERT_EQ(growth.reason[line] == mesh::LimitReason::None,
                  growth.reached_thickness[line] == growth.asked_thickness[line]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Few, VertexLengthsOnShapes, testing::ValuesIn(gallery::few_shapes()),
                         [](const auto& shape) { return shape.param.name; });

TEST(VertexLengths, OfTwoPatchesGiveTheirBorderTheThinnerStack) {
  const TestWall wall(with_both(gallery::catalogued("box", {}, 0.1)));
  auto options = options_with(wall.surface(), VertexLength{0, 1.0}, std::nullopt);
  options.schedules[PatchId(0)].first_height = VertexLength{0, 0.5};
  options.schedules[PatchId(1)].first_height.reset();
  options.schedules[PatchId(1)].heights = geometric(100, 1.5, kLayers);
  options.schedules[PatchId(1)].total_thickness = VertexLength{std::nullopt, 2e-3};
  const Growth growth = grow(wall.wall(), options);
  IdVector<VertexId, double> least(wall.surface().points.size(), std::numeric_limits<double>::infinity());
  for (const FaceId f : wall.surface().faces.ids()) {
    const PatchId patch = wall.surface().face_patch[f];
    for (const VertexId v : wall.surface().faces[f]) {
      const double scale = first_height_at(wall.surface().points[v]) / geometric(1.0, 1.5, kLayers).front();
      const double thickness = patch == PatchId(1) ? 2e-3 : patch == PatchId(0) ? 0.5 * scale : scale;
      least[v] = std::min(least[v], thickness);
    }
  }
  for (const VertexId v : least.ids()) {
    EXPECT_NEAR(growth.asked_thickness[growth.front.line_of(v)], least[v], 1e-15);
  }
}

TEST(VertexLengths, AreRefusedWhereTheyAreNoLengths) {
  const mesh::SurfaceMesh box = gallery::catalogued("box", {}, 0.3);
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const TestWall wall(with_array(box, [&](const Vec3& p) { return p.x() > 0.499 ? bad : 1e-3; }));
    auto options = options_with(wall.surface(), VertexLength{0, 1.0}, std::nullopt);
    EXPECT_THROW(grow(wall.wall(), options), InputError);
    EXPECT_THROW(asked_levels(wall.wall(), options), InputError);
    for (const FaceId f : wall.surface().faces.ids()) {
      for (const Vec3& p : wall.surface().triangle(f)) {
        if (p.x() > 0.499) options.schedules[wall.surface().face_patch[f]].has_layers = false;
      }
    }
    EXPECT_TRUE(std::any_of(options.schedules.begin(), options.schedules.end(),
                            [](const PatchSchedule& s) { return s.has_layers; }));
    EXPECT_NO_THROW(grow(wall.wall(), options)) << "patches without layers ask for nothing";
  }
  const TestWall wall(box);
  EXPECT_THROW(grow(wall.wall(), options_with(box, VertexLength{0, 1.0}, std::nullopt)), InputError)
      << "there is no array";
  auto both = options_with(box, std::nullopt, VertexLength{std::nullopt, 1.0});
  both.schedules[PatchId(0)].is_until_isotropic = true;
  EXPECT_THROW(grow(wall.wall(), both), InputError);
}

TEST(VertexLengths, AreTheSameAtAnyScaleAndOnAnyNumberOfThreads) {
  const auto points = [](const mesh::SurfaceMesh& plain, double factor) {
    const TestWall wall(with_both(plain));
    const Growth growth =
        grow(wall.wall(), options_with(wall.surface(), VertexLength{0, factor}, VertexLength{1, factor}));
    std::vector<Vec3> all;
    for (const LineId line : growth.lines.base.ids()) {
      for (Level j = 0; j <= kLayers; ++j) all.push_back(growth.lines.position(line, j));
    }
    return all;
  };
  const mesh::SurfaceMesh wing = gallery::catalogued("naca", {{"span", 1.5}}, 0.15);
  const auto once = points(wing, 1.0);
  {
    const ThreadLimit limit(1);
    EXPECT_EQ(once, points(wing, 1.0));
  }
  // The array holds the same values: they are scaled by the factor, the surface by itself.
  mesh::SurfaceMesh large = with_both(wing);
  for (Vec3& p : large.points) p *= 0x1p10;
  const TestWall wall(large);
  const Growth growth = grow(wall.wall(), options_with(large, VertexLength{0, 0x1p10}, VertexLength{1, 0x1p10}));
  std::size_t k = 0;
  for (const LineId line : growth.lines.base.ids()) {
    for (Level j = 0; j <= kLayers; ++j) ASSERT_EQ(growth.lines.position(line, j) * 0x1p-10, once[k++]);
  }
}

}  // namespace
}  // namespace nearwall::layers

#include "nearwall/surface/weld.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nearwall/core/errors.h"
#include "tests/support/shapes.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;

std::vector<std::uint32_t> merged(const std::vector<Vec3>& points, double tolerance) {
  return merged_points(points, tolerance);
}

TEST(Weld, MakesASoupOfTrianglesTheSurfaceItCameFrom) {
  const mesh::SurfaceMesh sphere = shapes::sphere(3);
  const mesh::SurfaceMesh welded = weld(shapes::as_soup(sphere), 0);
  ASSERT_EQ(welded.points.size(), sphere.points.size());
  ASSERT_EQ(welded.faces.size(), sphere.faces.size());
  for (const FaceId f : sphere.faces.ids()) EXPECT_EQ(welded.triangle(f), sphere.triangle(f));
}

TEST(Weld, KeepsPatchesOfTriangles) {
  mesh::SurfaceMesh cube = shapes::as_soup(shapes::cube());
  cube.patch_names.push_back("lid");
  cube.face_patch[FaceId(7)] = PatchId(1);
  const mesh::SurfaceMesh welded = weld(cube, 0);
  EXPECT_EQ(welded.face_patch, cube.face_patch);
  EXPECT_EQ(welded.patch_names, cube.patch_names);
}

TEST(Weld, GivesMergedPointsTheSmallestOfTheirValues) {
  mesh::SurfaceMesh cube = shapes::as_soup(shapes::cube());
  const mesh::SurfaceMesh bare = weld(cube, 0);
  mesh::PointArray height{"h", IdVector<VertexId, double>(cube.points.size())};
  for (const VertexId v : cube.points.ids()) height.values[v] = 100 + cube.points[v].x();
  const auto corner_value = [&](const Vec3& p, double value) {
    for (const VertexId v : cube.points.ids()) {
      if (cube.points[v] == p) height.values[v] = value--;
    }
    return value + 1;
  };
  const Vec3 a = bare.points[VertexId(3)], b = bare.points[VertexId(6)];
  const double least = corner_value(a, 7);
  for (const VertexId v : cube.points.ids()) {
    if (cube.points[v] == b) height.values[v] = std::numeric_limits<double>::quiet_NaN();
  }
  cube.point_arrays.push_back(height);
  const mesh::SurfaceMesh welded = weld(cube, 0);
  ASSERT_EQ(welded.point_arrays.size(), 1u);
  ASSERT_EQ(welded.point_arrays[0].values.size(), welded.points.size());
  for (const VertexId v : welded.points.ids()) {
    const double value = welded.point_arrays[0].values[v];
    if (welded.points[v] == b) {
      EXPECT_TRUE(std::isnan(value));
    } else {
      EXPECT_EQ(value, welded.points[v] == a ? least : 100 + welded.points[v].x());
    }
  }
  EXPECT_LT(least, 7);
}

TEST(Weld, TakesTheArraysOfPointsThatAreUsedAlong) {
  mesh::SurfaceMesh cube = shapes::cube();
  mesh::SurfaceMesh with_more = cube;
  with_more.points = IdVector<VertexId, Vec3>();
  mesh::PointArray number{"n", {}};
  for (const Vec3& p : cube.points) {  // every other point is of no triangle
    with_more.points.push_back({9, 9, double(with_more.points.size())});
    with_more.points.push_back(p);
  }
  for (const VertexId v : with_more.points.ids()) number.values.push_back(double(v.index()));
  for (auto& face : with_more.faces) {
    for (VertexId& v : face) v = VertexId(2 * v.index() + std::size_t{1});
  }
  with_more.point_arrays.push_back(number);
  const mesh::SurfaceMesh welded = weld(with_more, 0);
  ASSERT_EQ(welded.point_arrays[0].values.size(), cube.points.size());
  for (const VertexId v : cube.points.ids()) EXPECT_EQ(welded.point_arrays[0].values[v], 2.0 * v.index() + 1);
}

TEST(Weld, TakesMinusZeroForZero) {
  EXPECT_EQ(merged({{0.0, 1, 2}, {-0.0, 1, 2}}, 0), (std::vector<std::uint32_t>{0, 0}));
}

TEST(Weld, KeepsApartWhatDiffersInTheLastBitWithoutTolerance) {
  EXPECT_EQ(merged({{1, 0, 0}, {std::nextafter(1.0, 2.0), 0, 0}}, 0), (std::vector<std::uint32_t>{0, 1}));
}

TEST(Weld, MergesPointsExactlyOneToleranceApartAndNoneFurther) {
  EXPECT_EQ(merged({{0, 0, 0}, {0.25, 0, 0}, {0, 0.25000001, 0}}, 0.25), (std::vector<std::uint32_t>{0, 0, 2}));
}

TEST(Weld, JoinsTheSmallestIdWithinTolerance) {
  EXPECT_EQ(merged({{0, 0, 0}, {1.5, 0, 0}, {0.8, 0, 0}}, 1), (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST(Weld, DoesNotChainAlongARowOfPoints) {
  std::vector<Vec3> row;
  for (int i = 0; i < 6; ++i) row.emplace_back(i, 0, 0);
  EXPECT_EQ(merged(row, 1), (std::vector<std::uint32_t>{0, 0, 2, 2, 4, 4}));
}

TEST(Weld, LeavesKeptPointsFurtherApartThanTheTolerance) {
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) points.emplace_back(std::sin(i * 12.9898), std::sin(i * 78.233), std::sin(i * 37.719));
  const double tolerance = 0.3;
  const auto kept = merged(points, tolerance);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(kept[kept[i]], kept[i]);
    EXPECT_LE(distance(points[i], points[kept[i]]), tolerance);
    for (std::size_t j = 0; j < i; ++j) {
      if (kept[i] == i && kept[j] == j) {
        EXPECT_GT(distance(points[i], points[j]), tolerance);
      }
    }
  }
}

TEST(Weld, IsTheSameAtEveryScaleAndWithAxesPermuted) {
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i) points.emplace_back(std::sin(i * 12.9898), std::sin(i * 78.233), std::sin(i * 37.719));
  const auto kept = merged(points, 0.3);
  for (Vec3& p : points) p = Vec3(p.z(), p.x(), p.y()) * std::ldexp(1.0, -40);
  EXPECT_EQ(merged(points, std::ldexp(0.3, -40)), kept);
}

TEST(Weld, DropsPointsWithoutTrianglesAndLetsNoneOfThemAttractOthers) {
  mesh::SurfaceMesh surface =
      shapes::make_surface({{0.01, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{1, 2, 3}});
  const mesh::SurfaceMesh welded = weld(surface, 0.1);
  ASSERT_EQ(welded.points.size(), 3u);
  EXPECT_EQ(welded.points[VertexId(0)], Vec3(0, 0, 0));
  EXPECT_EQ(welded.points[VertexId(2)], Vec3(0, 1, 0));
}

TEST(Weld, SurvivesCoordinatesThatAreNotFiniteAndTinyTolerances) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<Vec3> points = {{nan, 0, 0}, {inf, 0, 0}, {1e300, 0, 0}, {nan, 0, 0}, {1e300, 0, 0}, {inf, 0, 0}};
  const std::vector<std::uint32_t> expected = {0, 1, 2, 0, 2, 1};
  EXPECT_EQ(merged(points, 0), expected);
  EXPECT_EQ(merged(points, std::numeric_limits<double>::denorm_min()), expected);
}

TEST(Weld, RefusesANegativeOrEndlessTolerance) {
  EXPECT_THROW(merged({}, -1), InputError);
  EXPECT_THROW(merged({}, std::numeric_limits<double>::infinity()), InputError);
  EXPECT_THROW(merged({}, std::numeric_limits<double>::quiet_NaN()), InputError);
}

}  // namespace
}  // namespace nearwall::surface

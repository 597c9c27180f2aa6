#include "nearwall/search/wall_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "nearwall/predicates/intersection.h"
#include "tests/search/soups.h"
#include "tests/support/shapes.h"

namespace nearwall::search {
namespace {

using soups_for_tests::random_soup;
using soups_for_tests::surface_of;

constexpr double kTolerance = 1e-12;  ///< of doubles, for lengths near 1

const auto keep_all = [](FaceId) { return true; };

Vec3 random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

/// Distance along a segment at which it meets the plane of a triangle.
double distance_to_plane(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  return distance(from, to) * dot(n, t[0] - from) / dot(n, to - from);
}

TEST(FirstHit, IsTheNearestOfAllExactHits) {
  std::mt19937 random(1);
  int n_hits = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const mesh::SurfaceMesh surface = surface_of(random_soup(100, 40 * seed, 0, seed));
    const WallTree tree(surface);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 from = random_point(random);
      const Vec3 to = i % 2 == 0 ? random_point(random) : from + 0.1 * random_point(random);
      const auto keep = [&](FaceId f) { return f.index() % 3 != 0; };
      double nearest = std::numeric_limits<double>::infinity();
      for (const FaceId f : surface.faces.ids()) {
        if (!keep(f) || !predicates::segment_intersects_triangle(from, to, surface.triangle(f))) continue;
        nearest = std::min(nearest, distance_to_plane(from, to, surface.triangle(f)));
      }
      const WallTree::Hit hit = tree.first_hit(from, to, keep);
      ASSERT_EQ(hit.face.is_valid(), std::isfinite(nearest)) << "segment " << i;
      if (!hit.face.is_valid()) continue;
      ++n_hits;
      ASSERT_NEAR(hit.distance, nearest, kTolerance);
      ASSERT_TRUE(keep(hit.face));
      ASSERT_TRUE(predicates::segment_intersects_triangle(from, to, surface.triangle(hit.face)));
    }
  }
  EXPECT_GT(n_hits, 500);
}

TEST(FirstHit, OfTiesIsTheSmallestFace) {
  using namespace shapes_for_tests;
  // Onto a corner that four faces have in common.
  const mesh::SurfaceMesh surface = octahedron();
  const WallTree tree(surface);
  const auto hit = tree.first_hit({3, 0, 0}, {0, 0, 0}, keep_all);
  std::vector<FaceId> at_corner;
  for (const FaceId f : surface.faces.ids()) {
    for (const Vec3& p : surface.triangle(f)) {
      if (p == Vec3(1, 0, 0)) at_corner.push_back(f);
    }
  }
  ASSERT_EQ(at_corner.size(), 4u);
  EXPECT_EQ(hit.face, at_corner.front());
  EXPECT_EQ(hit.distance, 2.0);
}

TEST(FirstHit, AlongTheAxesMeetsFlatSidesAndTheirEdges) {
  const WallTree tree(shapes_for_tests::cube(1.0));
  EXPECT_EQ(tree.first_hit({3, 0.2, 0.3}, {-3, 0.2, 0.3}, keep_all).distance, 2.0);
  EXPECT_EQ(tree.first_hit({3, 1, 1}, {-3, 1, 1}, keep_all).distance, 2.0);  // along an edge
  EXPECT_EQ(tree.first_hit({3, 1, 0}, {-3, 1, 0}, keep_all).distance, 2.0);  // in the plane of a side
  EXPECT_FALSE(tree.first_hit({3, 0, 0}, {1.5, 0, 0}, keep_all).face.is_valid());
  EXPECT_EQ(tree.first_hit({3, 0, 0}, {1, 0, 0}, keep_all).distance, 2.0);          // its end touches
  EXPECT_EQ(tree.first_hit({1, 0.5, 0.2}, {1, 0.5, 0.2}, keep_all).distance, 0.0);  // no length, on a side
}

TEST(FirstHit, IsTheSameBitForBitInAnyAxisOrderAndScale) {
  std::mt19937 random(2);
  const mesh::SurfaceMesh surface = surface_of(random_soup(200, 500, 8, 3));
  const auto turn = [](const Vec3& p) { return 0x1p-7 * Vec3(p.z(), p.x(), p.y()); };
  const auto mirror = [](const Vec3& p) { return Vec3(p.y(), p.x(), p.z()); };
  const WallTree tree(surface), turned(shapes_for_tests::mapped(surface, turn));
  const WallTree mirrored(shapes_for_tests::mapped(surface, mirror));
  for (int i = 0; i < 3000; ++i) {
    const Vec3 from = random_point(random), to = random_point(random);
    const auto hit = tree.first_hit(from, to, keep_all);
    const auto turned_hit = turned.first_hit(turn(from), turn(to), keep_all);
    const auto mirrored_hit = mirrored.first_hit(mirror(from), mirror(to), keep_all);
    ASSERT_EQ(hit.face, turned_hit.face);
    ASSERT_EQ(hit.distance, 0x1p7 * turned_hit.distance);
    ASSERT_EQ(hit.face, mirrored_hit.face);
    ASSERT_EQ(hit.distance, mirrored_hit.distance);
    const auto nearest = tree.nearest(from), turned_nearest = turned.nearest(turn(from));
    ASSERT_EQ(nearest.face, turned_nearest.face);
    ASSERT_EQ(turn(nearest.point), turned_nearest.point);
  }
}

TEST(FacesNear, AreThoseWhoseBoxesMeet) {
  std::mt19937 random(3);
  const mesh::SurfaceMesh surface = surface_of(random_soup(100, 300, 4, 4));
  const WallTree tree(surface);
  for (int i = 0; i < 200; ++i) {
    geometry::Box box;
    box.include(random_point(random));
    if (i % 3 != 0) box.include(random_point(random));
    std::vector<FaceId> expected;
    for (const FaceId f : surface.faces.ids()) {
      if (geometry::bounding_box(surface.triangle(f)).intersects(box)) expected.push_back(f);
    }
    EXPECT_EQ(tree.faces_near(box), expected);
  }
}

/// The least distance to a triangle over a fine grid of its points: never under the true one.
double sampled_distance(const std::array<Vec3, 3>& t, const Vec3& p) {
  constexpr int kSteps = 60;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const Vec3 q = (i * t[0] + j * t[1] + (kSteps - i - j) * t[2]) / kSteps;
      least = std::min(least, distance(p, q));
    }
  }
  return least;
}

TEST(Nearest, IsNoFartherThanAnySampleAndLiesOnItsFace) {
  std::mt19937 random(4);
  const mesh::SurfaceMesh surface = surface_of(random_soup(30, 12, 0, 5));
  const WallTree tree(surface);
  for (int i = 0; i < 150; ++i) {
    const Vec3 p = random_point(random);
    const auto nearest = tree.nearest(p);
    double least = std::numeric_limits<double>::infinity();
    for (const FaceId f : surface.faces.ids()) least = std::min(least, sampled_distance(surface.triangle(f), p));
    EXPECT_LE(nearest.distance, least + kTolerance);
    EXPECT_GE(nearest.distance,
              least - 0.04);  // no point is farther from a sample: 2/3 of 1/60 of the longest edge, 2 sqrt 3
    EXPECT_NEAR(nearest.distance, distance(p, nearest.point), kTolerance);
    const auto t = surface.triangle(nearest.face);
    const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
    EXPECT_NEAR(dot(n, nearest.point - t[0]), 0.0, kTolerance);
  }
}

TEST(Nearest, OnAFaceIsThatOfTheWholeSurfaceOnTheNearestFace) {
  std::mt19937 random(5);
  const mesh::SurfaceMesh surface = surface_of(random_soup(30, 12, 0, 5));
  const WallTree tree(surface);
  for (int i = 0; i < 150; ++i) {
    const Vec3 p = random_point(random);
    const auto nearest = tree.nearest(p);
    EXPECT_EQ(tree.nearest_on(nearest.face, p), nearest.point);
    for (const FaceId f : surface.faces.ids()) {
      EXPECT_GE(distance(tree.nearest_on(f, p), p), nearest.distance - kTolerance);
    }
  }
}

TEST(FacesNear, APointAreThoseWhoseBoxesABallMeets) {
  std::mt19937 random(6);
  const mesh::SurfaceMesh surface = surface_of(random_soup(200, 60, 0, 5));
  const WallTree tree(surface);
  for (const double radius : {0.0, 0.1, 0.5, 10.0}) {
    for (int i = 0; i < 20; ++i) {
      const Vec3 centre = random_point(random);
      std::vector<FaceId> expected;
      for (const FaceId f : surface.faces.ids()) {
        const geometry::Box box = geometry::bounding_box(surface.triangle(f));
        Vec3 inside = centre;
        for (int k = 0; k < 3; ++k) inside[k] = std::clamp(centre[k], box.low[k], box.high[k]);
        if (distance(inside, centre) <= radius) expected.push_back(f);
      }
      EXPECT_EQ(tree.faces_near(centre, radius), expected);
    }
  }
}

TEST(Nearest, OfTheCubeIsItsCornersEdgesAndSides) {
  const WallTree tree(shapes_for_tests::cube(1.0));
  EXPECT_EQ(tree.nearest({2, 3, 4}).point, Vec3(1, 1, 1));
  EXPECT_EQ(tree.nearest({2, 3, 0.25}).point, Vec3(1, 1, 0.25));
  EXPECT_EQ(tree.nearest({0.5, 3, 0.25}).distance, 2.0);
  EXPECT_EQ(tree.nearest({0.5, 0.9375, 0.25}).distance, 0.0625);
  EXPECT_EQ(tree.nearest({1, 1, 1}).distance, 0.0);
}

TEST(WallTree, TakesTrianglesWithoutArea) {
  mesh::SurfaceMesh surface = shapes_for_tests::make_surface(
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3(0, 5, 0)}, {{0, 1, 2}, {3, 3, 3}});
  const WallTree tree(surface);
  EXPECT_EQ(tree.nearest({2, 0, 1}).point, Vec3(2, 0, 0));
  EXPECT_EQ(tree.nearest({0, 6, 0}).point, Vec3(0, 5, 0));
  EXPECT_EQ(tree.first_hit({2, 0, 1}, {2, 0, -1}, keep_all).distance, 1.0);
  EXPECT_FALSE(tree.first_hit({4, 0, 1}, {4, 0, -1}, keep_all).face.is_valid());
}

}  // namespace
}  // namespace nearwall::search

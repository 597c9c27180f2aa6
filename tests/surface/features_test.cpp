#include "nearwall/surface/features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "tests/support/shapes.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;
using geometry::kPi;
using geometry::to_radians;
using mesh::Topology;

Features features_of(const mesh::SurfaceMesh& surface, const FeatureOptions& options = {}) {
  return find_features(surface, Topology(surface), options);
}

std::size_t count(const Features& features, PointKind kind) {
  return static_cast<std::size_t>(std::count(features.kind.begin(), features.kind.end(), kind));
}

PointKind kind_at(const mesh::SurfaceMesh& surface, const Features& features, const Vec3& p) {
  for (const VertexId v : surface.points.ids()) {
    if (distance(surface.points[v], p) < 1e-12) return features.kind[v];
  }
  ADD_FAILURE() << "no such point";
  return PointKind::Smooth;
}

TEST(FindFeatures, SeesTwelveConvexRidgesAndEightCornersOfACube) {
  const mesh::SurfaceMesh cube = shapes::cube();
  const Features features = features_of(cube);
  EXPECT_EQ(features.n_convex, 12u);
  EXPECT_EQ(features.n_concave, 0u);
  EXPECT_EQ(count(features, PointKind::Corner), 8u);
  for (const HalfedgeId h : features.turn.ids()) {
    EXPECT_DOUBLE_EQ(features.turn[h], features.is_ridge[h] ? kPi / 2 : 0.0);
  }
}

TEST(FindFeatures, TellsPointsOnEdgesAndSidesOfACubeApart) {
  const mesh::SurfaceMesh cube = shapes::subdivided(shapes::subdivided(shapes::cube()));
  const Features features = features_of(cube);
  for (const VertexId v : cube.points.ids()) {
    int n_outer = 0;
    for (int axis = 0; axis < 3; ++axis) n_outer += std::abs(cube.points[v][axis]) == 0.5 ? 1 : 0;
    const PointKind expected[] = {PointKind::Smooth, PointKind::Smooth, PointKind::Ridge, PointKind::Corner};
    EXPECT_EQ(features.kind[v], expected[n_outer]);
  }
}

TEST(FindFeatures, TakesTheSignOfTheTurnFromTheSideOfTheFluid) {
  const Features features = features_of(shapes::flipped(shapes::cube()));
  EXPECT_EQ(features.n_convex, 0u);
  EXPECT_EQ(features.n_concave, 12u);
}

TEST(FindFeatures, SeesTheConcaveEdgeOfAStep) {
  const mesh::SurfaceMesh step = shapes::l_step();
  const Features features = features_of(step);
  EXPECT_EQ(features.n_convex, 17u);
  EXPECT_EQ(features.n_concave, 1u);
  EXPECT_EQ(count(features, PointKind::Corner), 12u);
}

TEST(FindFeatures, MeasuresTheTurnOfKnifeEdges) {
  for (const double opening : {1.0, 1e-2, 1e-5, 1e-8}) {
    const mesh::SurfaceMesh wedge = shapes::wedge(opening);
    const Features features = features_of(wedge);
    const double sharpest = *std::max_element(features.turn.begin(), features.turn.end());
    EXPECT_NEAR(sharpest, kPi - opening, 1e-14) << opening;
    EXPECT_EQ(features.n_concave, 0u);
  }
}

TEST(FindFeatures, GivesBothHalvesOfAnEdgeTheSameTurn) {
  const mesh::SurfaceMesh surface = shapes::sphere(2);
  const Topology topology(surface);
  const Features features = find_features(surface, topology);
  for (const HalfedgeId h : features.turn.ids()) {
    EXPECT_EQ(features.turn[h], features.turn[topology.twin(h)]);
    EXPECT_GT(features.turn[h], 0.0);
  }
  EXPECT_EQ(count(features, PointKind::Smooth), surface.points.size());
}

TEST(FindFeatures, CountsTheThresholdItselfAsARidge) {
  FeatureOptions options;
  options.ridge_angle = kPi / 2;
  EXPECT_EQ(features_of(shapes::cube(), options).n_convex, 12u);
  options.ridge_angle = std::nextafter(kPi / 2, 4.0);
  EXPECT_EQ(features_of(shapes::cube(), options).n_convex, 0u);
}

TEST(FindFeatures, CallsTheApexOfASteepConeATipAndThatOfAShallowOneSmooth) {
  for (const auto& [height, expected] : {std::pair(3.0, PointKind::Tip), std::pair(0.2, PointKind::Smooth)}) {
    const mesh::SurfaceMesh cone = shapes::cone(40, height);
    FeatureOptions options;
    options.ridge_angle = to_radians(20);  // the shallow cone's rim turns by 169 degrees, its flanks by less than 9
    const Features features = features_of(cone, options);
    EXPECT_EQ(features.kind[VertexId(0)], expected);
    EXPECT_EQ(features.kind[VertexId(1)], PointKind::Smooth);
    EXPECT_EQ(count(features, PointKind::Ridge), 40u);
  }
}

TEST(FindFeatures, PutsTheTipAtTheAngleOfTheOptions) {
  // The faces of this cone make the same angle with its axis, a little more than the slope of the flank of a round
  // cone.
  const mesh::SurfaceMesh cone = shapes::cone(60, 1);
  const double angle = std::atan(1 / std::cos(kPi / 60));
  FeatureOptions options;
  options.tip_angle = angle - 1e-6;
  EXPECT_EQ(features_of(cone, options).kind[VertexId(0)], PointKind::Tip);
  options.tip_angle = angle + 1e-6;
  EXPECT_EQ(features_of(cone, options).kind[VertexId(0)], PointKind::Smooth);
}

TEST(FindFeatures, CallsASharpBendOfARidgeACorner) {
  // Hexagonal prism: its rim turns by 90 degrees, its upright edges by 60, and so does the rim bend.
  std::vector<std::array<double, 2>> hexagon;
  for (int i = 0; i < 6; ++i) hexagon.push_back({std::cos(kPi / 3 * i), std::sin(kPi / 3 * i)});
  const mesh::SurfaceMesh prism = shapes::prism_over(hexagon, 1);
  FeatureOptions options;
  options.ridge_angle = to_radians(70);
  EXPECT_EQ(count(features_of(prism, options), PointKind::Corner), 12u);
  options.corner_angle = to_radians(65);
  EXPECT_EQ(count(features_of(prism, options), PointKind::Ridge), 12u);
}

/// Roof whose ridge runs along x = 1/2: the slope of both sides is slope(y).
template <class Slope>
mesh::SurfaceMesh roof(std::size_t n, Slope&& slope) {
  return shapes::height_field(n, [&](double x, double y) { return -std::abs(x - 0.5) * slope(y); });
}

/// A roof that flattens out: its ridge ends inside.
mesh::SurfaceMesh fading_roof() {
  return roof(8, [](double y) { return 1.25 * (1 - y); });
}

TEST(FindFeatures, SeesWhereARidgeEnds) {
  const mesh::SurfaceMesh surface = fading_roof();
  const Topology topology(surface);
  const Features features = find_features(surface, topology);
  std::vector<PointKind> along_the_middle;
  for (const VertexId v : surface.points.ids()) {
    if (topology.is_boundary(v)) continue;
    if (surface.points[v].x() == 0.5) {
      along_the_middle.push_back(features.kind[v]);
    } else {
      EXPECT_EQ(features.kind[v], PointKind::Smooth);
    }
  }
  // From y = 1/8 to 7/8. Turns of 40 degrees need slopes of tan 20 degrees on both sides, that is up to y = 0.709.
  const auto end = std::ranges::find(along_the_middle, PointKind::RidgeEnd);
  ASSERT_NE(end, along_the_middle.end());
  EXPECT_TRUE(std::all_of(along_the_middle.begin(), end, [](PointKind kind) { return kind == PointKind::Ridge; }));
  EXPECT_TRUE(std::all_of(end + 1, along_the_middle.end(), [](PointKind kind) { return kind == PointKind::Smooth; }));
  EXPECT_NEAR(static_cast<double>(end - along_the_middle.begin() + 1) / 8, 0.709, 1.0 / 8);
}

TEST(FindFeatures, CallsTheChangeFromConvexToConcaveACorner) {
  const mesh::SurfaceMesh surface = roof(8, [](double y) { return y < 0.5 ? 1.0 : y > 0.5 ? -1.0 : 0.0; });
  const Features features = features_of(surface);
  EXPECT_GT(features.n_convex, 0u);
  EXPECT_GT(features.n_concave, 0u);
  EXPECT_EQ(kind_at(surface, features, {0.5, 0.25, 0}), PointKind::Ridge);
  EXPECT_EQ(kind_at(surface, features, {0.5, 0.75, 0}), PointKind::Ridge);
  EXPECT_EQ(kind_at(surface, features, {0.5, 0.5, 0}), PointKind::Corner);
}

TEST(FindFeatures, GivesBoundariesNoTurn) {
  const mesh::SurfaceMesh plate = shapes::plate(3);
  const Features features = features_of(plate);
  EXPECT_EQ(features.n_convex + features.n_concave, 0u);
  EXPECT_EQ(count(features, PointKind::Smooth), plate.points.size());
}

TEST(FindFeatures, FollowsScalingByPowersOfTwoAndPermutationOfTheAxesToTheBit) {
  const mesh::SurfaceMesh surface = shapes::joined(shapes::sphere(2), shapes::wedge(0.3));
  const Features features = features_of(surface);
  const Features permuted =
      features_of(shapes::mapped(surface, [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()) * 0x1p-30; }));
  EXPECT_EQ(permuted.turn, features.turn);
  EXPECT_EQ(permuted.kind, features.kind);
}

TEST(FindFeatures, RefusesAnglesOutOfRange) {
  for (const double angle : {0.0, -1.0, 4.0, std::nan("")}) {
    FeatureOptions options;
    options.ridge_angle = angle;
    EXPECT_THROW(features_of(shapes::cube(), options), InputError);
  }
}

TEST(DiscretePatches, ShareANumberExactlyBetweenRidges) {
  // On a cube two faces round a vertex are in one patch if and only if they lie on the same side.
  for (const mesh::SurfaceMesh& cube : {shapes::cube(), shapes::subdivided(shapes::cube())}) {
    const Topology topology(cube);
    const Features features = find_features(cube, topology);
    for (const VertexId v : cube.points.ids()) {
      const auto fan = topology.fan(v);
      const std::vector<int> patch = discrete_patches(topology, features, v);
      ASSERT_EQ(patch.size(), fan.size());
      for (std::size_t i = 0; i < fan.size(); ++i) {
        for (std::size_t j = 0; j < fan.size(); ++j) {
          const bool is_same_side =
              features.face_normal[Topology::face(fan[i])] == features.face_normal[Topology::face(fan[j])];
          EXPECT_EQ(patch[i] == patch[j], is_same_side);
        }
      }
      EXPECT_EQ(*std::min_element(patch.begin(), patch.end()), 0);
      EXPECT_EQ(patch.front(), 0);
    }
  }
}

TEST(DiscretePatches, AreOneAtTheEndOfARidge) {
  const mesh::SurfaceMesh surface = fading_roof();
  const Topology topology(surface);
  const Features features = find_features(surface, topology);
  int n_ends = 0;
  for (const VertexId v : surface.points.ids()) {
    if (features.kind[v] != PointKind::RidgeEnd || topology.is_boundary(v)) continue;
    ++n_ends;
    for (const int patch : discrete_patches(topology, features, v)) EXPECT_EQ(patch, 0);
  }
  EXPECT_EQ(n_ends, 1);
}

TEST(DiscretePatches, AreTwoWhereARidgeMeetsABoundary) {
  const mesh::SurfaceMesh surface = roof(4, [](double) { return 2.0; });
  const Topology topology(surface);
  const Features features = find_features(surface, topology);
  const std::vector<int> patch = discrete_patches(topology, features, VertexId(2));
  EXPECT_EQ(*std::max_element(patch.begin(), patch.end()), 1);
}

}  // namespace
}  // namespace nearwall::surface

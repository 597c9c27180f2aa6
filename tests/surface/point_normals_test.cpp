#include "nearwall/surface/point_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nearwall/core/parallel.h"
#include "nearwall/predicates/orientation.h"
#include "tests/support/shapes.h"
#include "tests/surface/fans.h"

namespace nearwall::surface {
namespace {

namespace shapes = shapes_for_tests;
using fans::Random;

constexpr double kRightAngle = std::numbers::pi / 2;

bool sees(const Vec3& direction, const std::vector<Vec3>& normals) {
  return std::all_of(normals.begin(), normals.end(), [&](const Vec3& n) {
    return predicates::sign_of_dot(n, direction) == predicates::Sign::Positive;
  });
}

struct Prepared {
  mesh::SurfaceMesh surface;
  mesh::Topology topology;
  Features features;
  explicit Prepared(mesh::SurfaceMesh s)
      : surface(std::move(s)), topology(surface), features(find_features(surface, topology)) {}
  IdVector<VertexId, PointNormal> normals(NormalMethod method = NormalMethod::MostVisible) const {
    return point_normals(surface, topology, features, {.method = method});
  }
};

mesh::SurfaceMesh bumpy_sphere(int level, double height, unsigned seed) {
  Random random(seed);
  return shapes::mapped(shapes::sphere(level),
                        [&](const Vec3& p) { return p * random.uniform(1 - height, 1 + height); });
}

TEST(PointNormals, LookAlongTheDiagonalsOfACube) {
  const Prepared cube(shapes::subdivided(shapes::cube()));
  const auto normals = cube.normals();
  for (const VertexId v : normals.ids()) {
    // Corners, middles of edges and middles of sides all have their normal along the vector from the centre.
    EXPECT_NEAR(distance(normals[v].direction, normalized(cube.surface.points[v])), 0, 1e-15);
    EXPECT_TRUE(normals[v].is_visible);
  }
  EXPECT_NEAR(geometry::to_degrees(normals[VertexId(0)].max_angle), 54.735610317245346, 1e-13);
}

TEST(PointNormals, SeeExactlyWhatTheySayAndAsWellAsThereIs) {
  const Prepared rough(bumpy_sphere(4, 0.2, 6));
  for (const NormalMethod method : {NormalMethod::MostVisible, NormalMethod::Angle}) {
    const auto normals = rough.normals(method);
    int n_direct = 0;
    for (const VertexId v : normals.ids()) {
      std::vector<Vec3> faces;
      for (const HalfedgeId h : rough.topology.fan(v)) {
        faces.push_back(rough.features.face_normal[mesh::Topology::face(h)]);
      }
      const long double angle = fans::worst_angle(fans::to_long(normals[v].direction), faces);
      EXPECT_EQ(normals[v].is_visible, sees(normals[v].direction, faces));
      EXPECT_NEAR(normals[v].max_angle, static_cast<double>(angle), 1e-14);
      if (method == NormalMethod::MostVisible && std::cos(angle) < 0.95) {
        EXPECT_LT(angle, fans::smallest_worst_angle(faces) + 1e-14L);
        ++n_direct;
      }
    }
    EXPECT_TRUE(method == NormalMethod::Angle || n_direct > 100) << n_direct;
  }
}

TEST(PointNormals, AreBlindWhereNothingSeesAllFaces) {
  const Prepared corner(fans::corner_that_nothing_sees());
  const PointNormal normal = corner.normals()[VertexId(0)];
  EXPECT_FALSE(normal.is_visible);
  EXPECT_GE(normal.max_angle, kRightAngle);
  EXPECT_NEAR(norm(normal.direction), 1, 1e-15);
}

TEST(PointNormals, OfAnOpenPlatePointUpAtItsEdgesToo) {
  const Prepared plate(shapes::plate(3));
  for (const PointNormal& normal : plate.normals()) {
    EXPECT_EQ(normal.direction, Vec3(0, 0, 1));
    EXPECT_EQ(normal.max_angle, 0);
  }
}

TEST(PointNormals, OfAVertexWithoutFacesIsZeroAndBlind) {
  mesh::SurfaceMesh surface = shapes::cube();
  const VertexId lonely = surface.points.push_back({5, 5, 5});
  const PointNormal normal = Prepared(surface).normals()[lonely];
  EXPECT_EQ(normal.direction, Vec3());
  EXPECT_FALSE(normal.is_visible);
}

TEST(PointNormals, AreTheSameBitsOnTurnedAxesAtAnyScaleAndOnAnyNumberOfThreads) {
  const mesh::SurfaceMesh rough = bumpy_sphere(5, 0.1, 7);
  const auto turned = [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()); };
  const auto normals = Prepared(rough).normals();
  const auto others = Prepared(shapes::scaled(shapes::mapped(rough, turned), 0x1p-40)).normals();
  const ThreadLimit one(1);
  const auto singles = Prepared(rough).normals();
  for (const VertexId v : normals.ids()) {
    ASSERT_EQ(others[v].direction, turned(normals[v].direction));
    ASSERT_EQ(others[v].max_angle, normals[v].max_angle);
    ASSERT_EQ(singles[v].direction, normals[v].direction);
  }
}

TEST(NormalMethod, GoesByItsName) {
  for (std::size_t k = 0; k < kNormalMethodNames.size(); ++k) {
    const auto method = static_cast<NormalMethod>(k);
    EXPECT_EQ(normal_method(method_name(method)), method);
  }
  EXPECT_EQ(method_name(NormalMethod::Nielson), "nielson");
  EXPECT_EQ(method_name(NormalMethod::InverseRootEdges), "little-1/2");
  EXPECT_EQ(method_name(NormalMethod::AngleOverCircumArea), "angle-over-circumarea");
  EXPECT_FALSE(normal_method("most-vizible"));
  EXPECT_EQ(weight_of(NormalMethod::Max), Weight::Max);
  EXPECT_FALSE(weight_of(NormalMethod::Nielson));
}

}  // namespace
}  // namespace nearwall::surface

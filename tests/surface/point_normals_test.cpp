#include "nearwall/surface/point_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nearwall/core/errors.h"
#include "nearwall/core/parallel.h"
#include "nearwall/geometry/angles.h"
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

class PointNormalsBy : public testing::TestWithParam<int> {
 protected:
  NormalMethod method() const { return static_cast<NormalMethod>(GetParam()); }
};

TEST_P(PointNormalsBy, AreThePlanesNormalOnAnOpenPlate) {
  const Prepared plate(shapes::plate(5));
  for (const PointNormal& normal : plate.normals(method())) {
    EXPECT_NEAR(distance(normal.direction, {0, 0, 1}), 0, 1e-14);
    EXPECT_LT(normal.max_angle, 1e-7);
    EXPECT_TRUE(normal.is_visible);
  }
}

TEST_P(PointNormalsBy, TendToThatOfASphere) {
  double worst[2] = {0, 0};
  for (const int level : {3, 5}) {
    const Prepared sphere(shapes::mapped(shapes::sphere(level), [](const Vec3& p) {
      // Triangles that differ in size and shape.
      return normalized(p + Vec3(0.3 * p.y() * p.z(), 0.2 * p.x() * p.x(), 0.25 * p.x() * p.y()));
    }));
    const auto normals = sphere.normals(method());
    for (const VertexId v : normals.ids()) {
      const double error = geometry::angle_between(normals[v].direction, sphere.surface.points[v]);
      worst[level == 5] = std::max(worst[level == 5], error);
    }
  }
  // Four times finer: first order at least; nothing is left of the error where the method is exact on spheres.
  EXPECT_LT(worst[1], std::max(worst[0] / 3, 1e-13));
  EXPECT_LT(worst[1], 0.05);
}

TEST_P(PointNormalsBy, SayExactlyWhatTheySee) {
  const Prepared rough(bumpy_sphere(4, 0.2, 6));
  const auto normals = rough.normals(method());
  for (const VertexId v : normals.ids()) {
    std::vector<Vec3> faces;
    for (const HalfedgeId h : rough.topology.fan(v)) {
      faces.push_back(rough.features.face_normal[mesh::Topology::face(h)]);
    }
    ASSERT_NEAR(norm(normals[v].direction), 1, 1e-15);
    ASSERT_EQ(normals[v].is_visible, sees(normals[v].direction, faces));
    ASSERT_NEAR(normals[v].max_angle,
                static_cast<double>(fans::worst_angle(fans::to_long(normals[v].direction), faces)), 1e-12);
  }
}

TEST_P(PointNormalsBy, AreTheSameBitsOnAnyNumberOfThreads) {
  const Prepared rough(bumpy_sphere(5, 0.1, 7));
  const auto normals = rough.normals(method());
  const ThreadLimit one(1);
  const auto singles = rough.normals(method());
  for (const VertexId v : normals.ids()) {
    ASSERT_EQ(singles[v].direction, normals[v].direction);
    ASSERT_EQ(singles[v].is_fallback, normals[v].is_fallback);
  }
}

TEST_P(PointNormalsBy, AreFiniteWhateverTheSurface) {
  mesh::SurfaceMesh degenerate = shapes::plate(4);
  degenerate.points[VertexId(12)] = degenerate.points[VertexId(13)];
  mesh::SurfaceMesh lonely = shapes::cube();
  lonely.points.push_back({5, 5, 5});
  for (const auto& surface : {fans::corner_that_nothing_sees(), degenerate, lonely}) {
    for (const PointNormal& normal : Prepared(surface).normals(method())) {
      EXPECT_TRUE(is_finite(normal.direction));
      EXPECT_TRUE(normal.direction == Vec3() || std::abs(norm(normal.direction) - 1) < 1e-15);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllMethods, PointNormalsBy, testing::Range(0, static_cast<int>(kNormalMethodNames.size())),
                         [](const testing::TestParamInfo<int>& parameter) {
                           std::string name(kNormalMethodNames[static_cast<std::size_t>(parameter.param)]);
                           for (char& c : name) c = c == '-' || c == '/' ? '_' : c;
                           return name;
                         });

TEST(PointNormals, ByMostNormalFallBackToTheMostVisibleOutsideTheCone) {
  // A block on a floor: one convex and two concave ridges meet at its foot. Inside out, the most normal normal lies on
  // the edge of what sees all faces.
  for (const bool is_reversed : {false, true}) {
    mesh::SurfaceMesh surface = shapes::voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}});
    if (is_reversed) surface = shapes::flipped(surface);
    const auto foot = std::find(surface.points.begin(), surface.points.end(), Vec3(1, 1, 1));
    ASSERT_NE(foot, surface.points.end());
    const VertexId v(static_cast<std::size_t>(foot - surface.points.begin()));
    const Prepared block(surface);
    const PointNormal visible = block.normals()[v], normal = block.normals(NormalMethod::MostNormal)[v];
    EXPECT_TRUE(normal.is_visible);
    EXPECT_EQ(normal.is_fallback, is_reversed);
    EXPECT_EQ(normal.direction == visible.direction, is_reversed);
  }
}

TEST(PointNormals, LeaveThinBoundaryTrianglesOut) {
  // A flat field one of whose boundary triangles is a sliver that stands upright.
  mesh::SurfaceMesh surface = shapes::plate(4);
  const VertexId a = surface.faces[FaceId(0)][0], b = surface.faces[FaceId(0)][1];
  const Vec3 p = surface.points[a], q = surface.points[b];
  const VertexId tip = surface.points.push_back((p + q) / 2.0 + Vec3(0, 0, 1e-4 * distance(p, q)));
  shapes::add_face(surface, {b.index(), a.index(), tip.index()});
  const Prepared sliver(surface);
  const auto plain = point_normals(sliver.surface, sliver.topology, sliver.features,
                                   {.method = NormalMethod::Uniform, .thin_angle = std::numbers::pi});
  const auto without = sliver.normals(NormalMethod::Uniform);
  EXPECT_GT(distance(plain[a].direction, {0, 0, 1}), 0.1);
  for (const VertexId v : {a, b}) {
    EXPECT_EQ(without[v].direction, Vec3(0, 0, 1));
    // It is held against the sliver all the same.
    EXPECT_NEAR(without[v].max_angle, kRightAngle, 1e-12);
  }
  // The tip has no other face.
  EXPECT_NEAR(std::abs(dot(without[tip].direction, normalized(q - p))), 0, 1e-15);
  EXPECT_NEAR(norm(without[tip].direction), 1, 1e-15);
}

TEST(PointNormals, DropUnsuitableNormalsWhereAsked) {
  // Six faces round the middle of a plate, one of which is bent up steeply by its far corner.
  mesh::SurfaceMesh surface = shapes::plate(2);
  const VertexId middle(4);
  const mesh::Topology flat(surface);
  surface.points[flat.target(flat.fan(middle)[0])] += Vec3(0, 0, 0.02);
  surface.points[flat.target(flat.fan(middle)[3])] += Vec3(0, 0, 5.0);
  const Prepared bent(surface);
  const auto by = [&](Unsuitable rule) {
    return point_normals(bent.surface, bent.topology, bent.features,
                         {.method = NormalMethod::Uniform, .unsuitable = rule});
  };
  std::vector<Vec3> faces;
  for (const HalfedgeId h : bent.topology.fan(middle)) {
    faces.push_back(bent.features.face_normal[mesh::Topology::face(h)]);
  }
  // Algorithm 1 of Bohdal 2017, with the average not normalised.
  Vec3 average, sum;
  for (const Vec3& face : faces) average += face / 6.0;
  double squares = 0;
  for (const Vec3& face : faces) squares += squared_norm(face - average) / 6.0;
  int n_dropped = 0;
  for (const Vec3& face : faces) {
    const bool is_dropped = std::abs(squared_norm(face - average) - squares) > squares;
    if (!is_dropped) sum += face;
    n_dropped += is_dropped;
  }
  ASSERT_GT(n_dropped, 0);
  EXPECT_NEAR(distance(by(Unsuitable::DropEverywhere)[middle].direction, normalized(sum)), 0, 1e-15);
  EXPECT_NEAR(distance(by(Unsuitable::Keep)[middle].direction, normalized(average)), 0, 1e-15);
  EXPECT_EQ(by(Unsuitable::DropAtBoundary)[middle].direction, by(Unsuitable::Keep)[middle].direction);
}

TEST(PointNormals, RefuseAThinAngleOutOfRange) {
  const Prepared cube(shapes::cube());
  for (const double angle : {0.0, -1.0, 3.2, std::nan("")}) {
    EXPECT_THROW(point_normals(cube.surface, cube.topology, cube.features, {.thin_angle = angle}), InputError);
  }
}

TEST(PointNormals, ThatAreBlindAreReplacedByTheMostVisible) {
  const Prepared rough(bumpy_sphere(4, 0.3, 9));
  auto normals = rough.normals(NormalMethod::Area);
  const auto before = normals, best = rough.normals();
  replace_blind_normals(rough.surface, rough.topology, rough.features, normals);
  int n_replaced = 0;
  for (const VertexId v : normals.ids()) {
    const bool is_replaced = !before[v].is_visible && best[v].is_visible;
    EXPECT_EQ(normals[v].direction, is_replaced ? best[v].direction : before[v].direction);
    EXPECT_EQ(normals[v].is_fallback, !before[v].is_visible || before[v].is_fallback);
    n_replaced += is_replaced;
  }
  EXPECT_GT(n_replaced, 0);
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

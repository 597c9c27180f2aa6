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
  const mesh::SurfaceMesh line = shapes::make_surface({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  for (const auto& surface : {fans::corner_that_nothing_sees(), degenerate, lonely, line}) {
    for (const PointNormal& normal : Prepared(surface).normals(method())) {
      EXPECT_TRUE(is_finite(normal.direction));
      if (normal.direction == Vec3()) {
        EXPECT_FALSE(normal.is_visible);
        EXPECT_TRUE(normal.is_fallback);
        EXPECT_EQ(normal.max_angle, kRightAngle);
      } else {
        EXPECT_NEAR(norm(normal.direction), 1, 1e-15);
      }
    }
  }
}

TEST_P(PointNormalsBy, AreTheSameBitsAtAnyScale) {
  const mesh::SurfaceMesh rough = bumpy_sphere(3, 0.15, 10);
  const auto normals = Prepared(rough).normals(method());
  for (const double scale : {0x1p-190, 0x1p-60, 0x1p60, 0x1p190}) {
    const auto others = Prepared(shapes::scaled(rough, scale)).normals(method());
    for (const VertexId v : normals.ids()) {
      ASSERT_EQ(others[v].direction, normals[v].direction) << scale;
      ASSERT_EQ(others[v].is_fallback, normals[v].is_fallback) << scale;
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

/// A fan of unit squares' halves round the origin, all flat but `n_steep` last ones, which stand upright.
mesh::SurfaceMesh fan_with_steep_faces(int n_flat, int n_steep) {
  std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}};
  std::vector<shapes::Corners> faces;
  for (int k = 0; k < n_flat + n_steep; ++k) {
    const double turn = 0.4 * std::min(k + 1, n_flat);
    points.emplace_back(std::cos(turn), std::sin(turn), std::max(0, k + 1 - n_flat));
    const auto last = static_cast<std::uint32_t>(points.size() - 1);
    faces.push_back({0, last - 1, last});
  }
  return shapes::make_surface(points, faces);
}

TEST(PointNormals, DropUnsuitableNormalsWhereAsked) {
  // Four flat faces and one upright: of its two units of distance from the mean, the flat ones have a twentieth each.
  const auto direction = [](int n_flat, int n_steep, Unsuitable rule) {
    const Prepared fan(fan_with_steep_faces(n_flat, n_steep));
    return point_normals(fan.surface, fan.topology, fan.features,
                         {.method = NormalMethod::Uniform, .unsuitable = rule})[VertexId(0)]
        .direction;
  };
  const Vec3 up(0, 0, 1);
  // The origin lies on the boundary of its fan.
  EXPECT_EQ(direction(4, 1, Unsuitable::DropEverywhere), up);
  EXPECT_EQ(direction(4, 1, Unsuitable::DropAtBoundary), up);
  EXPECT_GT(distance(direction(4, 1, Unsuitable::Keep), up), 0.1);
  // Of fewer than five faces none is dropped, however it stands out.
  EXPECT_EQ(direction(3, 1, Unsuitable::DropEverywhere), direction(3, 1, Unsuitable::Keep));
  // Two of five are no exception: neither is twice as far as the mean square.
  EXPECT_EQ(direction(3, 2, Unsuitable::DropEverywhere), direction(3, 2, Unsuitable::Keep));
}

TEST(PointNormals, DropUnsuitableNormalsAtTheBoundaryOnly) {
  // Six faces round the middle of a plate, two of which are bent up steeply by their common corner.
  mesh::SurfaceMesh surface = shapes::plate(2);
  const VertexId middle(4);
  const mesh::Topology flat(surface);
  surface.points[flat.target(flat.fan(middle)[3])] += Vec3(0, 0, 5.0);
  const Prepared bent(surface);
  const auto by = [&](Unsuitable rule) {
    return point_normals(bent.surface, bent.topology, bent.features,
                         {.method = NormalMethod::Uniform, .unsuitable = rule})[middle]
        .direction;
  };
  EXPECT_EQ(by(Unsuitable::DropAtBoundary), by(Unsuitable::Keep));
  EXPECT_EQ(by(Unsuitable::DropEverywhere), Vec3(0, 0, 1));
  EXPECT_GT(distance(by(Unsuitable::Keep), {0, 0, 1}), 0.1);
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

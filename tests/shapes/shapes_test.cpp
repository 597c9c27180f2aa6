#include "nearwall/shapes/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/box.h"
#include "tests/shapes/surface_measures.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;
using geometry::to_radians;
using mesh::SurfaceMesh;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Catalogue, HasDefaultsWithinTheirRanges) {
  for (const ShapeInfo& info : catalogue()) {
    for (const ShapeParameter& p : info.parameters) {
      EXPECT_GE(p.value, p.min) << info.name << ' ' << p.name;
      EXPECT_LE(p.value, p.max) << info.name << ' ' << p.name;
    }
  }
}

TEST(Sphere, HasTwentyTimesFourToTheNTriangles) {
  EXPECT_EQ(make_shape("sphere", {{"subdivisions", 1}}).faces.size(), 80u);
  EXPECT_EQ(make_shape("sphere", {{"subdivisions", 3}}).faces.size(), 1280u);
  EXPECT_EQ(make_shape("sphere", {{"subdivisions", 7}}).faces.size(), 327680u);
}

TEST(Sphere, LiesOnTheSphere) {
  for (const Vec3& p : make_shape("sphere", {{"radius", 3}}).points) EXPECT_NEAR(norm(p), 3, 1e-14);
}

/// Edges are no longer than asked, and half of them at least nearly as long.
TEST(Size, IsTheEdgeLength) {
  for (const char* name : {"sphere", "cube", "cylinder", "torus", "ellipsoid", "capsule", "bend"}) {
    constexpr double kSize = 0.05;
    const SurfaceMesh s = make_shape(name, {}, kSize);
    std::vector<double> edges;
    for (const FaceId f : s.faces.ids()) {
      const auto [a, b, c] = s.triangle(f);
      edges.insert(edges.end(), {distance(a, b), distance(b, c), distance(c, a)});
    }
    std::nth_element(edges.begin(), edges.begin() + edges.size() / 2, edges.end());
    const double median = edges[edges.size() / 2], longest = *std::max_element(edges.begin(), edges.end());
    EXPECT_GT(median, 0.8 * kSize) << name;
    EXPECT_LT(median, 1.05 * kSize) << name;
    EXPECT_LT(longest, 1.6 * kSize) << name;
  }
}

/// Volumes of round bodies tend to the smooth one from inside (the torus from either side) as the square of the size.
TEST(Volume, TendsToTheSmoothBody) {
  const double r = 0.3, R = 1;
  const struct {
    const char* name;
    double smooth;
  } bodies[] = {
      {"sphere", 4 * kPi / 3},
      {"torus", 2 * kPi * kPi * R * r * r},
      {"cylinder", kPi * 0.25 * 2},
      {"cone", kPi / 3 * std::tan(to_radians(20)) * std::tan(to_radians(20))},
      {"capsule", kPi * 0.25 * 2 + 4 * kPi / 3 * 0.125},
      {"ellipsoid", 4 * kPi / 3 * 2 * 0.75 * 0.5},
      {"bend", kPi * 0.25 * (1 + 1.5 * kPi / 2 + 2)},
      {"concentric-spheres", 4 * kPi / 3 * (1 - 0.125)},
  };
  for (const auto& [name, smooth] : bodies) {
    const double coarse = smooth - volume(make_shape(name, {}, 0.06));
    const double fine = smooth - volume(make_shape(name, {}, 0.03));
    EXPECT_LT(std::abs(coarse), 0.02 * smooth) << name;
    EXPECT_NEAR(fine / coarse, 0.25, 0.05) << name;
  }
}

TEST(Volume, IsExactForFlatFaces) {
  const double notch = 0.5 * 0.5 * std::tan(to_radians(30));
  const double star = 10 * 0.5 * std::sin(kPi / 5) * 0.5 * 0.5 / 3;
  EXPECT_NEAR(volume(make_shape("cube")), 1, 1e-13);
  EXPECT_NEAR(volume(make_shape("box")), 1, 1e-13);
  EXPECT_NEAR(volume(make_shape("plate")), 0.02, 1e-14);
  EXPECT_NEAR(volume(make_shape("wedge")), std::tan(to_radians(10)), 1e-13);
  EXPECT_NEAR(volume(make_shape("step")), 1.5, 1e-13);
  EXPECT_NEAR(volume(make_shape("notch")), 2 - notch, 1e-13);
  EXPECT_NEAR(volume(make_shape("groove")), 2 - 0.4 * 0.2, 1e-13);
  EXPECT_NEAR(volume(make_shape("block-on-floor")), 1 + 9 * 0.2, 1e-12);
  EXPECT_NEAR(volume(make_shape("saddle-block")), 0.7, 1e-3);
  EXPECT_NEAR(volume(make_shape("star")), star, 1e-13);
  EXPECT_NEAR(volume(make_shape("two-boxes")), 2, 1e-13);
}

TEST(Cube, HasFlatFaces) {
  const SurfaceMesh s = make_shape("cube");
  for (const Vec3& p : s.points) EXPECT_EQ(max_norm(p), 0.5);
  for (const std::string& name : s.patch_names) EXPECT_NEAR(patch_area(s, name), 1, 1e-13);
}

TEST(Bend, CapsAreDiscs) {
  const SurfaceMesh s = make_shape("bend", {}, 0.05);
  EXPECT_EQ(patches(s), (std::set<std::string>{"inlet", "wall", "outlet"}));
  EXPECT_NEAR(patch_area(s, "inlet"), kPi * 0.25, 0.003);
  EXPECT_NEAR(patch_area(s, "outlet"), kPi * 0.25, 0.003);
}

TEST(TwoBoxes, AreAsFarApartAsAsked) {
  double left = -1, right = 1;
  for (const Vec3& p : make_shape("two-boxes", {{"gap", 0.02}}).points) {
    (p.x() < 0 ? left : right) = p.x() < 0 ? std::max(left, p.x()) : std::min(right, p.x());
  }
  EXPECT_EQ(right - left, 0.02);
}

/// Published dimensions: AGARD AR-138. The rounded tip adds half the section's thickness there.
TEST(OneraM6, HasThePublishedPlanform) {
  const SurfaceMesh s = make_shape("onera-m6");
  const geometry::Box box = geometry::bounding_box(s.points.raw());
  const double tip_chord = 0.562 * 0.8059;
  EXPECT_EQ(box.low.x(), 0);
  EXPECT_NEAR(box.high.x(), 1.1963 * std::tan(to_radians(30)) + tip_chord, 1e-12);
  EXPECT_NEAR(box.high.y(), 1.1963 + 0.0489296 * tip_chord, 2e-4);
  EXPECT_EQ(box.low.y(), -box.high.y());
  EXPECT_NEAR(box.high.z(), 0.0489296 * 0.8059, 5e-5);
  EXPECT_EQ(patches(s), (std::set<std::string>{"upper", "lower", "tip"}));
  EXPECT_GT(s.faces.size(), 30000u);
  EXPECT_LT(s.faces.size(), 60000u);
  // The trailing edge's sweep follows: 15.8 degrees.
  const double sweep = std::atan((box.high.x() - 0.8059) / 1.1963);
  EXPECT_NEAR(sweep, to_radians(15.8), to_radians(0.1));
}

TEST(OneraM6, HasTheWettedAreaOfItsSection) {
  // Half the planform is (c_root + c_tip) / 2 * span; a section's outline is 2.03 times its chord.
  const SurfaceMesh s = make_shape("onera-m6");
  const double planform = (1 + 0.562) / 2 * 0.8059 * 1.1963 * 2;
  EXPECT_NEAR(patch_area(s, "upper"), 1.015 * planform, 0.005 * planform);
  EXPECT_NEAR(patch_area(s, "lower"), patch_area(s, "upper"), 1e-3 * planform);
}

TEST(Naca, HasTheThicknessOfItsDigits) {
  const SurfaceMesh s = make_shape("naca", {{"digits", 15}, {"chord", 2}}, 0.02);
  const geometry::Box box = geometry::bounding_box(s.points.raw());
  EXPECT_NEAR(box.high.z() - box.low.z(), 0.15 * 2, 1e-3);
  EXPECT_NEAR(box.high.x(), 2, 1e-12);
}

TEST(Naca, HasItsCamber) {
  // Between the surfaces of a 4412 at x = 0.4, where its camber is largest, lies z = 0.04.
  const SurfaceMesh s = make_shape("naca", {{"digits", 4412}, {"half", 1}, {"rounded-tip", 0}}, 0.01);
  double high = -1, low = 1;
  for (const Vec3& p : s.points) {
    if (std::abs(p.x() - 0.4) > 0.01) continue;
    high = std::max(high, p.z()), low = std::min(low, p.z());
  }
  EXPECT_NEAR(0.5 * (high + low), 0.04, 1e-3);
}

TEST(Naca, NamesBaseAndRoot) {
  EXPECT_EQ(patches(make_shape("naca", {{"blunt", 1}, {"half", 1}})),
            (std::set<std::string>{"upper", "lower", "tip", "trailing-edge", "root"}));
}

TEST(WingBody, JoinsOnTheFuselage) {
  const SurfaceMesh s = make_shape("wing-body");
  const PatchId fuselage = PatchId(0);
  ASSERT_EQ(s.patch_names[fuselage], "fuselage");
  IdVector<VertexId, int> sides(s.points.size(), 0);
  for (const FaceId f : s.faces.ids()) {
    for (const VertexId v : s.faces[f]) sides[v] |= s.face_patch[f] == fuselage ? 1 : 2;
  }
  int joint = 0;
  for (const VertexId v : sides.ids()) {
    const Vec3& p = s.points[v];
    if (sides[v] == 3) {
      EXPECT_NEAR(std::hypot(p.y(), p.z()), 0.5, 1e-14);
      ++joint;
    }
    if (sides[v] == 2) {
      EXPECT_GT(std::hypot(p.y(), p.z()), 0.5);
    }
  }
  EXPECT_GT(joint, 100);
}

/// Published dimensions: SAE 840300.
TEST(Ahmed, HasThePublishedDimensions) {
  const SurfaceMesh s = make_shape("ahmed", {{"stilts", 1}});
  const geometry::Box box = geometry::bounding_box(s.points.raw());
  EXPECT_NEAR(box.low.x(), 0, 1e-15);
  EXPECT_EQ(box.low.z(), 0);
  EXPECT_NEAR(box.high.x(), 1.044, 1e-15);
  EXPECT_NEAR(box.high.y() - box.low.y(), 0.389, 1e-15);
  EXPECT_NEAR(box.high.z(), 0.050 + 0.288, 1e-15);
  EXPECT_NEAR(patch_area(s, "slant"), 0.222 * 0.389, 1e-12);
  EXPECT_NEAR(patch_area(s, "base"), (0.288 - 0.222 * std::sin(to_radians(25))) * 0.389, 1e-12);
  EXPECT_EQ(patches(s), (std::set<std::string>{"front", "roof", "slant", "base", "side-left", "side-right", "underbody",
                                               "stilts"}));
}

TEST(MakeShape, NamesTheNearestShape) {
  EXPECT_THAT([] { make_shape("spere"); }, ThrowsMessage<InputError>(HasSubstr("did you mean 'sphere'?")));
  EXPECT_THAT([] { make_shape("zzzzzz"); }, ThrowsMessage<InputError>(HasSubstr("shapes: sphere, ")));
}

TEST(MakeShape, NamesTheNearestParameter) {
  EXPECT_THAT(
      [] {
        make_shape("sphere", {{"radis", 1}});
      },
      ThrowsMessage<InputError>(HasSubstr("did you mean 'radius'?")));
}

TEST(MakeShape, RefusesValuesOutOfRange) {
  EXPECT_THAT([] { make_shape("sphere", {{"radius", -1}}); }, ThrowsMessage<InputError>(HasSubstr("radius")));
  EXPECT_THAT(
      [] {
        make_shape("cone", {{"half-angle", 90}});
      },
      ThrowsMessage<InputError>(HasSubstr("between 1 and 80 deg, not 90")));
  EXPECT_THAT([] { make_shape("naca", {{"digits", 12.5}}); }, ThrowsMessage<InputError>(HasSubstr("whole number")));
  EXPECT_THAT([] { make_shape("naca", {{"blunt", 0.5}}); }, ThrowsMessage<InputError>(HasSubstr("0 or 1")));
  EXPECT_THROW(make_shape("sphere", {{"radius", std::nan("")}}), InputError);
  EXPECT_THROW(make_shape("sphere", {{"radius", std::numeric_limits<double>::infinity()}}), InputError);
  EXPECT_THROW(make_shape("sphere", {}, -1), InputError);
  EXPECT_THROW(make_shape("sphere", {}, std::nan("")), InputError);
}

TEST(MakeShape, RefusesParametersThatDoNotGoTogether) {
  EXPECT_THROW(make_shape("torus", {{"tube-radius", 2}}), InputError);
  EXPECT_THROW(make_shape("capsule", {{"length", 0.5}}), InputError);
  EXPECT_THROW(make_shape("notch", {{"depth", 3}}), InputError);
  EXPECT_THROW(make_shape("naca", {{"digits", 4012}}), InputError);
  EXPECT_THROW(make_shape("naca", {{"digits", 2400}}), InputError);
  EXPECT_THROW(make_shape("wing-body", {{"wing-position", 0.1}}), InputError);
}

TEST(MakeShape, RefusesSizesThatWouldGiveTooManyTriangles) {
  for (const ShapeInfo& info : catalogue()) EXPECT_THROW(make_shape(info.name, {}, 1e-9), InputError) << info.name;
}

}  // namespace
}  // namespace nearwall::shapes

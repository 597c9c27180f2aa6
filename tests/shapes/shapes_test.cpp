#include "nearwall/shapes/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/box.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/search/self_intersection.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;
using geometry::to_radians;
using mesh::SurfaceMesh;
using testing::HasSubstr;
using testing::ThrowsMessage;

double volume(const SurfaceMesh& s) {
  geometry::CompensatedSum sum;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    sum.add(dot(a, cross(b, c)) / 6);
  }
  return sum.value();
}

double patch_area(const SurfaceMesh& s, std::string_view patch) {
  geometry::CompensatedSum sum;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    if (s.patch_names[s.face_patch[f]] == patch) sum.add(geometry::triangle_area(a, b, c));
  }
  return sum.value();
}

double smallest_angle_deg(const SurfaceMesh& s) {
  double smallest = kPi;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    smallest = std::min(
        {smallest, geometry::corner_angle(a, b, c), geometry::corner_angle(b, c, a), geometry::corner_angle(c, a, b)});
  }
  return geometry::to_degrees(smallest);
}

long euler_characteristic(const SurfaceMesh& s) {
  return static_cast<long>(s.points.size()) - static_cast<long>(s.faces.size() / 2);
}

std::set<std::string> patches(const SurfaceMesh& s) { return {s.patch_names.begin(), s.patch_names.end()}; }

/// A shape with parameters, and what its surface must be like.
struct Sample {
  std::string label;
  std::string name;
  ParameterValues parameters;
  double size = 0;
  double smallest_angle_deg = 25;
  long euler = 2;
};

void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.label; }

class EveryShape : public testing::TestWithParam<Sample> {
 protected:
  SurfaceMesh surface = make_shape(GetParam().name, GetParam().parameters, GetParam().size);
};

TEST_P(EveryShape, IsClosedAndManifold) {
  const mesh::Topology topology(surface);
  EXPECT_TRUE(topology.is_closed());
  EXPECT_EQ(euler_characteristic(surface), GetParam().euler);
}

TEST_P(EveryShape, SharesPointsInsteadOfRepeatingThem) {
  std::set<std::array<double, 3>> distinct;
  for (const Vec3& p : surface.points) distinct.insert({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0});
  EXPECT_EQ(distinct.size(), surface.points.size());
}

TEST_P(EveryShape, PointsOutward) { EXPECT_GT(volume(surface), 0); }

TEST_P(EveryShape, HasGoodTriangles) { EXPECT_GT(smallest_angle_deg(surface), GetParam().smallest_angle_deg); }

TEST_P(EveryShape, UsesAllItsPatches) {
  std::set<PatchId> used(surface.face_patch.begin(), surface.face_patch.end());
  EXPECT_EQ(used.size(), surface.patch_names.size());
  EXPECT_EQ(patches(surface).size(), surface.patch_names.size());
}

TEST_P(EveryShape, DoesNotMeetItself) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& [a, b, c] : surface.faces) triangles.push_back({a.index(), b.index(), c.index()});
  EXPECT_TRUE(search::self_intersections({surface.points.raw(), triangles}).empty());
}

TEST_P(EveryShape, IsTheSameEachTime) {
  const SurfaceMesh again = make_shape(GetParam().name, GetParam().parameters, GetParam().size);
  EXPECT_EQ(again.points, surface.points);
  EXPECT_EQ(again.faces, surface.faces);
  EXPECT_EQ(again.face_patch, surface.face_patch);
  EXPECT_EQ(again.patch_names, surface.patch_names);
}

TEST_P(EveryShape, ScalesExactlyByPowersOfTwo) {
  const ShapeInfo& info = *std::find_if(catalogue().begin(), catalogue().end(),
                                        [](const ShapeInfo& s) { return s.name == GetParam().name; });
  if (info.name == "onera-m6" || info.name == "ahmed") return;  // made to one size
  constexpr double kScale = 1.0 / 1024;
  ParameterValues scaled;
  for (const ShapeParameter& p : info.parameters) {
    const auto given = GetParam().parameters.find(p.name);
    const double value = given == GetParam().parameters.end() ? p.value : given->second;
    scaled[p.name] = p.unit == "length" ? value * kScale : value;
  }
  SurfaceMesh expected = surface;
  for (Vec3& p : expected.points) p *= kScale;
  const SurfaceMesh small = make_shape(info.name, scaled, GetParam().size * kScale);
  EXPECT_EQ(small.points, expected.points);
  EXPECT_EQ(small.faces, expected.faces);
}

/// All shapes with their defaults, then sizes and parameters that ask for something else. Sharp tips and leading edges
/// that are much rounder than their wing is long bound the smallest angle.
const std::vector<Sample> kSamples = {
    {"sphere", "sphere", {}, 0, 50},
    {"coarse_sphere", "sphere", {}, 10, 45},
    {"fine_sphere", "sphere", {{"radius", 3}}, 0.1, 50},
    {"ellipsoid", "ellipsoid", {}, 0, 30},
    {"flat_ellipsoid", "ellipsoid", {{"length", 3}, {"width", 2}, {"height", 0.3}}, 0.05, 5},
    {"torus", "torus", {}, 0, 30, 0},
    {"coarse_torus", "torus", {{"tube-radius", 0.8}}, 1, 15, 0},
    {"cylinder", "cylinder", {}, 0, 30},
    {"coarse_cylinder", "cylinder", {}, 5, 25},
    {"disc", "cylinder", {{"length", 0.05}}, 0.05, 25},
    {"cone", "cone", {}, 0, 15},
    {"slender_cone", "cone", {{"half-angle", 5}}, 0, 4},
    {"blunt_cone", "cone", {{"half-angle", 70}}, 0.2, 10},
    {"capsule", "capsule", {}, 0, 30},
    {"coarse_capsule", "capsule", {}, 1, 25},
    {"cube", "cube", {}, 0, 28},
    {"twelve_triangles", "cube", {}, 1, 44},
    {"fine_cube", "cube", {}, 0.03, 28},
    {"box", "box", {}, 0, 25},
    {"plate", "plate", {}, 0, 25},
    {"wedge", "wedge", {}, 0, 15},
    {"sharp_wedge", "wedge", {{"angle", 5}}, 0, 3},
    {"step", "step", {}, 0, 25},
    {"notch", "notch", {}, 0, 25},
    {"narrow_notch", "notch", {{"angle", 10}}, 0.2, 4},
    {"groove", "groove", {}, 0, 25},
    {"block_on_floor", "block-on-floor", {}, 0, 25},
    {"saddle_block", "saddle-block", {}, 0, 25},
    {"steep_saddle_block", "saddle-block", {{"rise", 0.65}}, 0.05, 8},
    {"star", "star", {}, 0, 20},
    {"star_of_12", "star", {{"points", 12}, {"height", 2}}, 0.3, 3},
    {"bend", "bend", {}, 0, 30},
    {"tight_bend", "bend", {{"bend-radius", 0.6}, {"angle", 180}}, 0.1, 8},
    {"two_boxes", "two-boxes", {}, 0, 25, 4},
    {"two_spheres", "two-spheres", {}, 0, 45, 4},
    {"small_gap", "two-spheres", {{"gap", 1e-3}, {"second-radius", 0.05}}, 0, 45, 4},
    {"concentric_spheres", "concentric-spheres", {}, 0, 45, 4},
    {"thin_shell", "concentric-spheres", {{"inner-radius", 0.9}}, 1, 45, 4},
    {"naca0012", "naca", {}, 0, 4},
    {"naca4412_swept_blunt", "naca", {{"digits", 4412}, {"sweep", 35}, {"taper", 0.4}, {"blunt", 1}}, 0.05, 1},
    {"naca2418_flat_tips", "naca", {{"digits", 2418}, {"rounded-tip", 0}}, 0.06, 2},
    {"half_naca_blunt_flat", "naca", {{"half", 1}, {"blunt", 1}, {"rounded-tip", 0}, {"span", 1}}, 0.02, 4},
    {"fine_blunt_base", "naca", {{"digits", 30}, {"half", 1}, {"blunt", 1}, {"span", 0.3}}, 0.005, 4},
    {"onera_m6", "onera-m6", {}, 0, 4},
    {"half_onera_m6", "onera-m6", {{"half", 1}}, 0.02, 3},
    {"blunt_onera_m6", "onera-m6", {{"blunt", 1}, {"rounded-tip", 0}}, 0.03, 1},
    {"wing_body", "wing-body", {}, 0, 1.5},
    {"high_blunt_wing_body",
     "wing-body",
     {{"wing-height", 0.6}, {"blunt", 1}, {"sweep", 0}, {"rounded-tip", 0}},
     0.1,
     0.4},
    {"ahmed", "ahmed", {}, 0, 25},
    {"ahmed_on_stilts", "ahmed", {{"stilts", 1}}, 0, 20, 2},
    {"coarse_ahmed_35", "ahmed", {{"slant-angle", 35}}, 0.05, 12},
};

INSTANTIATE_TEST_SUITE_P(Gallery, EveryShape, testing::ValuesIn(kSamples),
                         [](const auto& sample) { return sample.param.label; });

TEST(Gallery, CoversTheCatalogue) {
  for (const ShapeInfo& info : catalogue()) {
    EXPECT_TRUE(std::any_of(kSamples.begin(), kSamples.end(), [&](const Sample& s) {
      return s.name == info.name && s.parameters.empty() && s.size == 0;
    })) << info.name;
  }
}

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
  // Four rounded sides of radius 100 mm seen from the front: 389 x 288 in all.
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

// What every shape promises, over sizes and parameters.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "nearwall/mesh/topology.h"
#include "nearwall/search/self_intersection.h"
#include "nearwall/shapes/shapes.h"
#include "tests/shapes/surface_measures.h"

namespace nearwall::shapes {
namespace {

using mesh::SurfaceMesh;

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
  if (info.name == "onera-m6" || info.name == "ahmed" || info.name == "ahmed-tunnel") return;  // made to one size
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
    {"quarter_cylinder", "quarter-cylinder", {}, 0, 25},
    {"coarse_quarter_cylinder", "quarter-cylinder", {}, 5, 25},
    {"quarter_disc", "quarter-cylinder", {{"length", 0.05}}, 0.05, 25},
    {"cone", "cone", {}, 0, 15},
    {"slender_cone", "cone", {{"half-angle", 5}}, 0, 4},
    {"blunt_cone", "cone", {{"half-angle", 70}}, 0.2, 10},
    {"capsule", "capsule", {}, 0, 30},
    {"coarse_capsule", "capsule", {}, 1, 25},
    {"cube", "cube", {}, 0, 28},
    {"twelve_triangles", "cube", {}, 1, 44},
    {"fine_cube", "cube", {}, 0.05, 28},
    {"box", "box", {}, 0, 25},
    {"plate", "plate", {}, 0, 25},
    {"wedge", "wedge", {}, 0, 15},
    {"sharp_wedge", "wedge", {{"angle", 5}}, 0, 3},
    {"step", "step", {}, 0, 25},
    {"notch", "notch", {}, 0, 25},
    {"narrow_notch", "notch", {{"angle", 10}}, 0.2, 4},
    {"groove", "groove", {}, 0, 25},
    {"block_on_floor", "block-on-floor", {}, 0, 25},
    {"pit", "pit", {}, 0, 25},
    {"deep_pit", "pit", {{"edge", 0.2}, {"depth", 1.3}}, 0.1, 25},
    {"ski_jump", "ski-jump", {}, 0, 23},
    {"kinked_ski_jump", "ski-jump", {{"lip-radius", 0}, {"lip-angle", 80}}, 0.1, 8},
    {"ski_jump_corner", "ski-jump-corner", {}, 0, 20},
    {"steep_ski_jump_corner", "ski-jump-corner", {{"lip-angle", 85}}, 0.2, 4},
    {"octants", "octants", {}, 0, 25},
    {"blind_octants", "octants", {{"pattern", 139}}, 0.3, 25},
    {"crown", "crown", {}, 0, 22},
    {"crown_of_8", "crown", {{"points", 8}, {"ridge-slope", 65}, {"valley-slope", 60}, {"height", 3}}, 0, 4},
    {"saddle_of_ridges", "crown", {{"points", 2}, {"ridge-slope", 50}, {"valley-slope", 50}}, 0.3, 21},
    {"hollow_crown", "crown", {{"points", 4}, {"ridge-slope", 50}, {"valley-slope", -20}}, 0.3, 25},
    {"pyramid", "pyramid", {}, 0, 19},
    {"needle", "pyramid", {{"sides", 3}, {"half-angle", 1}}, 0.02, 1},
    {"blunt_pyramid", "pyramid", {{"sides", 12}, {"half-angle", 70}}, 0.5, 19},
    {"omni_saddle", "omni-saddle", {}, 0, 15},
    {"omni_saddle_of_5", "omni-saddle", {{"arms", 5}, {"arm-width", 0.6}, {"tip-distance", 0.1}}, 0.2, 17},
    {"knife_plate", "knife-plate", {}, 0, 25},
    {"long_knife_plate", "knife-plate", {{"length", 3}, {"angle", 60}}, 0.2, 25},
    {"delta_wing", "delta-wing", {}, 0, 14},
    {"broad_delta_wing", "delta-wing", {{"apex-angle", 100}, {"angle", 40}}, 0.2, 17},
    {"kinked_wing", "kinked-wing", {}, 0, 6},
    {"much_kinked_wing", "kinked-wing", {{"kink", 60}, {"angle", 30}}, 0.2, 11},
    {"unkinked_wing", "kinked-wing", {{"kink", 0}}, 0.2, 8},
    {"twisted_roof", "twisted-roof", {}, 0, 12},
    {"much_twisted_roof", "twisted-roof", {{"turn", 150}, {"height", 2}}, 0.1, 5},
    {"kinked_roof", "kinked-roof", {}, 0, 25},
    {"much_kinked_roof", "kinked-roof", {{"turn", 110}}, 0.1, 22},
    {"fin_on_plate", "fin-on-plate", {}, 0, 8},
    {"leaning_fin_on_plate", "fin-on-plate", {{"sweep", -60}, {"angle", 40}}, 0.2, 25},
    {"fin_on_sphere", "fin-on-sphere", {}, 0, 8},
    {"long_fin_on_sphere", "fin-on-sphere", {{"chord", 1.2}, {"angle", 3}}, 0.15, 2},
    {"fading_ridge", "fading-ridge", {}, 0, 25},
    {"fading_ridge_on_a_saddle", "fading-ridge", {{"saddle", 1}, {"turn", 140}}, 0, 18},
    {"coarse_fading_ridge", "fading-ridge", {}, 1, 25},
    {"saddle_block", "saddle-block", {}, 0, 25},
    {"steep_saddle_block", "saddle-block", {{"rise", 0.65}}, 0.05, 8},
    {"star", "star", {}, 0, 20},
    {"star_of_12", "star", {{"points", 12}, {"height", 2}}, 0.3, 3},
    {"bend", "bend", {}, 0, 30},
    {"tight_bend", "bend", {{"bend-radius", 0.6}, {"angle", 180}}, 0.1, 8},
    {"vessel", "vessel", {}, 0, 15},
    {"coarse_vessel", "vessel", {}, 1, 12},
    {"sharply_forked_vessel", "vessel", {{"angle", 40}, {"outlet-radius", 0.3}}, 0.05, 8},
    {"wide_vessel", "vessel", {{"angle", 180}, {"outlet-radius", 0.5}}, 0.1, 15},
    {"two_boxes", "two-boxes", {}, 0, 25, 4},
    {"two_spheres", "two-spheres", {}, 0, 45, 4},
    {"small_gap", "two-spheres", {{"gap", 1e-3}, {"second-radius", 0.05}}, 0, 45, 4},
    {"half_two_spheres", "two-spheres", {{"half", 1}}, 0, 25, 4},
    {"half_small_gap", "two-spheres", {{"half", 1}, {"gap", 1e-3}, {"second-radius", 0.05}}, 0.3, 20, 4},
    {"concentric_spheres", "concentric-spheres", {}, 0, 45, 4},
    {"thin_shell", "concentric-spheres", {{"inner-radius", 0.9}}, 1, 45, 4},
    {"sphere_in_box", "sphere-in-box", {}, 0, 25, 4},
    {"coarse_sphere_in_box", "sphere-in-box", {{"radius", 1.8}}, 10, 25, 4},
    {"naca0012", "naca", {}, 0, 4},
    {"naca4412_swept_blunt", "naca", {{"digits", 4412}, {"sweep", 35}, {"taper", 0.4}, {"blunt", 1}}, 0.05, 1},
    {"naca2418_flat_tips", "naca", {{"digits", 2418}, {"rounded-tip", 0}}, 0.06, 2},
    {"half_naca_blunt_flat", "naca", {{"half", 1}, {"blunt", 1}, {"rounded-tip", 0}, {"span", 1}}, 0.02, 4},
    {"fine_blunt_base", "naca", {{"digits", 30}, {"half", 1}, {"blunt", 1}, {"span", 0.3}}, 0.01, 3},
    {"onera_m6", "onera-m6", {}, 0, 4},
    {"half_onera_m6", "onera-m6", {{"half", 1}}, 0.02, 3},
    {"blunt_onera_m6", "onera-m6", {{"blunt", 1}, {"rounded-tip", 0}}, 0.03, 1},
    {"wing_body", "wing-body", {}, 0, 1.5},
    {"high_blunt_wing_body",
     "wing-body",
     {{"wing-height", 0.6}, {"blunt", 1}, {"sweep", 0}, {"rounded-tip", 0}},
     0.1,
     0.4},
    {"half_wing_body", "wing-body", {{"half", 1}}, 0, 1.5},
    {"coarse_half_wing_body", "wing-body", {{"half", 1}, {"blunt", 1}, {"rounded-tip", 0}}, 0.2, 0.4},
    {"ahmed", "ahmed", {}, 0, 25},
    {"ahmed_on_stilts", "ahmed", {{"stilts", 1}}, 0, 20, 2},
    {"coarse_ahmed_35", "ahmed", {{"slant-angle", 35}}, 0.05, 12},
    {"ahmed_tunnel", "ahmed-tunnel", {}, 0, 20},
    {"ahmed_tunnel_with_stilts", "ahmed-tunnel", {{"stilts", 1}}, 0.03, 12, -2},
    {"narrow_ahmed_tunnel", "ahmed-tunnel", {{"width", 1}, {"height", 0.6}, {"box-size", 0.01}}, 0.05, 12},
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

}  // namespace
}  // namespace nearwall::shapes

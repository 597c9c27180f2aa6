// Runs that fill the whole volume, and such that cannot.
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/io/surface_reader.h"
#include "nearwall/io/surface_writer.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/pipeline/run.h"
#include "nearwall/shapes/shapes.h"
#include "tests/pipeline/scratch_folder.h"
#include "tests/support/shapes.h"

namespace nearwall {
namespace {

namespace fs = std::filesystem;
using mesh::SurfaceMesh;
using testing::HasSubstr;
using Json = nlohmann::json;

class VolumeRun : public testing::Test {
 protected:
  void SetUp() override { ::setenv("NEARWALL_TETGEN", NEARWALL_TETGEN_PROGRAM, 1); }
  void TearDown() override { ::unsetenv("NEARWALL_TETGEN"); }

  /// Meshes a surface with three layers and the whole volume.
  Report meshed(const SurfaceMesh& surface, const std::string& more, const std::string& of_surface = "") const {
    io::write_surface(folder_ / "body.vtp", surface);
    folder_.write("case.toml", "[surface]\nfile = \"body.vtp\"\n" + of_surface +
                                   "[layers]\nfirst_height = 0.01\ncount = 3\n[output]\npictures = false\n" + more);
    return run(read_case(folder_ / "case.toml"));
  }
  bool has(const std::string& file) const { return fs::exists(folder_ / "out" / file); }

  /// What one that knows nothing of the making says of the file.
  void expect_certified() const {
    const auto certificate = certify::certify_mesh(io::read_volume_mesh(folder_ / "out/body.vtu").mesh);
    EXPECT_TRUE(certificate.is_valid());
    ASSERT_TRUE(certificate.closure());
    EXPECT_LT(*certificate.closure(), 1e-12);
  }

  ScratchFolder folder_;
};

std::size_t patch_of(const Report& report, const std::string& name) {
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    if (report.patches[p].name == name) return p;
  }
  ADD_FAILURE() << "no patch " << name;
  return 0;
}

const BoundaryPatch& boundary_of(const Report& report, const std::string& name) {
  return report.volume->boundary[patch_of(report, name)];
}

double area_of(const SurfaceMesh& surface, const std::string& patch) {
  double area = 0;
  for (const FaceId f : surface.faces.ids()) {
    if (surface.patch_names[surface.face_patch[f]] != patch) continue;
    const auto [a, b, c] = surface.triangle(f);
    area += geometry::triangle_area(a, b, c);
  }
  return area;
}

const std::string kFilled = "[volume]\nfill = \"tetgen\"\nfarfield = { radius = 6, size = 2 }\n";

TEST_F(VolumeRun, FillsTheSpaceRoundABody) {
  const Report report = meshed(shapes_for_tests::cube(), kFilled);
  EXPECT_EQ(report.volume_failure, "");
  ASSERT_TRUE(report.volume);
  EXPECT_TRUE(report.volume->certificate.is_valid());
  EXPECT_LT(report.volume->certificate.closure(), 1e-12);
  EXPECT_GT(report.volume->tetrahedra, 0u);
  const auto& wall = boundary_of(report, "wall");
  EXPECT_EQ(wall.triangles, 12u);
  EXPECT_EQ(wall.quads, 0u);
  EXPECT_NEAR(wall.area, 6, 1e-12);
  const double sphere = 4 * geometry::kPi * 36;
  EXPECT_LT(boundary_of(report, "farfield").area, sphere);
  EXPECT_GT(boundary_of(report, "farfield").area, 0.8 * sphere);
  EXPECT_EQ(report.patches[patch_of(report, "farfield")].type, PatchType::FarField);
  EXPECT_EQ(report.n_cells(), 12 * 3 + report.volume->tetrahedra);
  for (const char* file : {"body.vtu", "body-boundary.vtp", "body-surface.vtp", "body-front.vtp"}) {
    EXPECT_TRUE(has(file)) << file;
  }
  EXPECT_FALSE(has("body-layers.vtu"));
  EXPECT_FALSE(has("body-fill-faults.vtp"));
  expect_certified();
  const Json json = Json::parse(folder_.read("out/report.json"));
  EXPECT_FALSE(json.contains("volume_failure"));
  EXPECT_TRUE(json.contains("volume"));
}

TEST_F(VolumeRun, WritesABoundaryThatIsTheDomains) {
  const Report report = meshed(shapes_for_tests::cube(), kFilled);
  const SurfaceMesh boundary = io::read_surface(folder_ / "out/body-boundary.vtp");
  double volume = 0;
  for (const FaceId f : boundary.faces.ids()) {
    const auto [a, b, c] = boundary.triangle(f);
    volume += dot(cross(a, b), c) / 6;
  }
  EXPECT_NEAR(volume, report.volume->certificate.enclosed_volume, 1e-12 * volume);
  const SurfaceMesh cube = shapes_for_tests::cube();
  for (const FaceId f : cube.faces.ids()) {
    const auto [a, b, c] = boundary.triangle(f);
    EXPECT_EQ((std::array{a, c, b}), cube.triangle(f)) << "the wall first, in its order, seen from outside";
  }
}

/// Half an octahedron's sphere, open in y = 0 but for a little noise.
SurfaceMesh open_half_sphere() {
  SurfaceMesh half;
  const SurfaceMesh whole = shapes_for_tests::sphere(2);
  half.patch_names = whole.patch_names;
  std::map<VertexId, VertexId> number;
  for (const FaceId f : whole.faces.ids()) {
    const auto [a, b, c] = whole.triangle(f);
    if (std::min({a.y(), b.y(), c.y()}) < 0) continue;
    auto face = whole.faces[f];
    for (VertexId& v : face) {
      const auto [found, is_new] = number.try_emplace(v);
      const double noise = 1e-7 * static_cast<double>(v.index() % 7);
      if (is_new) found->second = half.points.push_back(whole.points[v] + Vec3(0, noise, 0));
      v = found->second;
    }
    half.faces.push_back(face);
    half.face_patch.push_back(PatchId(0));
  }
  return half;
}

TEST_F(VolumeRun, ClosesAHalfBodyAtItsPlane) {
  const Report report = meshed(open_half_sphere(), kFilled + "symmetry = \"y\"\n");
  ASSERT_TRUE(report.volume) << report.volume_failure;
  EXPECT_EQ(report.patches[patch_of(report, "symmetry")].type, PatchType::Symmetry);
  const auto& plane = boundary_of(report, "symmetry");
  EXPECT_EQ(plane.quads, 16u * 3) << "three layers on each edge of the rim";
  // The disc within the far field's rim of at least 12 edges, less that of the body's 16.
  const auto polygon = [](double radius, int n) { return 0.5 * n * radius * radius * std::sin(2 * geometry::kPi / n); };
  EXPECT_LT(plane.area, polygon(6, 1000) - polygon(1, 16) + 0.1);
  EXPECT_GT(plane.area, polygon(6, 12) - geometry::kPi - 0.1);
  expect_certified();
  const auto is_said = [&](const std::string& words) {
    return std::any_of(report.notes.begin(), report.notes.end(),
                       [&](const std::string& note) { return note.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(is_said("open at the plane of symmetry y"));
  // The middle one of the noisy coordinates is taken, and all points of the plane have just that one.
  const SurfaceMesh boundary = io::read_surface(folder_ / "out/body-boundary.vtp");
  double lowest = 1;
  for (const Vec3& p : boundary.points) lowest = std::min(lowest, p.y());
  EXPECT_GE(lowest, 0);
  EXPECT_LE(lowest, 6e-7);
}

TEST_F(VolumeRun, FillsALumenWithItsCaps) {
  const SurfaceMesh bend = shapes::make_shape("bend", {{"angle", 30}}, 0.3);
  const Report report = meshed(bend,
                               "[volume]\nfill = \"tetgen\"\n[patches.inlet]\ntype = \"inlet\"\n[patches.outlet]\n"
                               "type = \"outlet\"\n",
                               "fluid = \"inside\"\n");
  ASSERT_TRUE(report.volume) << report.volume_failure;
  for (const char* patch : {"inlet", "outlet", "wall"}) {
    const double area = area_of(bend, patch);
    EXPECT_NEAR(boundary_of(report, patch).area, area, 1e-10 * area) << patch;
    EXPECT_EQ(boundary_of(report, patch).quads > 0, std::string(patch) != "wall") << patch;
  }
  double volume = 0;
  for (const FaceId f : bend.faces.ids()) {
    const auto [a, b, c] = bend.triangle(f);
    volume += dot(cross(a, b), c) / 6;
  }
  EXPECT_NEAR(report.volume->certificate.cells_volume, volume, 1e-12 * volume);
  expect_certified();
}

/// Two patches in one plane keep what is theirs, as far as the triangles allow.
TEST_F(VolumeRun, KeepsThePatchesOfOnePlaneApart) {
  SurfaceMesh room = shapes_for_tests::subdivided(shapes_for_tests::subdivided(shapes_for_tests::cube()));
  const PatchId low = room.patch_names.push_back("low"), high = room.patch_names.push_back("high");
  for (const FaceId f : room.faces.ids()) {
    const auto [a, b, c] = room.triangle(f);
    const Vec3 middle = (a + b + c) / 3;
    if (middle.x() == 0.5) room.face_patch[f] = middle.z() < 0 ? low : high;
  }
  const Report report =
      meshed(room, "[volume]\nfill = \"tetgen\"\n[patches.low]\ntype = \"outlet\"\n[patches.high]\ntype = \"outlet\"\n",
             "fluid = \"inside\"\n");
  ASSERT_TRUE(report.volume) << report.volume_failure;
  const double a = boundary_of(report, "low").area, b = boundary_of(report, "high").area;
  EXPECT_NEAR(a + b, 1, 1e-12);
  EXPECT_NEAR(a, 0.5, 0.03) << "their border is kept outside of the layers";
  expect_certified();
}

/// What is left where the volume cannot be had: the layers under a name of their own, and why.
void expect_layers_alone(const Report& report, const fs::path& out) {
  EXPECT_NE(report.volume_failure, "");
  EXPECT_FALSE(report.volume);
  EXPECT_TRUE(report.certified) << "the layers are";
  EXPECT_EQ(report.n_cells(), 36u);
  EXPECT_TRUE(fs::exists(out / "body-layers.vtu"));
  EXPECT_FALSE(fs::exists(out / "body-fill-faults.vtp")) << "nobody knows which triangles are to blame";
  EXPECT_FALSE(fs::exists(out / "body.vtu"));
  EXPECT_FALSE(fs::exists(out / "body-boundary.vtp"));
  EXPECT_EQ(std::count(report.files.begin(), report.files.end(), "body-layers.vtu"), 1);
  const auto certificate = certify::certify_mesh(io::read_volume_mesh(out / "body-layers.vtu").mesh);
  EXPECT_TRUE(certificate.is_valid());
  EXPECT_EQ(certificate.n_cells(), 36u);
}

TEST_F(VolumeRun, WritesTheLayersAloneWhereTheFillFails) {
  ::setenv("NEARWALL_TETGEN", "/bin/false", 1);
  const Report report = meshed(shapes_for_tests::cube(), kFilled);
  expect_layers_alone(report, folder_ / "out");
  const Json json = Json::parse(folder_.read("out/report.json"));
  EXPECT_EQ(json["volume_failure"], report.volume_failure);
}

TEST_F(VolumeRun, WritesTheLayersAloneWhereTheFillCrashes) {
  const fs::path program = folder_.write("crash", "#!/bin/sh\nkill -SEGV $$\n");
  fs::permissions(program, fs::perms::owner_all);
  ::setenv("NEARWALL_TETGEN", program.c_str(), 1);
  const Report report = meshed(shapes_for_tests::cube(), kFilled);
  expect_layers_alone(report, folder_ / "out");
  EXPECT_THAT(report.volume_failure, HasSubstr("signal"));
}

TEST_F(VolumeRun, WritesTheLayersAloneWhereTheFillSaysNothing) {
  ::setenv("NEARWALL_TETGEN", "/bin/true", 1);
  expect_layers_alone(meshed(shapes_for_tests::cube(), kFilled), folder_ / "out");
}

TEST_F(VolumeRun, RefusesPlanesThatCutTheBody) {
  EXPECT_THROW(meshed(shapes_for_tests::cube(), kFilled + "symmetry = \"y\"\n"), InputError);
  EXPECT_FALSE(has("body.vtu"));
}

TEST_F(VolumeRun, RefusesAFarFieldWithinTheBody) {
  EXPECT_THROW(meshed(shapes_for_tests::cube(), "[volume]\nfill = \"tetgen\"\nfarfield = { radius = 0.4 }\n"),
               InputError);
}

TEST_F(VolumeRun, RefusesHolesThatAreOnNoPlane) {
  SurfaceMesh open = shapes_for_tests::subdivided(shapes_for_tests::cube());
  open.faces.raw().pop_back();
  open.face_patch.raw().pop_back();
  EXPECT_THROW(meshed(open, kFilled + "symmetry = \"y\"\n"), GeometryError);
}

TEST_F(VolumeRun, ForecastsWithoutFilling) {
  io::write_surface(folder_ / "body.vtp", shapes_for_tests::cube());
  folder_.write("case.toml", "[surface]\nfile = \"body.vtp\"\n[layers]\nfirst_height = 0.01\ncount = 3\n" + kFilled);
  ::setenv("NEARWALL_TETGEN", "/bin/false", 1);
  RunOptions options;
  options.dry_run = true;
  const Report report = run(read_case(folder_ / "case.toml"), options);
  EXPECT_EQ(report.volume_failure, "");
  EXPECT_EQ(report.forecast.n_cells, 36u) << "layers";
}

}  // namespace
}  // namespace nearwall

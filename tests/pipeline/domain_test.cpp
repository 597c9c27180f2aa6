#include "pipeline/domain.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/io/surface_writer.h"
#include "nearwall/shapes/shapes.h"
#include "pipeline/prepare.h"
#include "tests/pipeline/scratch_folder.h"
#include "tests/support/moved.h"
#include "tests/support/shapes.h"

namespace nearwall::pipeline {
namespace {

using mesh::SurfaceMesh;
using testing::HasSubstr;

/// A case for a surface that is written beside it.
class PreparedDomain : public testing::Test {
 protected:
  Prepared prepared(const SurfaceMesh& surface, const std::string& more, const std::string& of_surface = "") const {
    io::write_surface(folder_ / "body.vtp", surface);
    folder_.write("case.toml", "[surface]\nfile = \"body.vtp\"\n" + of_surface +
                                   "[layers]\nfirst_height = 0.01\ncount = 3\n" + more);
    return prepare(read_case(folder_ / "case.toml"), silent_progress());
  }
  ScratchFolder folder_;
};

PatchType type_of(const Prepared& p, const std::string& patch) {
  const auto& names = p.surface().patch_names.raw();
  const auto types = patch_types(p.settings, names);
  const auto found = std::find(names.begin(), names.end(), patch);
  if (found == names.end()) throw InputError("no patch " + patch);
  return types[static_cast<std::size_t>(found - names.begin())];
}

const std::string kQuarter =
    "[volume]\nfill = \"tetgen\"\nfarfield = { radius = 10, size = 5 }\n"
    "[patches.\"symmetry-*\"]\ntype = \"symmetry\"\n";

TEST_F(PreparedDomain, KnowsTheTrianglesOfTheFile) {
  const SurfaceMesh file = shapes::make_shape("quarter-cylinder", {}, 0.2);
  const Prepared p = prepared(file, kQuarter);
  EXPECT_TRUE(p.fluid_is_inside) << "within the far field";
  ASSERT_EQ(p.wall.planes.planes.size(), 2u);
  ASSERT_EQ(p.input_face.size(), p.surface().faces.size());
  std::size_t n_of_file = 0, n_cut = 0;
  for (const FaceId f : p.surface().faces.ids()) {
    const bool is_far = p.surface().patch_names[p.surface().face_patch[f]] == "farfield";
    EXPECT_EQ(p.input_face[f].is_valid(), !is_far);
    if (is_far) continue;
    ++n_of_file;
    EXPECT_EQ(p.surface().triangle(f), file.triangle(p.input_face[f]));
    EXPECT_EQ(p.surface().patch_names[p.surface().face_patch[f]], file.patch_names[file.face_patch[p.input_face[f]]]);
  }
  for (const FaceId f : file.faces.ids()) {
    n_cut += file.patch_names[file.face_patch[f]].substr(0, 8) == "symmetry";
  }
  EXPECT_EQ(n_of_file + n_cut, file.faces.size());
  EXPECT_EQ(type_of(p, "farfield"), PatchType::FarField);
  EXPECT_EQ(type_of(p, "symmetry-y"), PatchType::Symmetry);
  EXPECT_EQ(type_of(p, "side"), PatchType::Wall);
}

TEST_F(PreparedDomain, FindsRidgesThatRunIntoPlanes) {
  const Prepared p = prepared(shapes::make_shape("quarter-cylinder", {}, 0.2), kQuarter);
  // The rims of front and base go on in the other quarters.
  int n_on_planes = 0;
  for (const VertexId v : p.surface().points.ids()) {
    EXPECT_NE(p.features.kind[v], surface::PointKind::RidgeEnd);
    n_on_planes += p.wall.planes.is_on_plane(v) && p.features.kind[v] == surface::PointKind::Ridge;
  }
  EXPECT_EQ(n_on_planes, 4);
}

TEST_F(PreparedDomain, HasAFarFieldOnlyRoundWhatTheFluidFlowsRound) {
  const std::string filled = "[volume]\nfill = \"tetgen\"\n";
  const auto far = [&](const std::string& volume, const std::string& fluid) {
    folder_.write("case.toml", "[surface]\nfile = \"body.vtp\"\nfluid = \"" + fluid +
                                   "\"\n[layers]\nfirst_height = 0.01\ncount = 3\n" + volume);
    return has_far_field(read_case(folder_ / "case.toml"));
  };
  EXPECT_TRUE(far(filled, "outside"));
  EXPECT_FALSE(far(filled, "inside"));
  EXPECT_FALSE(far("", "outside"));
  EXPECT_TRUE(far("[volume]\nsymmetry = \"y\"\n", "outside")) << "layers of half bodies need the plane's outer edge";
}

TEST_F(PreparedDomain, LeavesClosedBodiesWithoutAFillAsTheyAre) {
  const SurfaceMesh cube = shapes_for_tests::cube();
  const Prepared p = prepared(cube, "");
  EXPECT_EQ(p.surface().faces, cube.faces);
  EXPECT_EQ(p.surface().points, cube.points);
  EXPECT_TRUE(p.wall.planes.empty());
  EXPECT_TRUE(p.notes.empty());
  EXPECT_FALSE(p.fluid_is_inside);
}

TEST_F(PreparedDomain, TellsHowFarPointsWereMovedOntoPlanes) {
  SurfaceMesh room = shapes_for_tests::subdivided(shapes_for_tests::cube());
  const PatchId outlet = room.patch_names.push_back("outlet");
  for (const FaceId f : room.faces.ids()) {
    const auto [a, b, c] = room.triangle(f);
    if (a.x() + b.x() + c.x() == 1.5) room.face_patch[f] = outlet;
  }
  for (const VertexId v : room.points.ids()) {
    if (room.points[v] == Vec3(0.5, 0, 0)) room.points[v] = Vec3(0.5 + 1e-7, 0, 0);
  }
  const std::string outlet_type = "[patches.outlet]\ntype = \"outlet\"\n";
  const Prepared p = prepared(room, outlet_type, "fluid = \"inside\"\n");
  ASSERT_EQ(p.wall.planes.planes.size(), 1u);
  EXPECT_EQ(p.wall.planes.planes[0].offset * p.wall.planes.planes[0].normal.x(), 0.5);
  ASSERT_FALSE(p.notes.empty());
  EXPECT_THAT(p.notes[0], HasSubstr("1e-07"));
}

TEST_F(PreparedDomain, RefusesObliquePlanesOfSymmetryOfExternalFlows) {
  const gallery::Rotation rotate(3);
  const SurfaceMesh turned = shapes_for_tests::mapped(shapes::make_shape("two-spheres", {{"half", 1}}, 0.4), rotate);
  try {
    prepared(turned, "[volume]\nfill = \"tetgen\"\n[patches.symmetry]\ntype = \"symmetry\"\n");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("normal to x, y or z"));
  }
}

TEST_F(PreparedDomain, GivesRolesByTypes) {
  SurfaceMesh surface = shapes_for_tests::cube();
  for (const char* name : {"sym", "in", "out", "far", "bare"}) surface.patch_names.push_back(name);
  folder_.write("case.toml",
                "[surface]\nfile = \"body.vtp\"\n[layers]\nfirst_height = 0.01\ncount = 3\n"
                "[patches.sym]\ntype = \"symmetry\"\n[patches.in]\ntype = \"inlet\"\n[patches.out]\ntype = \"outlet\"\n"
                "[patches.far]\ntype = \"farfield\"\n[patches.bare]\ntype = \"nolayer\"\n");
  using surface::SideRole;
  EXPECT_THAT(side_roles(read_case(folder_ / "case.toml"), surface).raw(),
              testing::ElementsAre(SideRole::None, SideRole::Symmetry, SideRole::Opening, SideRole::Opening,
                                   SideRole::Opening, SideRole::None));
}

}  // namespace
}  // namespace nearwall::pipeline

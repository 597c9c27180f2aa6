#include "nearwall/volume/outer_boundary.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/certify/certificate.h"
#include "nearwall/core/errors.h"
#include "nearwall/mesh/topology.h"
#include "tests/volume/open_shapes.h"

namespace nearwall::volume {
namespace {

using namespace open_shapes;
using namespace shapes_for_tests;
using surface::OpenWall;
using testing::HasSubstr;

/// A closed body as a wall without planes.
OpenWall closed_wall(const mesh::SurfaceMesh& surface) { return Closed(surface, {}, FluidSide::Outside).open(); }

FarField sphere_of(double radius, const std::vector<SymmetryPlane>& planes = {}) {
  FarField far;
  far.radius = radius;
  far.size = radius;
  far.planes = planes;
  for (const SymmetryPlane& plane : planes) far.centre[plane.axis] = plane.position;
  return far;
}

/// Edges of the wall in its boundary, and of those how many lie on no plane.
std::pair<std::size_t, std::size_t> boundary_edges(const OpenWall& wall) {
  const mesh::Topology topology(wall.surface);
  std::size_t n = 0, n_loose = 0;
  for (std::size_t i = 0; i < 3 * wall.surface.faces.size(); ++i) {
    const HalfedgeId h(i);
    if (topology.twin(h).is_valid()) continue;
    ++n;
    const bool is_loose = wall.planes.of_edge.empty() || wall.planes.of_edge[h] == mesh::kNoPlane;
    n_loose += is_loose;
    if (is_loose) continue;
    for (const VertexId v : {topology.origin(h), topology.target(h)}) {
      EXPECT_TRUE(wall.planes.is_on(v, wall.planes.of_edge[h]));
      EXPECT_EQ(wall.planes.planes[wall.planes.of_edge[h]].height(wall.surface.points[v]), 0);
    }
  }
  return {n, n_loose};
}

/// With all lines at the wall, the wall and its planes close.
bool closes(const OpenWall& wall) {
  const mesh::Front front = mesh::plain_front(wall.surface);
  certify::FrontSurface base;
  base.points = wall.surface.points.raw();
  base.is_moved.resize(base.points.size(), 0);
  for (const VertexId v : wall.surface.points.ids()) base.point_of_line.push_back(v.index());
  for (const FaceId f : wall.surface.faces.ids()) {
    const auto& v = wall.surface.faces[f];
    base.triangles.push_back({v[0].index(), v[1].index(), v[2].index()});
    base.face.push_back(FrontFaceId(f.index()));
  }
  return certify::close_front(front, wall.planes, base).empty();
}

TEST(AddFarField, AddsAClosedSphereRoundAClosedBody) {
  const mesh::SurfaceMesh body = cube();
  OpenWall wall = closed_wall(body);
  add_far_field(sphere_of(5), wall);
  EXPECT_TRUE(wall.planes.empty());
  EXPECT_GT(wall.surface.faces.size(), body.faces.size());
  EXPECT_EQ(boundary_edges(wall).first, 0u);
  for (const FaceId f : wall.surface.faces.ids()) {
    const bool is_body = f.index() < body.faces.size();
    EXPECT_EQ(wall.face[f].is_valid(), is_body);
    EXPECT_EQ(wall.surface.patch_names[wall.surface.face_patch[f]], is_body ? "wall" : "farfield");
    const auto [a, b, c] = wall.surface.triangle(f);
    EXPECT_EQ(dot(cross(b - a, c - a), a) > 0, is_body) << "normals into the fluid";
  }
  for (const VertexId v : wall.surface.points.ids()) {
    EXPECT_EQ(wall.vertex[v].is_valid(), v.index() < body.points.size());
    if (!wall.vertex[v].is_valid()) {
      EXPECT_NEAR(norm(wall.surface.points[v]), 5, 1e-14);
    }
  }
}

TEST(AddFarField, EndsAtThePlaneOfAHalfBody) {
  const Closed closed(shapes::make_shape("two-spheres", {{"half", 1}}, 0.4), {{"symmetry", SideRole::Symmetry}},
                      FluidSide::Outside);
  OpenWall wall = closed.open();
  add_far_field(sphere_of(20, {{1, 0, 1}}), wall);
  EXPECT_EQ(wall.planes.planes.size(), 1u) << "the same plane, not another one";
  EXPECT_EQ(wall.planes.of_vertex.size(), wall.surface.points.size());
  EXPECT_EQ(wall.planes.of_edge.size(), 3 * wall.surface.faces.size());
  EXPECT_EQ(boundary_edges(wall).second, 0u);
  EXPECT_TRUE(closes(wall));
}

/// Bodies that do not touch the planes: these are added with patches of their own.
TEST(AddFarField, AddsPlanesThatNoBodyTouches) {
  const std::vector<std::vector<SymmetryPlane>> all = {
      {{1, -1, 1}}, {{1, 2, -1}}, {{0, -1, 1}, {2, 3, -1}}, {{0, -1, 1}, {1, 2, -1}, {2, 3, -1}}};
  for (const auto& planes : all) {
    OpenWall wall = closed_wall(cube());
    add_far_field(sphere_of(20, planes), wall);
    ASSERT_EQ(wall.planes.planes.size(), planes.size());
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const mesh::SidePlane& plane = wall.planes.planes[p];
      EXPECT_EQ(plane.axis, planes[p].axis);
      EXPECT_EQ(plane.normal[plane.axis], planes[p].side);
      EXPECT_EQ(plane.offset * plane.normal[plane.axis], planes[p].position);
      EXPECT_EQ(wall.role[p], SideRole::Symmetry);
      EXPECT_TRUE(wall.side_faces[p].empty());
      EXPECT_THAT(wall.surface.patch_names[wall.patch[p]], testing::StartsWith("symmetry"));
      for (const Vec3& x : wall.surface.points) EXPECT_GE(plane.height(x), 0);
    }
    const auto [n, n_loose] = boundary_edges(wall);
    EXPECT_GT(n, 0u);
    EXPECT_EQ(n_loose, 0u);
    EXPECT_TRUE(closes(wall));
  }
}

TEST(AddFarField, GivesItsPatchesNamesOfTheirOwn) {
  mesh::SurfaceMesh body = cube();
  body.patch_names[PatchId(0)] = "farfield";
  body.patch_names.push_back("symmetry");
  OpenWall wall = closed_wall(body);
  add_far_field(sphere_of(20, {{1, -1, 1}, {2, -1, 1}}), wall);
  const auto& names = wall.surface.patch_names.raw();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(names[0], "farfield");
  EXPECT_EQ(names[1], "symmetry");
}

TEST(AddFarField, FillsPointArraysUp) {
  mesh::SurfaceMesh body = cube();
  body.point_arrays.push_back({"height", IdVector<VertexId, double>(body.points.size(), 0.5)});
  OpenWall wall = closed_wall(body);
  add_far_field(sphere_of(5), wall);
  ASSERT_EQ(wall.surface.point_arrays.size(), 1u);
  EXPECT_EQ(wall.surface.point_arrays[0].values.size(), wall.surface.points.size());
  EXPECT_EQ(wall.surface.point_arrays[0].values[VertexId(7)], 0.5);
}

void expect_refused(const FarField& far, OpenWall wall, const std::string& words) {
  try {
    add_far_field(far, wall);
    ADD_FAILURE() << "expected: " << words;
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr(words));
  }
}

TEST(AddFarField, RefusesWhatDoesNotGoRoundTheWall) {
  const OpenWall wall = closed_wall(cube());
  expect_refused(sphere_of(0.2), wall, "within the far field");
  // A sphere whose box holds the cube's, but not its corners: √0.75 is beyond the radius.
  expect_refused(sphere_of(0.7), wall, "within the far field");
  FarField beyond = sphere_of(5);
  beyond.centre = Vec3(4, 4, 4);
  expect_refused(beyond, wall, "within the far field");
  FarField aside = sphere_of(5);
  aside.centre = Vec3(20, 0, 0);
  expect_refused(aside, wall, "within the far field");
}

TEST(AddFarField, RefusesPlanesThatGoThroughTheBody) {
  expect_refused(sphere_of(5, {{1, 0, 1}}), closed_wall(cube()), "y = 0");
  expect_refused(sphere_of(5, {{2, 0.5, 1}}), closed_wall(cube()), "z = 0.5");
  expect_refused(sphere_of(5, {{2, -0.5, 1}}), closed_wall(cube()), "z = -0.5");
}

}  // namespace
}  // namespace nearwall::volume

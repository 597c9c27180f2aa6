#include "nearwall/surface/open_wall.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/mesh/topology.h"
#include "tests/support/closed_surfaces.h"

namespace nearwall::surface {
namespace {

using namespace shapes_for_tests;
using namespace closed_surfaces_for_tests;
using mesh::SurfaceMesh;
using testing::HasSubstr;

std::size_t n_boundary_edges(const SurfaceMesh& surface) {
  const mesh::Topology topology(surface);
  std::size_t n = 0;
  for (std::size_t h = 0; h < 3 * surface.faces.size(); ++h) n += !topology.twin(HalfedgeId(h)).is_valid();
  return n;
}

/// What holds of any: faces and points are those of the closed surface, faces that were taken out are just the rest,
/// and every boundary edge lies on the plane that it is said to lie on, with both ends.
void expect_consistent(const Closed& closed, const OpenWall& wall) {
  std::set<FaceId> seen;
  for (const FaceId f : wall.surface.faces.ids()) {
    const FaceId old = wall.face[f];
    EXPECT_TRUE(seen.insert(old).second);
    EXPECT_EQ(wall.surface.triangle(f), closed.surface.triangle(old));
    EXPECT_EQ(wall.surface.face_patch[f], closed.surface.face_patch[old]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(wall.vertex[wall.surface.faces[f][k]], closed.surface.faces[old][k]);
    }
  }
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  for (std::size_t p = 0; p < wall.planes.planes.size(); ++p) {
    EXPECT_EQ(wall.patch[p], closed.surface.face_patch[wall.side_faces[p].front()]);
    for (const FaceId f : wall.side_faces[p]) {
      EXPECT_TRUE(seen.insert(f).second);
      for (const Vec3& q : closed.surface.triangle(f)) {
        EXPECT_LE(std::abs(wall.planes.planes[p].height(q)), 1e-14 * (1 + norm(q)));
      }
    }
  }
  EXPECT_EQ(seen.size(), closed.surface.faces.size());
  const mesh::Topology topology(wall.surface);
  for (const HalfedgeId h : wall.planes.of_edge.ids()) {
    const mesh::PlaneIndex p = wall.planes.of_edge[h];
    EXPECT_EQ(p != mesh::kNoPlane, !topology.twin(h).is_valid());
    if (p == mesh::kNoPlane) continue;
    EXPECT_TRUE(wall.planes.is_on(topology.origin(h), p) && wall.planes.is_on(topology.target(h), p));
  }
}

/// A box that is the domain: a floor with layers, the other five sides open.
Closed room(SideRole role = SideRole::Opening) {
  SurfaceMesh surface = subdivided(box({0, 0, 0}, {1, 2, 3}));
  paint(surface, "sides", [](const Vec3& p) { return p.z() > 0; });
  return {std::move(surface), {{"sides", role}}, FluidSide::Inside};
}

TEST(OpenAtSides, TakesTheSidesOfARoomThatMeetItsFloor) {
  const Closed closed = room();
  const OpenWall wall = closed.open();
  // The ceiling meets no layers: it stays.
  EXPECT_EQ(wall.planes.planes.size(), 4u);
  EXPECT_EQ(wall.surface.faces.size(), 2 * 8u);
  EXPECT_EQ(n_boundary_edges(wall.surface), 2 * 8u);
  EXPECT_TRUE(wall.notes.empty());
  expect_consistent(closed, wall);
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_GT(wall.planes.planes[p].height({0.5, 1, 1.5}), 0) << "into the domain";
    EXPECT_EQ(wall.side_faces[p].size(), 8u);
    EXPECT_EQ(wall.role[p], SideRole::Opening);
  }
  int n_corners = 0;
  for (const VertexId v : wall.surface.points.ids()) n_corners += wall.planes.of(v).size() == 2;
  EXPECT_EQ(n_corners, 8);
}

TEST(OpenAtSides, KnowsTheRolesOfItsPlanes) {
  const OpenWall wall = room(SideRole::Symmetry).open();
  EXPECT_EQ(wall.planes.planes.size(), 4u);
  for (const SideRole role : wall.role) EXPECT_EQ(role, SideRole::Symmetry);
}

SurfaceMesh without_loose_points(const SurfaceMesh& surface) {
  SurfaceMesh result = surface;
  result.points.clear();
  std::map<VertexId, VertexId> number;
  for (auto& face : result.faces) {
    for (VertexId& v : face) {
      const auto [found, is_new] = number.try_emplace(v);
      if (is_new) found->second = result.points.push_back(surface.points[v]);
      v = found->second;
    }
  }
  return result;
}

/// Half a sphere with its cap in y = 0.
SurfaceMesh half_sphere(int level, double radius = 1) {
  SurfaceMesh surface;
  const SurfaceMesh whole = sphere(level, radius);
  surface.points = whole.points;
  surface.patch_names.push_back("wall");
  for (const FaceId f : whole.faces.ids()) {
    const auto [a, b, c] = whole.triangle(f);
    if (std::min({a.y(), b.y(), c.y()}) < 0) continue;
    surface.faces.push_back(whole.faces[f]);
    surface.face_patch.push_back(PatchId(0));
  }
  const PatchId cap = surface.patch_names.push_back("cut");
  const VertexId middle = surface.points.push_back({0, 0, 0});
  const auto faces = surface.faces;
  for (const auto& v : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = v[k], b = v[(k + 1) % 3];
      if (surface.points[a].y() != 0 || surface.points[b].y() != 0) continue;
      surface.faces.push_back({b, a, middle});
      surface.face_patch.push_back(cap);
    }
  }
  return without_loose_points(surface);
}

TEST(OpenAtSides, OpensHalfABodyTowardsItsOtherHalf) {
  const int level = 2;
  const Closed closed(half_sphere(level), {{"cut", SideRole::Symmetry}}, FluidSide::Outside);
  const OpenWall wall = closed.open();
  const std::size_t n_rim = 4u << level;
  EXPECT_EQ(wall.surface.faces.size(), 4u << (2 * level));
  EXPECT_EQ(n_boundary_edges(wall.surface), n_rim);
  ASSERT_EQ(wall.planes.planes.size(), 1u);
  EXPECT_EQ(wall.planes.planes[0].normal, Vec3(0, 1, 0)) << "the fluid is on the body's side of the plane";
  EXPECT_EQ(wall.planes.planes[0].axis, 1);
  EXPECT_EQ(wall.side_faces[0].size(), n_rim);
  EXPECT_EQ(wall.role[0], SideRole::Symmetry);
  EXPECT_EQ(std::count(wall.vertex.begin(), wall.vertex.end(), VertexId()), 0);
  std::size_t n_on = 0;
  for (const VertexId v : wall.surface.points.ids()) {
    n_on += wall.planes.is_on_plane(v);
    EXPECT_EQ(wall.planes.is_on_plane(v), wall.surface.points[v].y() == 0);
  }
  EXPECT_EQ(n_on, n_rim) << "the middle of the cut is gone";
  expect_consistent(closed, wall);
}

TEST(OpenAtSides, GivesTwoCutsInOnePlaneOneNumber) {
  const SurfaceMesh two = joined(half_sphere(1), translated(half_sphere(2), {5, 0, 0}));
  const Closed closed(two, {{"cut", SideRole::Symmetry}}, FluidSide::Outside);
  const OpenWall wall = closed.open();
  EXPECT_EQ(wall.planes.planes.size(), 1u);
  EXPECT_EQ(wall.side_faces[0].size(), 8u + 16u);
  expect_consistent(closed, wall);
}

TEST(OpenAtSides, FollowsPointArraysToTheirPoints) {
  SurfaceMesh surface = half_sphere(1);
  surface.point_arrays.push_back({"height", {}});
  for (const Vec3& p : surface.points) surface.point_arrays[0].values.push_back(p.x() + 10 * p.z());
  const OpenWall wall = Closed(surface, {{"cut", SideRole::Symmetry}}, FluidSide::Outside).open();
  ASSERT_EQ(wall.surface.point_arrays.size(), 1u);
  for (const VertexId v : wall.surface.points.ids()) {
    const Vec3& p = wall.surface.points[v];
    EXPECT_EQ(wall.surface.point_arrays[0].values[v], p.x() + 10 * p.z());
  }
}

/// An L as the lumen: the side x = 1 over the step is an outlet, from which the tread turns away.
TEST(OpenAtSides, KeepsWhatTheWallTurnsAwayFrom) {
  SurfaceMesh surface = subdivided(l_step());
  paint(surface, "outlet", [](const Vec3& p) { return std::abs(p.x() - 1) < 1e-9 && p.y() > 1; });
  paint(surface, "tread", [](const Vec3& p) { return std::abs(p.y() - 1) < 1e-9 && p.x() > 1; });
  const Closed closed(surface, {{"outlet", SideRole::Opening}}, FluidSide::Inside, {"wall"});
  const OpenWall wall = closed.open();
  EXPECT_TRUE(wall.planes.empty());
  EXPECT_EQ(wall.surface.faces.size(), surface.faces.size());
  ASSERT_EQ(wall.notes.size(), 1u);
  EXPECT_THAT(wall.notes[0], HasSubstr("\"outlet\""));
  // With layers on all walls most of its edges are concave, and layers land on it.
  const Closed all(surface, {{"outlet", SideRole::Opening}}, FluidSide::Inside);
  const OpenWall landed = all.open();
  EXPECT_EQ(landed.planes.planes.size(), 1u);
  ASSERT_EQ(landed.planes.is_held.size(), landed.surface.points.size());
  for (const VertexId v : landed.surface.points.ids()) {
    const Vec3& p = landed.surface.points[v];
    EXPECT_EQ(landed.planes.is_held[v] != 0, p.x() == 1 && p.y() == 1) << "where the tread turns away";
  }
}

TEST(OpenAtSides, RefusesABodyOnBothSidesOfItsPlane) {
  SurfaceMesh surface = subdivided(l_step());
  paint(surface, "cut", [](const Vec3& p) { return std::abs(p.x() - 1) < 1e-9 && p.y() > 1; });
  try {
    Closed(surface, {{"cut", SideRole::Symmetry}}, FluidSide::Outside).open();
    FAIL();
  } catch (const GeometryError& e) {
    EXPECT_THAT(e.what(), HasSubstr("both sides"));
  }
}

/// A block on the plane z = 0 with two notches that meet in a point of it: its foot touches itself there.
SurfaceMesh bridge() {
  const double a = 0.5, b = 0.5;
  SurfaceMesh surface =
      make_surface({{0, 0, 0},
                    {1, -a, 0},
                    {1, a, 0},
                    {1, 0, b},
                    {-1, a, 0},
                    {-1, -a, 0},
                    {-1, 0, b},
                    {1, 1, 0},
                    {-1, 1, 0},
                    {-1, -1, 0},
                    {1, -1, 0},
                    {1, 1, 1},
                    {-1, 1, 1},
                    {-1, -1, 1},
                    {1, -1, 1}},
                   // The feet, then the notches, then the sides x = 1, x = -1, y = 1, y = -1, the top.
                   {{0, 7, 2},   {0, 8, 7},   {0, 4, 8},   {0, 10, 9},   {0, 1, 10},  {0, 9, 5},   {0, 3, 1},
                    {0, 2, 3},   {0, 6, 4},   {0, 5, 6},   {10, 1, 3},   {10, 3, 14}, {14, 3, 11}, {3, 7, 11},
                    {3, 2, 7},   {8, 4, 6},   {8, 6, 12},  {12, 6, 13},  {6, 9, 13},  {6, 5, 9},   {7, 8, 12},
                    {7, 12, 11}, {9, 10, 14}, {9, 14, 13}, {11, 12, 13}, {11, 13, 14}});
  paint(surface, "foot", [](const Vec3& p) { return p.z() == 0; });
  return surface;
}

TEST(OpenAtSides, RefusesACutThatTouchesItself) {
  try {
    Closed(bridge(), {{"foot", SideRole::Symmetry}}, FluidSide::Outside).open();
    FAIL();
  } catch (const GeometryError& e) {
    EXPECT_THAT(e.what(), HasSubstr("touch each other"));
    EXPECT_THAT(e.what(), HasSubstr("(0, 0, 0)"));
  }
}

TEST(OpenAtSides, EndsLayersAtOpeningsThatTouchThemselves) {
  const Closed closed(bridge(), {{"foot", SideRole::Opening}}, FluidSide::Inside);
  const OpenWall wall = closed.open();
  EXPECT_TRUE(wall.planes.empty());
  EXPECT_EQ(wall.surface.faces.size(), closed.surface.faces.size());
  EXPECT_FALSE(wall.notes.empty());
  for (const std::string& note : wall.notes) EXPECT_THAT(note, HasSubstr("\"foot\""));
}

/// The ceiling's edge stays where it is, its middle is lifted by a little.
SurfaceMesh with_bulge(const std::string& patch) {
  SurfaceMesh surface = subdivided(subdivided(box({0, 0, 0}, {1, 1, 1})));
  paint(surface, patch, [](const Vec3& p) { return p.z() == 1; });
  return mapped(surface, [](const Vec3& p) {
    return p.z() == 1 ? Vec3(p.x(), p.y(), 1 + 0.01 * p.x() * (1 - p.x()) * p.y() * (1 - p.y())) : p;
  });
}

TEST(OpenAtSides, RefusesPlanesOfSymmetryThatAreUneven) {
  try {
    Closed(with_bulge("cut"), {{"cut", SideRole::Symmetry}}, FluidSide::Outside).open();
    FAIL();
  } catch (const GeometryError& e) {
    EXPECT_THAT(e.what(), HasSubstr("\"cut\" is not flat"));
  }
}

/// Half a ball as the domain: a flat floor under a dome, which is curved, and facetted where it is coarse.
TEST(OpenAtSides, LandsNoLayersOnDomes) {
  for (const int level : {2, 4}) {
    SurfaceMesh ball = mapped(sphere(level), [](const Vec3& p) { return p.z() < 0 ? Vec3(p.x(), p.y(), 0) : p; });
    paint(ball, "dome", [](const Vec3& p) { return p.z() > 0; });
    const OpenWall wall = Closed(ball, {{"dome", SideRole::Opening}}, FluidSide::Inside).open();
    EXPECT_TRUE(wall.planes.empty()) << level;
    EXPECT_EQ(wall.surface.faces.size(), ball.faces.size());
    ASSERT_FALSE(wall.notes.empty());
    EXPECT_THAT(wall.notes[0], HasSubstr("\"dome\""));
  }
}

TEST(OpenAtSides, EndsLayersAtOpeningsThatAreUneven) {
  const Closed closed(with_bulge("outlet"), {{"outlet", SideRole::Opening}}, FluidSide::Inside);
  const OpenWall wall = closed.open();
  EXPECT_TRUE(wall.planes.empty());
  ASSERT_EQ(wall.notes.size(), 1u);
  EXPECT_THAT(wall.notes[0], HasSubstr("\"outlet\" is not flat"));
}

}  // namespace
}  // namespace nearwall::surface

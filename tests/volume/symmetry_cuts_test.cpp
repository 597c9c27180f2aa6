#include "nearwall/volume/symmetry_cuts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/shapes/shapes.h"
#include "nearwall/surface/admission.h"
#include "tests/support/shapes.h"

namespace nearwall::volume {
namespace {

using namespace shapes_for_tests;
using mesh::SurfaceMesh;
using testing::HasSubstr;

/// Faces that are chosen by their middle, with the points that they have.
SurfaceMesh part(const SurfaceMesh& whole, const std::function<bool(const Vec3&)>& is_chosen) {
  SurfaceMesh result;
  result.patch_names = whole.patch_names;
  std::map<VertexId, VertexId> number;
  for (const FaceId f : whole.faces.ids()) {
    const auto [a, b, c] = whole.triangle(f);
    if (!is_chosen((a + b + c) / 3)) continue;
    auto face = whole.faces[f];
    for (VertexId& v : face) {
      const auto [found, is_new] = number.try_emplace(v);
      if (is_new) found->second = result.points.push_back(whole.points[v]);
      v = found->second;
    }
    result.faces.push_back(face);
    result.face_patch.push_back(whole.face_patch[f]);
  }
  return result;
}

SurfaceMesh without_patches(const SurfaceMesh& surface, const std::set<std::string>& names) {
  SurfaceMesh result = surface;
  result.faces.clear();
  result.face_patch.clear();
  for (const FaceId f : surface.faces.ids()) {
    if (names.contains(surface.patch_names[surface.face_patch[f]])) continue;
    result.faces.push_back(surface.faces[f]);
    result.face_patch.push_back(surface.face_patch[f]);
  }
  return result;
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

double volume_of(const SurfaceMesh& surface) {
  double six = 0;
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    six += dot(cross(a, b), c);
  }
  return six / 6;
}

bool is_admitted(const SurfaceMesh& surface) {
  return surface::inspect(surface, {surface::FluidSide::Outside, surface::Repair::None}).is_usable();
}

/// Each point moved along an axis by up to so much.
SurfaceMesh shaken(const SurfaceMesh& surface, int axis, double most) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> by(-most, most);
  return mapped(surface, [&](const Vec3& p) {
    Vec3 q = p;
    q[axis] += by(random);
    return q;
  });
}

TEST(CloseCuts, ClosesHalfASphereThatEndsNearItsPlane) {
  const int level = 3;
  const SurfaceMesh half = part(sphere(level), [](const Vec3& p) { return p.y() > 0; });
  const double noise = 1e-7;
  const CutClosing closing = close_cuts(shaken(half, 1, noise), {{1, 0.0, "symmetry"}});
  const std::size_t n_rim = 4u << level;
  EXPECT_EQ(closing.at, std::vector<double>{0});
  // Of a polygon of n corners, n − 2 triangles without new points.
  EXPECT_EQ(closing.caps, std::vector<std::size_t>{n_rim - 2});
  EXPECT_EQ(closing.surface.points.size(), half.points.size());
  EXPECT_EQ(closing.surface.faces.size(), half.faces.size() + n_rim - 2);
  EXPECT_GT(closing.farthest_move, 0);
  EXPECT_LE(closing.farthest_move, noise);
  EXPECT_TRUE(is_admitted(closing.surface));
  // The cap is the polygon on the circle, whose corners lie at angles that great arcs give: at most the circle.
  double polygon = 0;
  for (const FaceId f : half.faces.ids()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = half.points[half.faces[f][k]], &b = half.points[half.faces[f][(k + 1) % 3]];
      if (a.y() == 0 && b.y() == 0) polygon += 0.5 * norm(cross(a, b));
    }
  }
  EXPECT_NEAR(area_of(closing.surface, "symmetry"), polygon, 1e-12);
  for (std::size_t f = half.faces.size(); f < closing.surface.faces.size(); ++f) {
    const auto [a, b, c] = closing.surface.triangle(FaceId(f));
    EXPECT_LT(cross(b - a, c - a).y(), 0) << "out of the body";
    for (const Vec3& p : {a, b, c}) EXPECT_EQ(p.y(), 0);
  }
  for (const VertexId v : half.points.ids()) {
    if (half.points[v].y() == 0) continue;
    EXPECT_EQ(closing.surface.points[v].x(), half.points[v].x()) << "nothing else is moved";
    EXPECT_NE(closing.surface.points[v].y(), 0);
  }
}

TEST(CloseCuts, FindsThePlaneWhereTheOpenEdgesAre) {
  for (const double at : {-2.5, 0.0, 3.25}) {
    for (const double side : {1.0, -1.0}) {
      const SurfaceMesh half = translated(part(sphere(2), [&](const Vec3& p) { return side * p.z() > 0; }), {0, 0, at});
      const CutClosing closing = close_cuts(half, {{2, std::nullopt, "cut"}});
      EXPECT_EQ(closing.at[0], at);
      EXPECT_EQ(closing.caps[0], 14u);
      EXPECT_TRUE(is_admitted(closing.surface));
    }
  }
}

TEST(CloseCuts, ClosesAQuarterInTwoPlanes) {
  const SurfaceMesh whole = shapes::make_shape("quarter-cylinder", {}, 0.1);
  const SurfaceMesh open = without_patches(whole, {"symmetry-y", "symmetry-z"});
  const CutClosing closing = close_cuts(open, {{1, std::nullopt, "symmetry-y"}, {2, std::nullopt, "symmetry-z"}});
  EXPECT_EQ(closing.at, (std::vector<double>{0, 0}));
  EXPECT_TRUE(is_admitted(closing.surface));
  for (const char* patch : {"symmetry-y", "symmetry-z"}) {
    EXPECT_NEAR(area_of(closing.surface, patch), area_of(whole, patch), 1e-12);
  }
  EXPECT_NEAR(volume_of(closing.surface), volume_of(whole), 1e-12);
}

TEST(CloseCuts, ClosesAnEighthInThreePlanes) {
  const SurfaceMesh open = part(sphere(2), [](const Vec3& p) { return p.x() > 0 && p.y() > 0 && p.z() > 0; });
  // The corner at the middle is no point of the surface.
  const CutClosing closing = close_cuts(open, {{0, 0.0, "x"}, {1, 0.0, "y"}, {2, 0.0, "z"}});
  EXPECT_EQ(closing.surface.points.size(), open.points.size() + 1);
  EXPECT_EQ(closing.surface.points.raw().back(), Vec3(0, 0, 0));
  EXPECT_TRUE(is_admitted(closing.surface));
  // A fan of four triangles from the corner to the four edges of an arc, all alike.
  EXPECT_EQ(closing.caps, (std::vector<std::size_t>{4, 4, 4}));
  EXPECT_NEAR(area_of(closing.surface, "x"), area_of(closing.surface, "y"), 1e-15);
  EXPECT_NEAR(area_of(closing.surface, "x"), area_of(closing.surface, "z"), 1e-15);
  EXPECT_NEAR(volume_of(closing.surface), volume_of(sphere(2)) / 8, 1e-14);
}

/// A hollow ball has a ring for its cut, two bodies a disc each.
TEST(CloseCuts, FillsRingsAndSeveralCuts) {
  const auto is_in = [](const Vec3& p) { return p.y() > 0; };
  const SurfaceMesh hollow = joined(part(sphere(3), is_in), flipped(part(sphere(3, 0.5), is_in)));
  const CutClosing ring = close_cuts(hollow, {{1, 0.0, "symmetry"}});
  EXPECT_TRUE(is_admitted(ring.surface));
  // Both polygons are alike, so the ring is three quarters of the larger.
  const CutClosing disc = close_cuts(part(sphere(3), is_in), {{1, 0.0, "symmetry"}});
  EXPECT_NEAR(area_of(ring.surface, "symmetry"), 0.75 * area_of(disc.surface, "symmetry"), 1e-12);

  const SurfaceMesh two = joined(part(sphere(3), is_in), translated(part(sphere(2), is_in), {4, 0, 0}));
  const CutClosing both = close_cuts(two, {{1, 0.0, "symmetry"}});
  EXPECT_EQ(both.caps[0], 30u + 14u);
  EXPECT_TRUE(is_admitted(both.surface));
}

TEST(CloseCuts, PutsCapsIntoThePatchOfTheirName) {
  const SurfaceMesh half = part(sphere(1), [](const Vec3& p) { return p.y() > 0; });
  const CutClosing other = close_cuts(half, {{1, 0.0, "mirror"}});
  EXPECT_EQ(other.surface.patch_names.raw(), (std::vector<std::string>{"wall", "mirror"}));
  const CutClosing same = close_cuts(half, {{1, 0.0, "wall"}});
  EXPECT_EQ(same.surface.patch_names.raw(), std::vector<std::string>{"wall"});
  for (const FaceId f : half.faces.ids()) EXPECT_EQ(other.surface.faces[f], half.faces[f]) << "the wall is kept";
}

TEST(CloseCuts, LeavesOtherHolesOpen) {
  SurfaceMesh half = part(sphere(2), [](const Vec3& p) { return p.y() > 0; });
  // One triangle at the pole, which has no point on the plane.
  FaceId hole;
  for (const FaceId f : half.faces.ids()) {
    const auto triangle = half.triangle(f);
    if (std::all_of(triangle.begin(), triangle.end(), [](const Vec3& p) { return p.y() > 0.5; })) hole = f;
  }
  ASSERT_TRUE(hole.is_valid());
  half.faces.raw().erase(half.faces.begin() + hole.index());
  half.face_patch.raw().erase(half.face_patch.begin() + hole.index());
  const CutClosing closing = close_cuts(half, {{1, 0.0, "symmetry"}});
  EXPECT_EQ(closing.caps[0], 14u);
  const auto admission = surface::inspect(closing.surface, {surface::FluidSide::Outside, surface::Repair::None});
  EXPECT_EQ(admission.n_open_edges, 3u);
}

TEST(CloseCuts, ChangesNothingThatIsClosed) {
  const SurfaceMesh whole = cube();
  const CutClosing closing = close_cuts(whole, {{1, std::nullopt, "symmetry"}});
  EXPECT_EQ(closing.surface.points, whole.points);
  EXPECT_EQ(closing.surface.faces, whole.faces);
  EXPECT_EQ(closing.surface.patch_names, whole.patch_names);
  EXPECT_EQ(closing.at[0], 0);
  EXPECT_EQ(closing.caps[0], 0u);
  EXPECT_EQ(closing.farthest_move, 0);
}

TEST(CloseCuts, RefusesEdgesThatCross) {
  const auto is_in = [](const Vec3& p) { return p.y() > 0; };
  const SurfaceMesh crossing = joined(part(sphere(2), is_in), translated(part(sphere(2), is_in), {0.9, 0, 0.1}));
  try {
    close_cuts(crossing, {{1, 0.0, "symmetry"}});
    FAIL();
  } catch (const GeometryError& e) {
    EXPECT_THAT(e.what(), HasSubstr("y = 0"));
    EXPECT_THAT(e.what(), HasSubstr("meet each other"));
  }
}

TEST(CloseCuts, RefusesEdgesThatGoRoundNothing) {
  SurfaceMesh half = part(sphere(2), [](const Vec3& p) { return p.y() > 0; });
  // Without one triangle of the rim the edges on the plane do not close.
  for (const FaceId f : half.faces.ids()) {
    const auto [a, b, c] = half.triangle(f);
    if ((a.y() == 0) + (b.y() == 0) + (c.y() == 0) != 2) continue;
    half.faces.raw().erase(half.faces.begin() + f.index());
    half.face_patch.raw().erase(half.face_patch.begin() + f.index());
    break;
  }
  EXPECT_THROW(close_cuts(half, {{1, 0.0, "symmetry"}}), GeometryError);
}

TEST(CloseCuts, ScalesWithTheSurface) {
  const SurfaceMesh half = shaken(part(sphere(2), [](const Vec3& p) { return p.y() > 0; }), 1, 1e-7);
  const CutClosing one = close_cuts(half, {{1, std::nullopt, "symmetry"}});
  const CutClosing other = close_cuts(scaled(half, 0x1p60), {{1, std::nullopt, "symmetry"}});
  EXPECT_EQ(one.surface.faces, other.surface.faces);
  EXPECT_EQ(one.at[0] * 0x1p60, other.at[0]);
  for (const VertexId v : half.points.ids()) EXPECT_EQ(one.surface.points[v] * 0x1p60, other.surface.points[v]);
}

}  // namespace
}  // namespace nearwall::volume

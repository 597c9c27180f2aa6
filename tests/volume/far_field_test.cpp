#include "nearwall/volume/far_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/topology.h"

namespace nearwall::volume {
namespace {

using geometry::kPi;
using mesh::SurfaceMesh;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A centre whose coordinates are no round numbers: planes through it must be met bit for bit all the same.
const Vec3 kCentre(0.1, 1.0 / 3, -7.7);

FarField sphere(double size, std::vector<SymmetryPlane> planes = {}) {
  FarField f;
  f.centre = kCentre, f.radius = 10, f.size = size, f.planes = std::move(planes);
  return f;
}

FarField box(double size, std::vector<SymmetryPlane> planes = {}) {
  FarField f;
  f.shape = FarFieldShape::Box;
  f.box.low = kCentre - Vec3(3, 4, 5), f.box.high = kCentre + Vec3(5, 4, 3), f.size = size;
  f.planes = std::move(planes);
  return f;
}

/// Planes through kCentre.
const std::vector<std::vector<SymmetryPlane>> kPlanes = {
    {},
    {{0, kCentre.x(), 1}},
    {{1, kCentre.y(), -1}},
    {{2, kCentre.z(), 1}},
    {{1, kCentre.y(), 1}, {2, kCentre.z(), 1}},
    {{2, kCentre.z(), -1}, {0, kCentre.x(), 1}},
    {{0, kCentre.x(), -1}, {1, kCentre.y(), 1}, {2, kCentre.z(), -1}},
};

/// Both shapes with all planes.
std::vector<FarField> all_kinds(double size) {
  std::vector<FarField> result;
  for (const auto& planes : kPlanes) result.push_back(sphere(size, planes)), result.push_back(box(size, planes));
  return result;
}

/// Volume between the surface and `apex`, positive where normals point to it. Planes through the apex add nothing, so
/// for one on all symmetry planes this is the volume of the domain.
double volume_to(const SurfaceMesh& s, const Vec3& apex) {
  geometry::CompensatedSum sum;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    sum.add(-dot(a - apex, cross(b - apex, c - apex)) / 6);
  }
  return sum.value();
}

std::vector<double> angles_deg(const SurfaceMesh& s) {
  std::vector<double> angles;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    for (const double angle :
         {geometry::corner_angle(a, b, c), geometry::corner_angle(b, c, a), geometry::corner_angle(c, a, b)}) {
      angles.push_back(geometry::to_degrees(angle));
    }
  }
  return angles;
}

TEST(FarFieldSurface, IsClosedWithoutPlanesAndOpenOnThem) {
  for (const FarField& f : all_kinds(1.5)) {
    EXPECT_EQ(mesh::Topology(far_field_surface(f)).is_closed(), f.planes.empty());
  }
}

TEST(FarFieldSurface, HasItsBoundaryEdgesInThePlanesBitForBit) {
  for (const FarField& f : all_kinds(1.5)) {
    const SurfaceMesh s = far_field_surface(f);
    const mesh::Topology topology(s);
    std::vector<int> edges_on(f.planes.size(), 0);
    for (const FaceId face : s.faces.ids()) {
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = mesh::Topology::halfedge(face, k);
        if (topology.twin(h).is_valid()) continue;
        const Vec3 &a = s.points[topology.origin(h)], &b = s.points[topology.target(h)];
        int n_planes = 0;
        for (std::size_t p = 0; p < f.planes.size(); ++p) {
          const auto& [axis, position, side] = f.planes[p];
          if (a[axis] == position && b[axis] == position) ++n_planes, ++edges_on[p];
        }
        EXPECT_EQ(n_planes, 1);
      }
    }
    for (const int n : edges_on) EXPECT_GE(n, 4);
  }
}

/// A quarter meets the line between its planes at both its ends, once each.
TEST(FarFieldSurface, MeetsTheLineBetweenTwoPlanes) {
  for (const FarField& f : {sphere(1.5, kPlanes[4]), box(1.5, kPlanes[4])}) {
    std::set<double> x;
    for (const Vec3& p : far_field_surface(f).points) {
      if (p.y() == kCentre.y() && p.z() == kCentre.z()) x.insert(p.x());
    }
    const bool is_box = f.shape == FarFieldShape::Box;
    EXPECT_EQ(x, (std::set<double>{kCentre.x() - (is_box ? 3 : 10), kCentre.x() + (is_box ? 5 : 10)}));
  }
}

TEST(FarFieldSurface, StaysOnItsSideOfThePlanes) {
  for (const FarField& f : all_kinds(1.5)) {
    for (const Vec3& p : far_field_surface(f).points) {
      for (const auto& [axis, position, side] : f.planes) EXPECT_GE((p[axis] - position) * side, 0);
    }
  }
}

TEST(Sphere, LiesOnTheSphere) {
  for (const Vec3& p : far_field_surface(sphere(1)).points) EXPECT_NEAR(distance(p, kCentre), 10, 1e-14 * 10);
}

/// Chords of length h lie up to h² / (8 R) inside: the volume falls short by the square of the size. Its sign says that
/// normals point into the domain.
TEST(Sphere, EnclosesItsShareOfTheBall) {
  for (const auto& planes : kPlanes) {
    const double share = 4 * kPi / 3 * 1000 / std::exp2(static_cast<double>(planes.size()));
    const double coarse = 1 - volume_to(far_field_surface(sphere(1, planes)), kCentre) / share;
    const double fine = 1 - volume_to(far_field_surface(sphere(0.5, planes)), kCentre) / share;
    EXPECT_GT(coarse, 0);
    EXPECT_LT(coarse, 0.01);
    EXPECT_NEAR(fine / coarse, 0.25, 0.02);
  }
}

TEST(Sphere, HasTrianglesOfTheSizeAsked) {
  // 4 pi R² over the area of an equilateral triangle.
  for (const double size : {1.0, 0.3}) {
    const double expected = 4 * kPi * 100 / (std::sqrt(3.0) / 4 * size * size);
    const double n = static_cast<double>(far_field_surface(sphere(size)).faces.size());
    EXPECT_GT(n, expected);
    EXPECT_LT(n, 1.15 * expected);
  }
}

TEST(Sphere, HasNearlyUniformTriangles) {
  const SurfaceMesh s = far_field_surface(sphere(0.5));
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    for (const double edge : {distance(a, b), distance(b, c), distance(c, a)}) {
      smallest = std::min(smallest, edge), largest = std::max(largest, edge);
    }
  }
  EXPECT_GT(smallest, 0.6 * 0.5);
  EXPECT_LT(largest, 1.5 * 0.5);
  const std::vector<double> angles = angles_deg(s);
  EXPECT_GT(*std::min_element(angles.begin(), angles.end()), 40);
  EXPECT_LT(*std::max_element(angles.begin(), angles.end()), 91);
}

TEST(Sphere, KeepsTwelveEdgesOnAGreatCircle) {
  EXPECT_EQ(far_field_surface(sphere(1000)).faces.size(), 8u * 9);
  EXPECT_EQ(far_field_surface(sphere(1000, {{1, kCentre.y(), 1}})).faces.size(), 4u * 9);
}

TEST(Box, EnclosesWhatThePlanesLeave) {
  for (const auto& planes : kPlanes) {
    Vec3 low(3, 4, 5), high(5, 4, 3);
    for (const auto& [axis, position, side] : planes) (side > 0 ? low : high)[axis] = 0;
    const Vec3 extent = low + high;
    const double expected = extent.x() * extent.y() * extent.z();
    EXPECT_NEAR(volume_to(far_field_surface(box(1.5, planes)), kCentre), expected, 1e-13 * expected);
  }
}

TEST(Box, NamesTheSidesThatAreLeft) {
  const auto names = [](const SurfaceMesh& s) {
    return std::set<std::string>(s.patch_names.begin(), s.patch_names.end());
  };
  EXPECT_EQ(names(far_field_surface(box(1))),
            (std::set<std::string>{"farfield-x-min", "farfield-x-max", "farfield-y-min", "farfield-y-max",
                                   "farfield-z-min", "farfield-z-max"}));
  EXPECT_EQ(names(far_field_surface(box(1, {{1, kCentre.y(), 1}, {2, kCentre.z(), -1}}))),
            (std::set<std::string>{"farfield-x-min", "farfield-x-max", "farfield-y-max", "farfield-z-min"}));
}

TEST(Box, HasEachSideInItsPlane) {
  const FarField f = box(1.3, {{1, kCentre.y(), 1}});
  const SurfaceMesh s = far_field_surface(f);
  for (const FaceId face : s.faces.ids()) {
    const std::string& name = s.patch_names[s.face_patch[face]];
    const int axis = name[9] - 'x';
    const double plane = name.ends_with("max") ? f.box.high[axis] : f.box.low[axis];
    for (const VertexId v : s.faces[face]) EXPECT_EQ(s.points[v][axis], plane);
  }
}

TEST(Box, MayEndAtThePlane) {
  FarField f = box(1);
  f.planes = {{2, f.box.low.z(), 1}};
  const SurfaceMesh s = far_field_surface(f);
  EXPECT_EQ(s.patch_names.size(), 5u);
  EXPECT_FALSE(mesh::Topology(s).is_closed());
}

TEST(Box, HasLegsNoLongerThanAskedAndGoodAngles) {
  for (const double size : {0.21, 1.3, 100.0}) {
    const SurfaceMesh s = far_field_surface(box(size, {{1, kCentre.y(), 1}}));
    for (const FaceId f : s.faces.ids()) {
      const auto [a, b, c] = s.triangle(f);
      EXPECT_LE(std::max({distance(a, b), distance(b, c), distance(c, a)}), size * std::sqrt(2.0) * (1 + 1e-8));
    }
    const std::vector<double> angles = angles_deg(s);
    EXPECT_GT(*std::min_element(angles.begin(), angles.end()), 33);
    EXPECT_LT(*std::max_element(angles.begin(), angles.end()), 90 + 1e-9);
  }
}

TEST(FarFieldSurface, GrowsAsTheSquareOfTheFineness) {
  for (const FarField& f : all_kinds(1)) {
    FarField fine = f;
    fine.size = 0.25;
    const double ratio = static_cast<double>(far_field_surface(fine).faces.size()) /
                         static_cast<double>(far_field_surface(f).faces.size());
    EXPECT_NEAR(ratio, 16, 1.6);
  }
}

TEST(FarFieldSurface, ScalesExactlyByPowersOfTwo) {
  constexpr double kScale = 1.0 / 1024;
  for (const FarField& f : all_kinds(1.5)) {
    FarField small = f;
    small.centre *= kScale, small.radius *= kScale, small.size *= kScale;
    small.box.low *= kScale, small.box.high *= kScale;
    for (SymmetryPlane& plane : small.planes) plane.position *= kScale;
    SurfaceMesh expected = far_field_surface(f);
    for (Vec3& p : expected.points) p *= kScale;
    const SurfaceMesh s = far_field_surface(small);
    EXPECT_EQ(s.points, expected.points);
    EXPECT_EQ(s.faces, expected.faces);
  }
}

TEST(FarFieldSurface, RefusesWhatMakesNoDomain) {
  const auto refuses = [](const FarField& f, const char* why) {
    EXPECT_THAT([&f] { far_field_surface(f); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  FarField f = sphere(1);
  f.radius = 0;
  refuses(f, "the radius must be a positive length, not 0");
  f.radius = std::numeric_limits<double>::infinity();
  refuses(f, "radius");
  refuses(sphere(0), "the size must be a positive length, not 0");
  refuses(sphere(std::nan("")), "size");
  refuses(sphere(1e-6), "give a larger size");
  refuses(sphere(1, {{1, 0.25, 1}}), "must lie on the symmetry plane y = 0.25");
  refuses(sphere(1, {{3, 0, 1}}), "axis 3");
  refuses(sphere(1, {{0, kCentre.x(), 0}}), "side");
  refuses(sphere(1, {{0, kCentre.x(), 1}, {0, kCentre.x(), -1}}), "no room between two symmetry planes");
  refuses(sphere(1, {{0, kCentre.x(), 1}, {0, kCentre.x(), 1}}), "have the domain on the same side");
  refuses(box(1, {{0, 100, 1}}), "does not cut the box");
  refuses(box(1, {{0, -100, 1}}), "does not cut the box");
  refuses(box(1, {{0, std::nan(""), 1}}), "not finite");
  f = box(1);
  std::swap(f.box.low, f.box.high);
  refuses(f, "low corner below its high one");
  f = box(1);
  f.box = {};
  refuses(f, "low corner below its high one");
}

}  // namespace
}  // namespace nearwall::volume

#include "nearwall/surface/side_regions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/moved.h"
#include "tests/support/shapes.h"

namespace nearwall::surface {
namespace {

using mesh::SurfaceMesh;
using namespace shapes_for_tests;

using Roles = std::map<std::string, SideRole>;

IdVector<PatchId, SideRole> roles_of(const SurfaceMesh& surface, const Roles& roles) {
  IdVector<PatchId, SideRole> all;
  for (const std::string& name : surface.patch_names) {
    const auto found = roles.find(name);
    all.push_back(found == roles.end() ? SideRole::None : found->second);
  }
  return all;
}

std::vector<SideRegion> regions_of(const SurfaceMesh& surface, const Roles& roles) {
  return find_side_regions(surface, roles_of(surface, roles));
}

/// Gives the faces whose middle is chosen to another patch.
void paint(SurfaceMesh& surface, const std::string& patch, const std::function<bool(const Vec3&)>& is_chosen) {
  const PatchId number = surface.patch_names.push_back(patch);
  for (const FaceId f : surface.faces.ids()) {
    const auto [a, b, c] = surface.triangle(f);
    if (is_chosen((a + b + c) / 3)) surface.face_patch[f] = number;
  }
}

/// A box of 12 · 4² triangles; all of it is one patch, "wall".
SurfaceMesh fine_box(const Vec3& low, const Vec3& high) { return subdivided(subdivided(box(low, high))); }

/// Coordinates as a file of single precision has them, some of them a rounding off.
SurfaceMesh in_single_precision(const SurfaceMesh& surface, unsigned seed) {
  std::mt19937 random(seed);
  return mapped(surface, [&](const Vec3& p) {
    Vec3 q;
    for (int axis = 0; axis < 3; ++axis) {
      float x = static_cast<float>(p[axis]);
      const auto way = random() % 3;
      if (way > 0) x = std::nextafter(x, way == 1 ? -1e30f : 1e30f);
      q[axis] = static_cast<double>(x);
    }
    return q;
  });
}

TEST(FindSideRegions, DivideABoxIntoItsSixSides) {
  const SurfaceMesh surface = fine_box({0.1, -2, 30}, {1.7, 5, 31});
  const auto regions = regions_of(surface, {{"wall", SideRole::Opening}});
  ASSERT_EQ(regions.size(), 6u);
  std::size_t n = 0;
  for (const SideRegion& r : regions) {
    n += r.faces.size();
    EXPECT_EQ(r.faces.size(), surface.faces.size() / 6);
    EXPECT_TRUE(std::is_sorted(r.faces.begin(), r.faces.end()));
    EXPECT_TRUE(r.is_flat);
    EXPECT_EQ(r.off_plane, 0);
    ASSERT_GE(r.plane.axis, 0);
    for (const FaceId f : r.faces) {
      const auto [a, b, c] = surface.triangle(f);
      EXPECT_GT(dot(cross(b - a, c - a), r.plane.normal), 0) << "the normal is that of the faces";
      for (const Vec3& p : {a, b, c}) EXPECT_EQ(r.plane.height(p), 0);
    }
  }
  EXPECT_EQ(n, surface.faces.size());
}

TEST(FindSideRegions, TakeThePatchOfThreeSidesApart) {
  SurfaceMesh surface = fine_box({0, 0, 0}, {1, 1, 1});
  paint(surface, "sides", [](const Vec3& p) { return p.x() == 1 || p.y() == 1 || p.z() == 1; });
  const auto regions = regions_of(surface, {{"sides", SideRole::Symmetry}});
  ASSERT_EQ(regions.size(), 3u);
  std::array<int, 3> n_of_axis{};
  for (const SideRegion& r : regions) {
    EXPECT_EQ(r.role, SideRole::Symmetry);
    ASSERT_TRUE(r.is_flat && r.plane.axis >= 0);
    ++n_of_axis[static_cast<std::size_t>(r.plane.axis)];
    EXPECT_EQ(r.plane.offset, 1);
  }
  EXPECT_EQ(n_of_axis, (std::array<int, 3>{1, 1, 1}));
  EXPECT_TRUE(regions_of(surface, {}).empty()) << "nothing without a role";
}

TEST(FindSideRegions, UniteCoplanarPatchesOfOneRole) {
  SurfaceMesh surface = plate(4);
  paint(surface, "left", [](const Vec3& p) { return p.x() < 0.5; });
  EXPECT_EQ(regions_of(surface, {{"wall", SideRole::Opening}, {"left", SideRole::Opening}}).size(), 1u);
  EXPECT_EQ(regions_of(surface, {{"wall", SideRole::Opening}, {"left", SideRole::Symmetry}}).size(), 2u);
  const auto one = regions_of(surface, {{"left", SideRole::Symmetry}});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].faces.size(), surface.faces.size() / 2);
}

TEST(FindSideRegions, TakePartsApartThatDoNotTouchButGiveThemOnePlane) {
  const SurfaceMesh two = joined(fine_box({0, 0, 0}, {1, 1, 1}), fine_box({3, 0, 0}, {4, 2, 1}));
  for (unsigned seed = 0; seed < 4; ++seed) {
    SurfaceMesh surface = in_single_precision(translated(two, {0.1, 0.2, 0.3}), seed);
    paint(surface, "floor", [](const Vec3& p) { return p.z() < 0.30001; });
    const auto regions = regions_of(surface, {{"floor", SideRole::Symmetry}});
    ASSERT_EQ(regions.size(), 2u);
    EXPECT_EQ(regions[0].plane.offset, regions[1].plane.offset) << "bit for bit";
    EXPECT_TRUE(regions[0].is_flat && regions[1].is_flat);
  }
}

TEST(FindSideRegions, SeeThroughSinglePrecision) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const SurfaceMesh exact = fine_box({0.1, -2.2, 30.3}, {1.7, 5.1, 31.1});
    SurfaceMesh surface = in_single_precision(exact, seed);
    const auto regions = regions_of(surface, {{"wall", SideRole::Opening}});
    ASSERT_EQ(regions.size(), 6u);
    for (const SideRegion& r : regions) {
      EXPECT_TRUE(r.is_flat);
      ASSERT_GE(r.plane.axis, 0);
      EXPECT_GT(r.off_plane, 0);
      const double at = r.plane.offset * r.plane.normal[r.plane.axis];
      const auto p = exact.points[exact.faces[r.faces[0]][0]];
      EXPECT_NEAR(at, p[r.plane.axis], 2e-7 * std::abs(p[r.plane.axis]));
    }
    const SurfaceMesh noisy = surface;
    const double move = flatten(regions, surface);
    double expected = 0;
    for (const SideRegion& r : regions) {
      for (const FaceId f : r.faces) {
        for (const Vec3& p : surface.triangle(f)) EXPECT_EQ(r.plane.height(p), 0) << "exactly";
      }
    }
    for (const VertexId v : surface.points.ids()) {
      expected = std::max(expected, distance(surface.points[v], noisy.points[v]));
    }
    EXPECT_EQ(move, expected);
    EXPECT_LT(move, 1e-5);
  }
}

TEST(FindSideRegions, KnowObliquePlanes) {
  for (const gallery::Move& move : gallery::moves(3)) {
    const SurfaceMesh straight = fine_box({0, 0, 0}, {1, 2, 3});
    SurfaceMesh surface = move(straight);
    const auto regions = regions_of(surface, {{"wall", SideRole::Opening}});
    ASSERT_EQ(regions.size(), 6u) << move.name;
    const gallery::Rotation rotate(move.seed);
    for (const SideRegion& r : regions) {
      EXPECT_TRUE(r.is_flat);
      EXPECT_EQ(r.plane.axis, -1);
      EXPECT_NEAR(norm(r.plane.normal), 1, 1e-15);
      // Its sides look where the straight one's do, turned.
      const auto [a, b, c] = straight.triangle(r.faces[0]);
      EXPECT_LE(distance(r.plane.normal, rotate(normalized(cross(b - a, c - a)))), 1e-11) << move.name;
    }
    flatten(regions, surface);
    for (const SideRegion& r : regions) {
      for (const FaceId f : r.faces) {
        for (const Vec3& p : surface.triangle(f)) {
          EXPECT_LE(std::abs(r.plane.height(p)), 4e-16 * (norm(p) + 4 * move.scale)) << move.name;
        }
      }
    }
  }
}

TEST(FindSideRegions, ScaleWithTheSurface) {
  const auto noisy = in_single_precision(fine_box({0.1, -2.2, 3.3}, {1.7, 5.1, 4.1}), 1);
  const auto one = regions_of(noisy, {{"wall", SideRole::Opening}});
  const auto other = regions_of(scaled(noisy, 0x1p-40), {{"wall", SideRole::Opening}});
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].faces, other[i].faces);
    EXPECT_EQ(one[i].plane.offset * 0x1p-40, other[i].plane.offset);
    EXPECT_EQ(one[i].off_plane * 0x1p-40, other[i].off_plane);
    EXPECT_EQ(one[i].is_flat, other[i].is_flat);
  }
}

/// A height h over a square of edge 1 and diagonal √2: flat up to a hundred thousandth of the diagonal.
TEST(FindSideRegions, AreFlatUpToAHundredThousandthOfTheirExtent) {
  const auto bowl = [](double h) {
    return height_field(16, [h](double x, double y) { return 16 * h * x * (1 - x) * y * (1 - y); });
  };
  const auto is_flat = [&](double h) {
    const auto regions = regions_of(bowl(h), {{"wall", SideRole::Opening}});
    EXPECT_EQ(regions.size(), 1u);
    return regions.front().is_flat;
  };
  EXPECT_TRUE(is_flat(1e-6));
  EXPECT_TRUE(is_flat(1e-5));
  // A bowl that is deeper than twice the tolerance fits no plane.
  EXPECT_FALSE(is_flat(4e-5));
  EXPECT_FALSE(is_flat(1e-2));
  const auto regions = regions_of(bowl(1e-2), {{"wall", SideRole::Opening}});
  EXPECT_LE(regions[0].off_plane, 1e-2);
  EXPECT_GE(regions[0].off_plane, 0.5e-2) << "half of its depth at least";
}

TEST(Flatten, LeavesEverythingElseWhereItIs) {
  SurfaceMesh surface = in_single_precision(translated(fine_box({0, 0, 0}, {1, 1, 1}), {0.1, 0.2, 0.3}), 3);
  paint(surface, "floor", [](const Vec3& p) { return p.z() < 0.30001; });
  paint(surface, "bowl", [](const Vec3& p) { return p.z() > 1.29999; });
  for (Vec3& p : surface.points) {
    if (p.z() > 1.29999 && std::abs(p.x() - 0.6) < 0.4 && std::abs(p.y() - 0.7) < 0.4) p[2] += 0.003;
  }
  const SurfaceMesh old = surface;
  const auto regions = regions_of(surface, {{"floor", SideRole::Symmetry}, {"bowl", SideRole::Opening}});
  EXPECT_TRUE(std::any_of(regions.begin(), regions.end(), [](const auto& r) { return !r.is_flat; }));
  EXPECT_GT(flatten(regions, surface), 0);
  int n_floor = 0;
  for (const VertexId v : surface.points.ids()) {
    if (old.points[v].z() < 0.30001) {
      ++n_floor;
      EXPECT_EQ(surface.points[v].x(), old.points[v].x());
      EXPECT_EQ(surface.points[v].y(), old.points[v].y());
    } else {
      EXPECT_EQ(surface.points[v], old.points[v]) << "uneven parts, too";
    }
  }
  EXPECT_EQ(n_floor, 25);
}

TEST(Flatten, DoesNothingTwice) {
  SurfaceMesh surface = in_single_precision(fine_box({0.1, -2.2, 30.3}, {1.7, 5.1, 31.1}), 5);
  const Roles roles = {{"wall", SideRole::Opening}};
  EXPECT_GT(flatten(regions_of(surface, roles), surface), 0);
  EXPECT_EQ(flatten(regions_of(surface, roles), surface), 0);
}

/// A box with a slanting roof: the roof's points on the side x = 1 have to keep their x.
TEST(Flatten, KeepsAxisPlanesExactWhereTheyMeetObliqueOnes) {
  SurfaceMesh surface = mapped(fine_box({0, 0, 0}, {1, 1, 1}), [](const Vec3& p) {
    return Vec3(p.x(), p.y(), p.z() * (1 + 0.3 * p.x() + 0.1 * p.y()));
  });
  surface = in_single_precision(translated(surface, {0.1, 0.2, 0.3}), 9);
  const auto regions = regions_of(surface, {{"wall", SideRole::Opening}});
  ASSERT_EQ(regions.size(), 6u);
  flatten(regions, surface);
  int n_oblique = 0;
  for (const SideRegion& r : regions) {
    EXPECT_TRUE(r.is_flat);
    n_oblique += r.plane.axis < 0;
    for (const FaceId f : r.faces) {
      for (const Vec3& p : surface.triangle(f)) {
        EXPECT_LE(std::abs(r.plane.height(p)), r.plane.axis < 0 ? 1e-15 : 0.0);
      }
    }
  }
  EXPECT_EQ(n_oblique, 1);
}

}  // namespace
}  // namespace nearwall::surface

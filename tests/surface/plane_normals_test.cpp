#include "nearwall/surface/plane_normals.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/geometry/angles.h"
#include "nearwall/mesh/topology.h"
#include "tests/support/shapes.h"

namespace nearwall::surface {
namespace {

using mesh::SidePlane;

SidePlane axis_plane(int axis, double sign = 1) {
  SidePlane plane;
  plane.normal[axis] = sign;
  plane.axis = axis;
  return plane;
}

constexpr int kDirections = 3600;

/// Largest least cosine with the normals over directions all round the plane.
double best_of_many(const std::vector<Vec3>& normals, const SidePlane& plane) {
  int shortest = 0;
  for (int a = 1; a < 3; ++a) {
    if (std::abs(plane.normal[a]) < std::abs(plane.normal[shortest])) shortest = a;
  }
  Vec3 axis;
  axis[shortest] = 1;
  const Vec3 u = normalized(cross(axis, plane.normal)), v = cross(plane.normal, u);
  double best = -1;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * geometry::kPi * i / kDirections;
    const Vec3 d = u * std::cos(angle) + v * std::sin(angle);
    double least = 1;
    for (const Vec3& n : normals) least = std::min(least, dot(d, n));
    best = std::max(best, least);
  }
  return best;
}

/// Normals within an angle round a direction that leans out of the plane by up to as much.
std::vector<Vec3> random_normals(std::mt19937& random, double angle) {
  std::normal_distribution<double> normal;
  const auto unit = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return normalized(Vec3(x, y, z));
  };
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Vec3> normals;
  const Vec3 middle = unit();
  const int n = 1 + static_cast<int>(random() % 8);
  for (int i = 0; i < n; ++i) {
    const Vec3 side = normalized(cross(middle, unit()));
    const double turn = angle * share(random);
    normals.push_back(normalized(middle * std::cos(turn) + side * std::sin(turn)));
  }
  return normals;
}

std::vector<SidePlane> some_planes() {
  std::vector<SidePlane> planes = {axis_plane(0), axis_plane(1, -1), axis_plane(2)};
  for (const Vec3& n : {Vec3(1, 2, 3), Vec3(-3, 0.5, 1), Vec3(0.1, -2, 0.4)}) planes.push_back({normalized(n), 0, -1});
  return planes;
}

TEST(MostVisibleInPlane, IsAsGoodAsTheBestOfManyDirections) {
  std::mt19937 random(3);
  // A direction between two of those tried is half a step off at most, and cosines change by no more than angles.
  const double resolution = geometry::kPi / kDirections;
  int n_seen = 0, n_unseen = 0;
  for (const SidePlane& plane : some_planes()) {
    for (int i = 0; i < 60; ++i) {
      const auto normals = random_normals(random, geometry::to_radians(i % 3 == 0 ? 30 : 80));
      const double best = best_of_many(normals, plane);
      const auto found = most_visible_in_plane(normals, plane);
      if (std::abs(best) < 2 * resolution) continue;  // too close to tell by trying
      ASSERT_EQ(found.has_value(), best > 0) << best;
      ++(found ? n_seen : n_unseen);
      if (!found) continue;
      double least = 1;
      for (const Vec3& n : normals) least = std::min(least, dot(*found, n));
      EXPECT_GE(least, best - 1e-12);
      EXPECT_LE(least, best + resolution);
      EXPECT_NEAR(norm(*found), 1, 1e-15);
      EXPECT_LE(std::abs(dot(*found, plane.normal)), 1e-15);
      if (plane.axis >= 0) {
        EXPECT_EQ((*found)[plane.axis], 0);
      }
    }
  }
  EXPECT_GT(n_seen, 50);
  EXPECT_GT(n_unseen, 20);
}

TEST(MostVisibleInPlane, TurnsWithTheAxes) {
  std::mt19937 random(4);
  const auto turned = [](const Vec3& p) { return Vec3(p.z(), p.x(), p.y()); };
  for (int i = 0; i < 100; ++i) {
    const int axis = i % 3;
    const auto normals = random_normals(random, geometry::to_radians(50));
    std::vector<Vec3> other;
    for (const Vec3& n : normals) other.push_back(turned(n));
    const auto a = most_visible_in_plane(normals, axis_plane(axis));
    const auto b = most_visible_in_plane(other, axis_plane((axis + 1) % 3));
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_EQ(turned(*a), *b) << "bit for bit";
    }
  }
}

TEST(MostVisibleInPlane, HasNothingToSayOfPlanesThatFacesLieIn) {
  EXPECT_FALSE(most_visible_in_plane({}, axis_plane(2)));
  const std::vector<Vec3> along = {{0, 0, 1}};
  EXPECT_FALSE(most_visible_in_plane(along, axis_plane(2))) << "no direction in the plane sees a face parallel to it";
  const std::vector<Vec3> opposite = {{1, 0, 0}, {-1, 0, 0}};
  EXPECT_FALSE(most_visible_in_plane(opposite, axis_plane(2)));
  const std::vector<Vec3> leaning = {normalized(Vec3(1e-9, 0, 1))};
  EXPECT_EQ(most_visible_in_plane(leaning, axis_plane(2)), Vec3(1, 0, 0));
}

/// Those faces of a mesh that lie where none of some coordinates is negative, with the planes that cut them off.
struct Part {
  mesh::SurfaceMesh surface;
  std::vector<VertexId> whole;  // of each vertex
  mesh::SidePlanes planes;

  Part(const mesh::SurfaceMesh& all, const std::vector<int>& axes) {
    for (const int axis : axes) planes.planes.push_back(axis_plane(axis));
    surface.patch_names = all.patch_names;
    IdVector<VertexId, VertexId> number(all.points.size());
    for (const FaceId f : all.faces.ids()) {
      const auto triangle = all.triangle(f);
      const bool is_in = std::all_of(axes.begin(), axes.end(), [&](int axis) {
        return std::all_of(triangle.begin(), triangle.end(), [&](const Vec3& p) { return p[axis] >= 0; });
      });
      if (!is_in) continue;
      auto corners = all.faces[f];
      for (VertexId& v : corners) {
        if (!number[v].is_valid()) add_point(all, v, number);
        v = number[v];
      }
      surface.faces.push_back(corners);
      surface.face_patch.push_back(PatchId(0));
    }
  }

 private:
  void add_point(const mesh::SurfaceMesh& all, VertexId v, IdVector<VertexId, VertexId>& number) {
    number[v] = surface.points.push_back(all.points[v]);
    whole.push_back(v);
    std::array<mesh::PlaneIndex, 3> of{mesh::kNoPlane, mesh::kNoPlane, mesh::kNoPlane};
    std::size_t n = 0;
    for (mesh::PlaneIndex p = 0; p < planes.planes.size(); ++p) {
      if (all.points[v][planes.planes[p].axis] == 0) of[n++] = p;
    }
    planes.of_vertex.push_back(of);
  }
};

IdVector<VertexId, PointNormal> most_visible(const mesh::SurfaceMesh& surface, const mesh::Topology& topology,
                                             const Features& features) {
  return point_normals(surface, topology, features);
}

/// The best direction of a mirrored body lies in the plane of the mirror, since it is the only best one: so the part
/// has to find what the whole has, where the whole looks for the best (point_normals.h).
TEST(HoldInPlanes, GivesThePartTheDirectionsOfTheWhole) {
  const auto whole = shapes_for_tests::mapped(shapes_for_tests::sphere(1),
                                              [](const Vec3& p) { return Vec3(p.x(), 0.4 * p.y(), 1.7 * p.z()); });
  const mesh::Topology whole_topology(whole);
  const auto expected = most_visible(whole, whole_topology, find_features(whole, whole_topology));
  int n_held = 0, n_best = 0;
  for (const std::vector<int>& axes : {std::vector<int>{1}, {0}, {0, 2}}) {
    const Part part(whole, axes);
    const mesh::Topology topology(part.surface);
    const Features features = find_features(part.surface, topology);
    const auto free = most_visible(part.surface, topology, features);
    auto held = free;
    hold_in_planes(part.surface, topology, features, part.planes, held);
    for (const VertexId v : part.surface.points.ids()) {
      if (!part.planes.is_on_plane(v)) {
        EXPECT_EQ(held[v].direction, free[v].direction);
        continue;
      }
      ++n_held;
      const PointNormal& of_whole = expected[part.whole[v.index()]];
      EXPECT_TRUE(held[v].is_visible);
      EXPECT_LE(held[v].max_angle, of_whole.max_angle + 1e-9);
      for (const mesh::PlaneIndex p : part.planes.of(v)) {
        EXPECT_EQ(held[v].direction[part.planes.planes[p].axis], 0);
      }
      if (std::cos(of_whole.max_angle) >= kVisibilityTrigger) continue;
      ++n_best;
      EXPECT_LE(distance(held[v].direction, of_whole.direction), 1e-7);
    }
  }
  EXPECT_GT(n_held, 15);
  EXPECT_GT(n_best, 10);
}

TEST(HoldInPlanes, RunsAlongTheEdgeBetweenTwoPlanes) {
  const Part part(shapes_for_tests::sphere(2), {0, 2});
  const mesh::Topology topology(part.surface);
  const Features features = find_features(part.surface, topology);
  auto normals = most_visible(part.surface, topology, features);
  hold_in_planes(part.surface, topology, features, part.planes, normals);
  int n = 0;
  for (const VertexId v : part.surface.points.ids()) {
    if (part.planes.of(v).size() != 2) continue;
    ++n;
    EXPECT_EQ(normals[v].direction, part.surface.points[v]) << "a pole of the unit sphere";
  }
  EXPECT_EQ(n, 2);
}

TEST(HoldInPlanes, SeesNothingWhereThreePlanesMeet) {
  const Part part(shapes_for_tests::plate(2), {0, 1});
  Part corner = part;
  corner.planes.planes.push_back(axis_plane(2));
  corner.planes.of_vertex[VertexId(0)] = {0, 1, 2};
  ASSERT_EQ(part.surface.points[VertexId(0)], Vec3(0, 0, 0));
  const mesh::Topology topology(part.surface);
  const Features features = find_features(part.surface, topology);
  auto normals = most_visible(part.surface, topology, features);
  hold_in_planes(part.surface, topology, features, part.planes, normals);
  EXPECT_EQ(normals[VertexId(0)].direction, Vec3(0, 0, 1)) << "the edge between both planes is normal to the plate";
  hold_in_planes(part.surface, topology, features, corner.planes, normals);
  EXPECT_FALSE(normals[VertexId(0)].is_visible);
}

}  // namespace
}  // namespace nearwall::surface

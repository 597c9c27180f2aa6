#include "nearwall/mesh/side_planes.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace nearwall::mesh {
namespace {

SidePlane axis_plane(int axis, double at, double sign = 1) {
  SidePlane plane;
  plane.normal[axis] = sign;
  plane.offset = sign * at;
  plane.axis = axis;
  return plane;
}

/// Six planes along axes, then many oblique ones: each component is the longest of some, with either sign.
std::vector<SidePlane> planes_of_all_kinds() {
  std::vector<SidePlane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) planes.push_back(axis_plane(axis, 0.3, sign));
  }
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 50; ++i) {
    const Vec3 n = normalized(Vec3(normal(random), normal(random), normal(random)));
    planes.push_back({n, normal(random), -1});
  }
  return planes;
}

class Points {
 public:
  Vec3 next() {
    const double x = normal_(random_), y = normal_(random_), z = normal_(random_);
    return {x, y, z};
  }

 private:
  std::mt19937 random_{11};
  std::normal_distribution<double> normal_;
};

TEST(SidePlane, TakesItsNormalOutOfVectors) {
  Points points;
  for (const SidePlane& plane : planes_of_all_kinds()) {
    const Vec3 d = points.next();
    const Vec3 part = plane.within(d);
    EXPECT_LE(std::abs(dot(part, plane.normal)), 1e-15 * norm(d));
    EXPECT_LE(norm(cross(d - part, plane.normal)), 1e-15 * norm(d)) << "only along the normal";
    if (plane.axis >= 0) {
      EXPECT_EQ(part[plane.axis], 0);
      EXPECT_EQ(part[(plane.axis + 1) % 3], d[(plane.axis + 1) % 3]);
      EXPECT_EQ(part[(plane.axis + 2) % 3], d[(plane.axis + 2) % 3]);
    }
  }
}

TEST(SidePlane, LiftsItsPointsBackToThemselves) {
  Points points;
  for (const SidePlane& plane : planes_of_all_kinds()) {
    for (int i = 0; i < 10; ++i) {
      Vec3 p = points.next();
      p -= plane.normal * plane.height(p);
      if (plane.axis >= 0) p[plane.axis] = plane.offset * plane.normal[plane.axis];
      const auto [u, v] = plane.flat(p);
      const Vec3 again = plane.lifted(u, v);
      // The height is divided by the longest component of the normal, at least 1 / √3.
      EXPECT_LE(distance(again, p), 1e-14 * (norm(p) + std::abs(plane.offset)));
      if (plane.axis >= 0) {
        EXPECT_EQ(again, p);
      }
      EXPECT_EQ(plane.flat(again), plane.flat(p));
    }
  }
}

TEST(SidePlane, SeesTurnsAsTheDomainDoes) {
  Points points;
  for (const SidePlane& plane : planes_of_all_kinds()) {
    for (int i = 0; i < 10; ++i) {
      const auto on_plane = [&] {
        const Vec3 p = points.next();
        return p - plane.normal * plane.height(p);
      };
      const Vec3 a = on_plane(), b = on_plane(), c = on_plane();
      const double turn = dot(cross(b - a, c - a), plane.normal);
      const auto [au, av] = plane.flat(a);
      const auto [bu, bv] = plane.flat(b);
      const auto [cu, cv] = plane.flat(c);
      const double flat_turn = (bu - au) * (cv - av) - (bv - av) * (cu - au);
      EXPECT_GT(turn * flat_turn, 0);
      // The projection along a component shrinks areas by just that.
      EXPECT_NEAR(flat_turn / turn, max_norm(plane.normal), 1e-9);
    }
  }
}

SidePlanes one_vertex_on(const std::vector<SidePlane>& planes) {
  SidePlanes all;
  all.planes = planes;
  std::array<PlaneIndex, 3> of{kNoPlane, kNoPlane, kNoPlane};
  for (PlaneIndex p = 0; p < planes.size(); ++p) of[p] = p;
  all.of_vertex.push_back(of);
  all.of_vertex.push_back({kNoPlane, kNoPlane, kNoPlane});
  return all;
}

TEST(SidePlanes, HoldAVertexInAllItsPlanes) {
  const SidePlane x = axis_plane(0, 0.1), y = axis_plane(1, -2, -1), z = axis_plane(2, 5);
  const SidePlane oblique{normalized(Vec3(1, 2, 3)), 0.4, -1}, other{normalized(Vec3(-2, 0.5, 1)), 1, -1};
  const Vec3 d(0.3, -0.7, 0.9);
  EXPECT_EQ(one_vertex_on({x}).within(VertexId(0), d), Vec3(0, -0.7, 0.9));
  EXPECT_EQ(one_vertex_on({x, z}).within(VertexId(0), d), Vec3(0, -0.7, 0));
  EXPECT_EQ(one_vertex_on({x, y, z}).within(VertexId(0), d), Vec3());
  EXPECT_EQ(one_vertex_on({x, y, z}).direction_within(VertexId(0), d), Vec3());
  EXPECT_EQ(one_vertex_on({x, oblique}).within(VertexId(0), d)[0], 0) << "the plane along an axis is kept exactly";
  for (const auto& pair : {std::vector{x, oblique}, std::vector{oblique, other}, std::vector{other, y}}) {
    const SidePlanes planes = one_vertex_on(pair);
    const Vec3 part = planes.within(VertexId(0), d);
    const Vec3 along = normalized(cross(pair[0].normal, pair[1].normal));
    EXPECT_LE(distance(part, along * dot(along, d)), 1e-15) << "the projection on the edge between the two";
    EXPECT_NEAR(norm(planes.direction_within(VertexId(0), d)), 1, 1e-15);
  }
}

TEST(SidePlanes, LeaveOtherVerticesAlone) {
  const SidePlanes planes = one_vertex_on({axis_plane(0, 0), axis_plane(1, 0)});
  const Vec3 d(0.3, -0.7, 0.9);
  EXPECT_EQ(planes.within(VertexId(1), d), d);
  EXPECT_FALSE(planes.is_on_plane(VertexId(1)));
  EXPECT_TRUE(planes.of(VertexId(1)).empty());
  EXPECT_TRUE(planes.is_on(VertexId(0), 0) && planes.is_on(VertexId(0), 1));
  EXPECT_FALSE(planes.is_on(VertexId(0), 2));
  EXPECT_EQ(SidePlanes().within(VertexId(0), d), d) << "no plane, no entry for a vertex";
  EXPECT_FALSE(SidePlanes().is_on_plane(VertexId(0)));
}

}  // namespace
}  // namespace nearwall::mesh

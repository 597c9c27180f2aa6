#include "nearwall/predicates/intersection.h"

#include <array>
#include <ostream>

#include <gtest/gtest.h>

#include "nearwall/predicates/orientation.h"
#include "tests/predicates/points.h"
#include "tests/predicates/reference.h"

namespace nearwall::predicates {

void PrintTo(RayCrossing c, std::ostream* out) {
  constexpr std::array kNames{"None", "Along", "Against", "Degenerate"};
  *out << kNames[static_cast<std::size_t>(c)];
}

namespace {

using points_for_tests::Kind;
using points_for_tests::Points;

constexpr int kRounds = 2000;

class IntersectionOverAllKinds : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(, IntersectionOverAllKinds, testing::ValuesIn(points_for_tests::kAllKinds),
                         [](const auto& kind) { return points_for_tests::name_of(kind.param); });

/// A point of the kind, now and then one that lies on the triangle, an edge or a corner of it up to rounding.
Vec3 point_near(Points& points, const Triangle& t) {
  const int choice = points.integer(0, 9);
  if (choice < 3) return t[choice];
  if (choice < 5) return 0.5 * t[0] + 0.5 * t[choice - 2];
  if (choice < 6) return 0.5 * t[0] + (0.25 * t[1] + 0.25 * t[2]);
  return points.next();
}

Triangle triangle_near(Points& points, const Triangle& t) {
  return {point_near(points, t), point_near(points, t), points.next()};
}

bool reference_meet(const Triangle& a, const Triangle& b) {
  const auto p = reference::as_integers(std::array{a[0], a[1], a[2], b[0], b[1], b[2]});
  return reference::hulls_meet(std::span(p).first(3), std::span(p).last(3));
}

TEST(TrianglesIntersect, CountsTouching) {
  const Triangle t{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  EXPECT_TRUE(triangles_intersect(t, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(2, 2, 1)}));     // through the face
  EXPECT_TRUE(triangles_intersect(t, {Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(2, 2, 1)}));      // corner on the face
  EXPECT_TRUE(triangles_intersect(t, {Vec3(2, 2, -1), Vec3(2, 2, 1), Vec3(5, 5, 0)}));     // edge on edge
  EXPECT_TRUE(triangles_intersect(t, {Vec3(4, 0, 0), Vec3(5, 0, 0), Vec3(5, 1, 0)}));      // corner on corner, coplanar
  EXPECT_TRUE(triangles_intersect(t, {Vec3(1, 1, 0), Vec3(1.5, 1, 0), Vec3(1, 1.5, 0)}));  // one within the other
  EXPECT_FALSE(triangles_intersect(t, {Vec3(3, 3, 0), Vec3(5, 3, 0), Vec3(3, 5, 0)}));     // apart, coplanar
  EXPECT_FALSE(triangles_intersect(t, {Vec3(1, 1, 1), Vec3(2, 1, 1), Vec3(1, 2, 1)}));     // parallel
}

TEST_P(IntersectionOverAllKinds, TrianglesAgreeWithSeparatingAxes) {
  Points points(GetParam(), 21);
  int n_meet = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Triangle a = points.next_array<3>(), b = triangle_near(points, a);
    const bool expected = reference_meet(a, b);
    ASSERT_EQ(triangles_intersect(a, b), expected) << "round " << i;
    ASSERT_EQ(triangles_intersect(b, a), expected) << "round " << i;
    ASSERT_EQ(triangles_intersect({a[1], a[2], a[0]}, {b[1], b[0], b[2]}), expected) << "round " << i;
    n_meet += expected ? 1 : 0;
  }
  EXPECT_GT(n_meet, kRounds / 20);
  EXPECT_LT(n_meet, kRounds * 19 / 20);
}

TEST_P(IntersectionOverAllKinds, SegmentsAgreeWithSeparatingAxes) {
  Points points(GetParam(), 22);
  int n_meet = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Triangle t = points.next_array<3>();
    const Vec3 p = point_near(points, t), q = points.next();
    const auto s = reference::as_integers(std::array{t[0], t[1], t[2], p, q});
    const bool expected = reference::hulls_meet(std::span(s).first(3), std::span(s).last(2));
    ASSERT_EQ(segment_intersects_triangle(p, q, t), expected) << "round " << i;
    n_meet += expected ? 1 : 0;
  }
  EXPECT_GT(n_meet, kRounds / 50);
  EXPECT_LT(n_meet, kRounds * 49 / 50);
}

/// Whether two triangles with area and the common corner v = 0 meet elsewhere: the far edge of one meets the cone of
/// the other, cut off far beyond what the small integers of the test can reach.
bool cones_meet(const Triangle& a, const Triangle& b) {
  const mpz_class far = 1000000;
  auto p = reference::as_integers(std::array{a[0], a[1], a[2], b[0], b[1], b[2]});
  const std::array far_edge{p[1], p[2]};
  const std::array cone{p[3], p[3] + far * (p[4] - p[3]), p[3] + far * (p[5] - p[3])};
  return reference::hulls_meet(far_edge, cone);
}

TEST(TrianglesIntersectBeyondVertex, AgreesWithConesOnSmallIntegers) {
  Points points(Kind::SmallIntegers, 23);
  int n_meet = 0, n_looked_at = 0;
  for (int i = 0; i < 8000; ++i) {
    const Triangle a = points.next_array<3>();
    const Triangle b{a[0], points.next(), points.next()};
    if (is_degenerate(a[0], a[1], a[2]) || is_degenerate(b[0], b[1], b[2])) continue;
    const bool expected = cones_meet(a, b);
    ASSERT_EQ(triangles_intersect_beyond_vertex(a, b), expected) << "round " << i;
    ASSERT_EQ(triangles_intersect_beyond_vertex(b, a), expected) << "round " << i;
    ASSERT_EQ(triangles_intersect_beyond_vertex({a[0], a[2], a[1]}, b), expected) << "round " << i;
    n_meet += expected ? 1 : 0;
    ++n_looked_at;
  }
  EXPECT_GT(n_meet, n_looked_at / 20);
  EXPECT_LT(n_meet, n_looked_at * 19 / 20);
}

TEST(TrianglesIntersectBeyondVertex, TakesTrianglesWithoutAreaAsSegments) {
  const Triangle t{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  EXPECT_FALSE(triangles_intersect_beyond_vertex(t, {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, 2)}));
  EXPECT_FALSE(triangles_intersect_beyond_vertex(t, {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}));
  EXPECT_FALSE(triangles_intersect_beyond_vertex(t, {Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)}));
  EXPECT_TRUE(triangles_intersect_beyond_vertex(t, {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(-1, -1, 0)}));
  EXPECT_TRUE(triangles_intersect_beyond_vertex(t, {Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(18, 0, 0)}));
}

TEST(TrianglesOverlapBeyondEdge, OnlyWhereFoldedFlatUponEachOther) {
  const Triangle t{Vec3(0, 0, 0), Vec3(2, 0, 2), Vec3(0, 2, 1)};
  const auto over = [&](const Vec3& apex) { return triangles_overlap_beyond_edge(t, {t[0], t[1], apex}); };
  EXPECT_TRUE(over({1, 1, 1.5}));             // in the plane x + y/2 = z, on the same side
  EXPECT_TRUE(over({-9, 2, -8}));             // the same, far along the edge
  EXPECT_FALSE(over({0, -2, -1}));            // on the other side: flat
  EXPECT_FALSE(over({1, 1, 1.5 + 0x1p-52}));  // folded sharply, but not flat
  EXPECT_FALSE(over({1, 0, 1}));              // no area: the edge itself
  EXPECT_FALSE(over({4, 0, 4}));              // no area, beyond the edge's end
  EXPECT_TRUE(triangles_overlap_beyond_edge({t[0], t[1], Vec3(4, 0, 4)}, {t[0], t[1], Vec3(3, 0, 3)}));
  EXPECT_FALSE(triangles_overlap_beyond_edge({t[0], t[1], Vec3(4, 0, 4)}, {t[0], t[1], Vec3(-3, 0, -3)}));
}

TEST_P(IntersectionOverAllKinds, OverlapBeyondEdgeAgreesWithIntegers) {
  Points points(GetParam(), 24);
  int n_overlap = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Triangle a = points.next_array<3>();
    const Vec3 along = a[1] - a[0];
    const Vec3 apex =
        i % 2 == 0 ? points.next() : a[2] + 0.5 * along;  // parallel to the edge: coplanar but for rounding
    const Triangle b{a[0], a[1], apex};
    if (is_degenerate(a[0], a[1], a[2]) || is_degenerate(b[0], b[1], b[2])) continue;
    const auto p = reference::as_integers(std::array{a[0], a[1], a[2], b[2]});
    const auto normal_a = reference::cross(p[1] - p[0], p[2] - p[0]);
    const auto normal_b = reference::cross(p[1] - p[0], p[3] - p[0]);
    const bool expected = reference::dot(normal_a, p[3] - p[0]) == 0 && reference::dot(normal_a, normal_b) > 0;
    ASSERT_EQ(triangles_overlap_beyond_edge(a, b), expected) << "round " << i;
    n_overlap += expected ? 1 : 0;
  }
  if (GetParam() == Kind::SmallIntegers || GetParam() == Kind::FarAway) {
    EXPECT_GT(n_overlap, kRounds / 50);
  }
}

/// By the parameters of the point where the ray's line meets the plane (Cramer's rule).
RayCrossing reference_crossing(const Vec3& origin, const Vec3& through, const Triangle& t) {
  const auto p = reference::as_integers(std::array{origin, through, t[0], t[1], t[2]});
  const auto d = p[1] - p[0], e = p[3] - p[2], f = p[4] - p[2], s = p[0] - p[2];
  const auto normal = reference::cross(e, f);
  mpz_class rate = reference::dot(d, normal);
  mpz_class along = -reference::dot(s, normal);
  if (rate == 0) {
    // In the plane, or with a triangle that has no area on the line: all triples are coplanar with the line.
    const bool is_in_plane = reference::orientation(origin, through, t[0], t[1]) == 0 &&
                             reference::orientation(origin, through, t[1], t[2]) == 0 &&
                             reference::orientation(origin, through, t[2], t[0]) == 0;
    return is_in_plane ? RayCrossing::Degenerate : RayCrossing::None;
  }
  mpz_class v = reference::dot(d, reference::cross(s, f)), w = reference::dot(d, reference::cross(e, s));
  const bool is_along = rate > 0;
  if (!is_along) rate = -rate, along = -along, v = -v, w = -w;
  const mpz_class u = rate - v - w;
  if (along < 0 || u < 0 || v < 0 || w < 0) return RayCrossing::None;
  if (along == 0 || u == 0 || v == 0 || w == 0) return RayCrossing::Degenerate;
  return is_along ? RayCrossing::Along : RayCrossing::Against;
}

TEST(RayCrossing, TellsTheSide) {
  const Triangle t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const Vec3 below(0.2, 0.2, -1), above(0.2, 0.2, 1);
  EXPECT_EQ(ray_crossing(below, above, t), RayCrossing::Along);
  EXPECT_EQ(ray_crossing(above, below, t), RayCrossing::Against);
  EXPECT_EQ(ray_crossing(below, {0.2, 0.2, -0.9}, t), RayCrossing::Along);  // it goes on beyond its second point
  EXPECT_EQ(ray_crossing(above, {0.2, 0.2, 2}, t), RayCrossing::None);
  EXPECT_EQ(ray_crossing({0.5, 0.5, -1}, {0.5, 0.5, 1}, t), RayCrossing::Degenerate);  // an edge
  EXPECT_EQ(ray_crossing({1, 0, -1}, {1, 0, 1}, t), RayCrossing::Degenerate);          // a corner
  EXPECT_EQ(ray_crossing({0.2, 0.2, 0}, above, t), RayCrossing::Degenerate);           // from the triangle
  EXPECT_EQ(ray_crossing({-1, 0.2, 0}, {1, 0.2, 0}, t), RayCrossing::Degenerate);      // in the plane
  EXPECT_EQ(ray_crossing({1, 0, 1}, {1, 0, 2}, t), RayCrossing::None);                 // a corner behind it
}

TEST_P(IntersectionOverAllKinds, RayCrossingsAgreeWithIntegers) {
  Points points(GetParam(), 25);
  std::array<int, 4> seen{};
  for (int i = 0; i < 5 * kRounds; ++i) {
    const Triangle t = points.next_array<3>();
    Vec3 origin = points.next(), through = i % 2 == 0 ? points.next() : point_near(points, t);
    if (i % 8 == 0) origin = point_near(points, t);
    if (origin == through) continue;
    const RayCrossing expected = reference_crossing(origin, through, t);
    ASSERT_EQ(ray_crossing(origin, through, t), expected) << "round " << i;
    ++seen[static_cast<std::size_t>(expected)];
  }
  for (const int n : seen) EXPECT_GT(n, 10);
}

}  // namespace
}  // namespace nearwall::predicates

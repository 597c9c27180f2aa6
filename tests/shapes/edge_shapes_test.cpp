// What the ridges of shapes are like that exist for their ridges.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "nearwall/geometry/box.h"
#include "tests/shapes/special_places.h"
#include "tests/shapes/surface_measures.h"

namespace nearwall::shapes {
namespace {

using geometry::kPi;
using geometry::to_degrees;
using geometry::to_radians;
using surface::PointKind;
using testing::SizeIs;

constexpr double kExact = 1e-9;  // [deg]

TEST(Wedge, HasATrailingEdgeOfItsAngle) {
  for (const double angle : {2.0, 5.0, 10.0, 20.0, 60.0}) {
    const Place wedge("wedge", {{"angle", angle}}, 0.15);
    int n = 0;
    wedge.for_each_edge([&](const Vec3& middle, double turn) {
      if (middle.x() < 1) return;
      EXPECT_NEAR(turn, 180 - angle, kExact);
      ++n;
    });
    EXPECT_EQ(n, 7);
  }
}

TEST(Notch, HasAConcaveEdgeOfItsAngle) {
  for (const double opening : {10.0, 20.0, 60.0, 120.0}) {
    const Place notch("notch", {{"angle", opening}}, 0.2);
    const RidgesAt end = notch.ridges_at({0, 0.5, 0.5});
    EXPECT_THAT(end.convex, SizeIs(2));
    ASSERT_THAT(end.concave, SizeIs(1));
    EXPECT_NEAR(end.concave[0], 180 - opening, kExact);
    EXPECT_EQ(notch.n_blind(), 0u);
  }
}

TEST(KnifePlate, IsSharpAllRound) {
  const Place plate("knife-plate", {{"length", 2}}, 0.2);
  const auto is_on_rim = [](const Vec3& p) { return p.z() == 0 && (std::abs(p.x()) == 1 || std::abs(p.y()) == 0.5); };
  plate.for_each_edge([&](const Vec3& middle, double turn) {
    if (is_on_rim(middle)) {
      EXPECT_NEAR(turn, 170, kExact);
    } else {
      EXPECT_LT(turn, 40);
    }
  });
  EXPECT_EQ(plate.n_of_kind(PointKind::Corner), 4u);
  EXPECT_EQ(plate.n_blind(), 0u);
  // Two hipped roofs: a prism along the crest and a pyramid of four sides each.
  const double z = 0.5 * std::tan(to_radians(5));
  EXPECT_NEAR(volume(plate.surface), 2 * (1 * 1 * z / 2 + 1 * 1 * z / 3), 1e-13);
}

TEST(DeltaWing, HasTwoKnifeEdgesThatMeetUnderItsApexAngle) {
  for (const double apex_angle : {10.0, 35.0}) {
    const Place wing("delta-wing", {{"apex-angle", apex_angle}}, 0.1);
    const VertexId apex = wing.vertex_at({0, 0, 0});
    const RidgesAt ridges = wing.ridges_at(apex);
    ASSERT_THAT(ridges.convex, SizeIs(2));
    EXPECT_NEAR(ridges.convex[0], 170, kExact);
    EXPECT_NEAR(ridges.convex[1], 170, kExact);
    EXPECT_EQ(wing.features.kind[apex], PointKind::Corner);
    EXPECT_EQ(wing.n_of_kind(PointKind::Corner), 3u);
    const double half_width = std::tan(to_radians(apex_angle / 2));
    EXPECT_NEAR(geometry::bounding_box(wing.surface.points.raw()).high.y(), half_width, 1e-14);
  }
}

TEST(KinkedWing, HasATrailingEdgeThatBendsOutAndIn) {
  const Place straight("kinked-wing", {{"kink", 0}}, 0.2), kinked("kinked-wing", {}, 0.2);
  straight.for_each_edge([](const Vec3& middle, double turn) {
    if (middle.x() < 1) return;
    EXPECT_NEAR(turn, 170, kExact);
  });
  const double third = 2.0 / 3, x = 1 + third * std::tan(to_radians(30));
  for (const Vec3& bend : {Vec3(x, -1 + third, 0), Vec3(1, -1 + 2 * third, 0)}) {
    const VertexId v = kinked.vertex_at(bend);
    EXPECT_NEAR(distance(kinked.surface.points[v], bend), 0, 1e-14);
    const RidgesAt ridges = kinked.ridges_at(v);
    ASSERT_THAT(ridges.convex, SizeIs(2)) << "the trailing edge, and no other ridge";
    EXPECT_GT(*std::min_element(ridges.convex.begin(), ridges.convex.end()), 165);
    EXPECT_EQ(kinked.features.kind[v], PointKind::Corner);
  }
  EXPECT_EQ(kinked.n_of_kind(PointKind::Corner), 6u + 2u);
}

/// The turn of edges on the middle line, by the place along it [deg].
std::map<double, double> turns_along_x(const Place& place, double z) {
  std::map<double, double> turns;
  place.for_each_edge([&](const Vec3& middle, double turn) {
    if (middle.y() == 0 && middle.z() == z) turns[middle.x()] = turn;
  });
  return turns;
}

TEST(TwistedRoof, TurnsFromConvexToConcave) {
  const Place roof("twisted-roof", {}, 0.05);
  const auto turns = turns_along_x(roof, 1.2);
  ASSERT_THAT(turns, SizeIs(40));
  double before = 180;
  for (const auto& [x, turn] : turns) {
    EXPECT_NEAR(turn, -120 * x, 5) << x;
    EXPECT_LT(turn, before) << x;
    before = turn;
  }
  EXPECT_EQ(roof.n_blind(), 0u);
  // The ridge and the valley end where the turn falls below 40 degrees.
  EXPECT_EQ(roof.n_of_kind(PointKind::RidgeEnd), 2u);
}

TEST(KinkedRoof, ChangesSignAtOneVertex) {
  const Place roof("kinked-roof", {}, 0.1);
  for (const auto& [x, turn] : turns_along_x(roof, 1.2)) EXPECT_NEAR(turn, x < 0 ? 56 : -56, kExact);
  const VertexId middle = roof.vertex_at({0, 0, 1.2});
  const RidgesAt ridges = roof.ridges_at(middle);
  EXPECT_THAT(ridges.convex, SizeIs(1));
  EXPECT_THAT(ridges.concave, SizeIs(1));
  EXPECT_EQ(roof.features.kind[middle], PointKind::Corner);
  // A larger turn makes ridges of the steps beside it, too.
  const RidgesAt steep = Place("kinked-roof", {{"turn", 110}}, 0.1).ridges_at({0, 0, 1.2});
  EXPECT_EQ(steep.convex.size() + steep.concave.size(), 6u);
}

TEST(FinOnPlate, HasTrailingEdgesThatMeetTheFloor) {
  for (const double angle : {2.0, 10.0, 60.0}) {
    const Place upright("fin-on-plate", {{"angle", angle}, {"sweep", 0}}, 0.15);
    const Place leaning("fin-on-plate", {{"angle", angle}, {"sweep", 40}}, 0.15);
    const RidgesAt ridges = upright.ridges_at({0.5, 0, 0});
    ASSERT_THAT(ridges.convex, SizeIs(1));
    EXPECT_NEAR(ridges.convex[0], 180 - angle, kExact);
    ASSERT_THAT(ridges.concave, SizeIs(2));
    EXPECT_NEAR(ridges.concave[0], 90, kExact);
    for (const double x : {-0.5, 0.5}) {
      const VertexId foot = leaning.vertex_at({x, 0, 0});
      EXPECT_THAT(leaning.ridges_at(foot).convex, SizeIs(1));
      EXPECT_THAT(leaning.ridges_at(foot).concave, SizeIs(2));
      EXPECT_TRUE(leaning.best_view(foot).has_value());
    }
  }
}

TEST(FinOnSphere, HasTrailingEdgesThatMeetASmoothBody) {
  const Place fin("fin-on-sphere", {}, 0.1);
  const RidgesAt ridges = fin.ridges_at({0.4, 0, std::sqrt(1 - 0.16)});
  ASSERT_THAT(ridges.convex, SizeIs(1));
  EXPECT_NEAR(ridges.convex[0], 170, kExact);
  EXPECT_THAT(ridges.concave, SizeIs(2));
  for (const FaceId f : fin.surface.faces.ids()) {
    if (fin.surface.patch_names[fin.surface.face_patch[f]] != "sphere") continue;
    for (const Vec3& p : fin.surface.triangle(f)) ASSERT_NEAR(norm(p), 1, 1e-14);
  }
}

class FadingRidge : public testing::TestWithParam<bool> {};

TEST_P(FadingRidge, FallsFromSharpToSmooth) {
  const Place body("fading-ridge", {{"saddle", GetParam()}});
  std::map<double, double> turns;
  body.for_each_edge([&](const Vec3& middle, double turn) {
    if (middle.y() == 0 && middle.z() > 0 && middle.x() > 0) turns[middle.x()] = turn;
  });
  double before = 0;
  constexpr double kChords = 0.1;  // two edges that meet the same chord of the circles have about the same turn [deg]
  for (const auto& [x, turn] : turns) {
    EXPECT_GT(turn, before - kChords) << x;
    before = turn;
  }
  EXPECT_LT(turns.begin()->second, 25);
  EXPECT_GT(turns.rbegin()->second, 100);
  EXPECT_EQ(body.n_of_kind(PointKind::RidgeEnd), 1u);
  EXPECT_EQ(body.n_blind(), 0u);
}

/// Height of the ridge line where the ridge ends, less that on the straight line between its neighbours.
TEST_P(FadingRidge, EndsOnGroundThatBendsAsAsked) {
  const Place body("fading-ridge", {{"saddle", GetParam()}});
  std::map<double, double> line;
  VertexId end;
  for (const VertexId v : body.surface.points.ids()) {
    const Vec3& p = body.surface.points[v];
    if (p.y() == 0 && p.z() > 0 && p.x() > 0 && p.x() < 2) line[p.x()] = p.z();
    if (body.features.kind[v] == PointKind::RidgeEnd) end = v;
  }
  const auto at = line.find(body.surface.points[end].x());
  ASSERT_NE(at, line.end());
  const double bulge = at->second - 0.5 * (std::prev(at)->second + std::next(at)->second);
  EXPECT_EQ(bulge < 0, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Grounds, FadingRidge, testing::Bool(),
                         [](const auto& saddle) { return saddle.param ? "saddle" : "convex"; });

TEST(NacaWithFlatTips, CutsOffASharpTrailingEdge) {
  const Place wing("naca", {{"rounded-tip", 0}, {"span", 1.5}}, 0.1);
  const VertexId corner = wing.vertex_at({1, 0.75, 0});
  const RidgesAt ridges = wing.ridges_at(corner);
  EXPECT_THAT(ridges.convex, SizeIs(3));
  EXPECT_GT(*std::max_element(ridges.convex.begin(), ridges.convex.end()), 160);
  EXPECT_EQ(wing.features.kind[corner], PointKind::Corner);
}

TEST(WingBody, HasATrailingEdgeThatMeetsTheFuselage) {
  const Place plane("wing-body", {}, 0.1);
  std::size_t n = 0;
  for (const VertexId v : plane.surface.points.ids()) {
    const RidgesAt ridges = plane.ridges_at(v);
    const Vec3& p = plane.surface.points[v];
    if (std::abs(std::hypot(p.y(), p.z()) - 0.5) > 1e-12 || ridges.convex.empty()) continue;
    EXPECT_THAT(ridges.convex, SizeIs(1));
    EXPECT_THAT(ridges.concave, SizeIs(2));
    ++n;
  }
  EXPECT_EQ(n, 2u);
}

}  // namespace
}  // namespace nearwall::shapes

#include "nearwall/quality/limited_lines.h"

#include <gtest/gtest.h>

#include "tests/quality/hand_made_layers.h"

namespace nearwall::quality {
namespace {

using mesh::LimitReason;

LimitedLines limited(const PlateLayers& plate, bool has_layers = true) {
  const IdVector<PatchId, PatchRequest> requests(std::vector<PatchRequest>{{has_layers, 1, 7, 3}});
  return limited_lines(plate.wall, plate.front, plate.lines,
                       {plate.asked_thickness, plate.reached_thickness, plate.reason}, requests);
}

const ReasonLines& of(const LimitedLines& lines, LimitReason reason) {
  return lines.by_reason[static_cast<std::size_t>(reason)];
}

TEST(LimitedLines, AreNoneOnAFullPlate) {
  const LimitedLines lines = limited(PlateLayers{});
  EXPECT_EQ(lines.n_lines, 4u);
  EXPECT_EQ(lines.n_limited(), 0u);
  EXPECT_EQ(lines.n_at_wall(), 0u);
}

TEST(LimitedLines, AreCountedByReasonAndPatch) {
  PlateLayers plate;
  plate.limit(0, 2, LimitReason::Gap);
  plate.limit(1, 0, LimitReason::Visibility);
  plate.limit(3, 1, LimitReason::Gap);
  const LimitedLines lines = limited(plate);
  EXPECT_EQ(lines.n_limited(), 3u);
  EXPECT_EQ(lines.n_at_wall(), 1u);
  EXPECT_EQ(of(lines, LimitReason::Gap).n_lines, 2u);
  EXPECT_EQ(of(lines, LimitReason::Gap).n_at_wall, 0u);
  EXPECT_EQ(of(lines, LimitReason::Visibility).n_at_wall, 1u);
  EXPECT_EQ(lines.by_patch[PatchId(0)][static_cast<std::size_t>(LimitReason::Gap)], 2u);
}

TEST(LimitedLines, BeginWithTheOneThatReachesTheLeast) {
  PlateLayers plate;
  plate.limit(0, 2, LimitReason::Gap);
  plate.limit(2, 1, LimitReason::Gap);
  plate.limit(3, 1, LimitReason::Gap);
  const auto worst = of(limited(plate), LimitReason::Gap).worst;
  ASSERT_EQ(worst.size(), 3u);
  EXPECT_EQ(worst[0].vertex, VertexId(2)) << "equal ones by vertex";
  EXPECT_EQ(worst[1].vertex, VertexId(3));
  EXPECT_EQ(worst[2].vertex, VertexId(0));
  EXPECT_EQ(worst[0].place, Vec3(2, 2, 0));
  EXPECT_EQ(worst[0].levels, 1);
  EXPECT_EQ(worst[0].reached, 1);
  EXPECT_EQ(worst[0].asked, 7);
}

TEST(LimitedLines, AreJudgedByWhatIsAskedOfEach) {
  PlateLayers plate;
  plate.limit(0, 2, LimitReason::Gap);  // 3 of 7
  plate.limit(1, 2, LimitReason::Gap);  // 3 of 4
  plate.asked_thickness[LineId(1)] = 4;
  const auto worst = of(limited(plate), LimitReason::Gap).worst;
  EXPECT_EQ(worst.front().vertex, VertexId(0));
  EXPECT_EQ(worst.back().share(), 0.75);
}

TEST(LimitedLines, AreNoneWhereNothingIsAsked) {
  PlateLayers plate;
  plate.limit(0, 0, LimitReason::PatchEdge);
  EXPECT_EQ(limited(plate, false).n_lines, 0u);
  plate.asked_thickness = IdVector<LineId, double>(4, 0.0);
  EXPECT_EQ(limited(plate).n_limited(), 0u);
}

TEST(LimitedLines, KeepAFewPlacesOnly) {
  // A fan of triangles round vertex 0, the last one the shortest.
  PlateLayers plate;
  const std::size_t n = kPlacesForEachReason + 3;
  for (std::size_t i = 4; i < n; ++i) {
    plate.wall.points.push_back(Vec3(-1, static_cast<double>(i), 0));
    plate.wall.faces.push_back({VertexId(0), VertexId(i - 1), VertexId(i)});
    plate.wall.face_patch.push_back(PatchId(0));
    plate.asked_thickness.push_back(7);
    plate.reached_thickness.push_back(7);
    plate.reason.push_back(LimitReason::None);
  }
  plate.front = mesh::plain_front(plate.wall);
  plate.lines = plate.straight_up();
  for (std::size_t i = 0; i < n; ++i) {
    plate.limit(i, 2, LimitReason::Curvature);
    plate.reached_thickness[LineId(i)] = 6 - 0.5 * static_cast<double>(i);
  }
  const ReasonLines curvature = of(limited(plate), LimitReason::Curvature);
  EXPECT_EQ(curvature.n_lines, n);
  ASSERT_EQ(curvature.worst.size(), kPlacesForEachReason);
  EXPECT_EQ(curvature.worst.front().vertex, VertexId(n - 1));
  EXPECT_EQ(curvature.worst.back().vertex, VertexId(n - kPlacesForEachReason));
}

}  // namespace
}  // namespace nearwall::quality

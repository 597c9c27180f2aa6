#include "nearwall/quality/coverage.h"

#include <gtest/gtest.h>

#include "tests/quality/hand_made_layers.h"

namespace nearwall::quality {
namespace {

using mesh::LimitReason;

IdVector<PatchId, PatchRequest> requests() {
  return IdVector<PatchId, PatchRequest>(std::vector<PatchRequest>{{true, 1, 7, 3}});
}

PatchCoverage coverage_of(const PlateLayers& p,
                          const IdVector<FaceId, char>& is_wetted = IdVector<FaceId, char>(2, 1)) {
  const mesh::LayerMesh layers(p.front, p.lines);
  const auto faces = face_coverage(layers, p.wall, requests(), {p.asked_thickness, p.reached_thickness, p.reason});
  return patch_coverage(p.wall, faces, requests(), is_wetted)[PatchId(0)];
}

double limited_by(const PatchCoverage& c, LimitReason reason) {
  return c.limit_percent[static_cast<std::size_t>(reason)];
}

TEST(Coverage, OfAFullPlateIsAHundredPercent) {
  const PatchCoverage c = coverage_of(PlateLayers{});
  EXPECT_EQ(c.area, 4);
  EXPECT_EQ(c.full_percent, 100);
  EXPECT_EQ(c.all_layers_percent, 100);
  EXPECT_EQ(c.any_percent, 100);
  EXPECT_EQ(c.mean_layers, 3);
  EXPECT_EQ(c.first_height.median, 1);
  EXPECT_EQ(c.thickness.p01, 7);
  for (double percent : c.limit_percent) EXPECT_EQ(percent, 0);
}

TEST(Coverage, OfATriangleWithAShortLineCountsTheLayersItHas) {
  PlateLayers plate;
  plate.limit(1, 2, LimitReason::Gap);  // corner of the first triangle only
  const PatchCoverage c = coverage_of(plate);
  EXPECT_EQ(c.all_layers_percent, 50);
  EXPECT_EQ(c.full_percent, 50);
  EXPECT_EQ(c.any_percent, 100);
  EXPECT_EQ(c.mean_layers, 2.5);
  EXPECT_EQ(limited_by(c, LimitReason::Gap), 50);
  EXPECT_NEAR(c.thickness.min, (7 + 7 + 3) / 3.0, 1e-15);
}

TEST(Coverage, BesideAPatchOfFewerLayersIsNotAll) {
  PlateLayers plate;
  plate.limit(1, 2, LimitReason::None);  // as scheduled on the neighbour, which has two layers
  const PatchCoverage c = coverage_of(plate);
  EXPECT_EQ(c.all_layers_percent, 50);
  EXPECT_EQ(limited_by(c, LimitReason::PatchEdge), 50);
}

TEST(Coverage, OfABlockedCornerLowersTheFirstHeight) {
  PlateLayers plate;
  plate.limit(1, 0, LimitReason::Visibility);
  const PatchCoverage c = coverage_of(plate);
  EXPECT_NEAR(c.first_height.min, 2 / 3.0, 1e-15);
  EXPECT_EQ(c.any_percent, 100) << "pyramids stand there";
  EXPECT_EQ(c.mean_layers, 1.5);
}

TEST(Coverage, SharesOutFirstHeightsByTheirDistanceFromTheAskedOne) {
  PlateLayers plate;
  const auto stretched = [&](double factor) {  // the lines of the first triangle; the second one has two of them
    for (std::size_t i = 0; i < 3; ++i) plate.lines.pieces[i].direction = {0, 0, factor};
    return coverage_of(plate);
  };
  EXPECT_EQ(stretched(1).first_height_met_percent, 100);
  EXPECT_EQ(stretched(1.06).first_height_met_percent, 50) << "1.06 and 1.04 of the asked one";
  EXPECT_EQ(stretched(1.06).first_height_large_percent, 0);
  EXPECT_EQ(stretched(0.9).first_height_met_percent, 0);
  EXPECT_EQ(stretched(1.6).first_height_large_percent, 50) << "1.6 and 1.4 of the asked one";
}

TEST(Coverage, NeedsNinetyFivePercentOfTheThicknessToBeFull) {
  PlateLayers plate;
  const auto thin = [&](double factor) {
    for (std::size_t i = 0; i < 4; ++i) {
      plate.lines.pieces[i].direction = {0, 0, factor};
      plate.reached_thickness[LineId(i)] = 7 * factor;
      plate.reason[LineId(i)] = LimitReason::Curvature;
    }
    return coverage_of(plate);
  };
  EXPECT_EQ(thin(0.951).full_percent, 100);
  const PatchCoverage c = thin(0.949);
  EXPECT_EQ(c.full_percent, 0);
  EXPECT_EQ(c.all_layers_percent, 100);
  EXPECT_EQ(limited_by(c, LimitReason::Curvature), 100);
}

TEST(Coverage, NamesTheReasonOfTheMostLimitedLine) {
  PlateLayers plate;
  plate.limit(0, 2, LimitReason::Gap);
  plate.limit(2, 1, LimitReason::Neighbour);
  const PatchCoverage c = coverage_of(plate);
  EXPECT_EQ(limited_by(c, LimitReason::Neighbour), 100);
  EXPECT_EQ(limited_by(c, LimitReason::Gap), 0);
}

TEST(Coverage, GivesTheReasonVisibilityWhereLinesMerelyLean) {
  PlateLayers plate;
  for (std::size_t i = 0; i < 4; ++i) plate.lines.pieces[i].direction = {0.8, 0, 0.6};
  const PatchCoverage c = coverage_of(plate);
  EXPECT_EQ(c.full_percent, 0);
  EXPECT_EQ(limited_by(c, LimitReason::Visibility), 100);
  EXPECT_NEAR(c.first_height.median, 0.6, 1e-15);
}

TEST(Coverage, LeavesOutWhatTheFluidCannotReach) {
  const PatchCoverage c = coverage_of(PlateLayers{}, IdVector<FaceId, char>(std::vector<char>{1, 0}));
  EXPECT_EQ(c.area, 2);
  EXPECT_EQ(c.full_percent, 100);
}

TEST(Coverage, GivesNoReasonWhereNothingIsAsked) {
  PlateLayers plate;
  for (std::size_t i = 0; i < 4; ++i) {
    plate.limit(i, 0, LimitReason::None);
    plate.asked_thickness[LineId(i)] = 0;
  }
  const mesh::LayerMesh layers(plate.front, plate.lines);
  const LineOutcome outcome{plate.asked_thickness, plate.reached_thickness, plate.reason};
  for (const FaceCoverage& face : face_coverage(layers, plate.wall, requests(), outcome)) {
    EXPECT_EQ(face.reason, LimitReason::None);
    EXPECT_FALSE(face.has_any || face.has_all_layers || face.is_full);
  }
}

/// As growing leaves lines that were to have two layers of three, at (2, 0) and (0, 2) alone.
struct IsotropicPlate : PlateLayers {
  IdVector<LineId, Level> levels{4, Level{3}};
  IdVector<LineId, double> first_heights{4, 1.0};

  IsotropicPlate() {
    for (const std::size_t i : {1, 3}) {
      limit(i, 2, LimitReason::Isotropic);
      levels[LineId(i)] = 2;
      asked_thickness[LineId(i)] = reached_thickness[LineId(i)];
    }
  }
  IdVector<FaceId, FaceCoverage> faces(const PatchRequest& request) const {
    return face_coverage({front, lines}, wall, IdVector<PatchId, PatchRequest>(1, request),
                         {asked_thickness, reached_thickness, reason, &levels, &first_heights});
  }
  PatchCoverage coverage(const PatchRequest& request) const {
    return patch_coverage(wall, faces(request), IdVector<PatchId, PatchRequest>(1, request),
                          IdVector<FaceId, char>(2, 1))[PatchId(0)];
  }
};

TEST(Coverage, OfLinesThatEndWhereAskedIsFull) {
  IsotropicPlate plate;
  const PatchRequest request{true, 1, 7, 3, false, true};
  for (const FaceCoverage& face : plate.faces(request)) {
    EXPECT_TRUE(face.has_all_layers && face.is_full);
    EXPECT_EQ(face.layers, 2);
    EXPECT_EQ(face.reason, LimitReason::Isotropic);
    EXPECT_EQ(face.asked_thickness, (7 + 7 + 3) / 3.0);
  }
  const PatchCoverage c = plate.coverage(request);
  EXPECT_EQ(c.full_percent, 100);
  EXPECT_EQ(limited_by(c, LimitReason::Isotropic), 0) << "nothing is missing";
  EXPECT_EQ(c.asked.total_thickness, (7 + 7 + 3) / 3.0);
  EXPECT_EQ(c.asked.count, 3) << "the most";

  plate.limit(3, 1, LimitReason::Gap);
  EXPECT_EQ(plate.coverage(request).all_layers_percent, 50);
  EXPECT_EQ(limited_by(plate.coverage(request), LimitReason::Gap), 50);
}

TEST(Coverage, ComparesFirstHeightsWithTheLinesOwn) {
  PlateLayers plate;
  const IdVector<LineId, double> first_heights(std::vector<double>{1, 0.5, 1, 1});
  const PatchRequest request{true, 9, 9, 3, true, false};
  const IdVector<PatchId, PatchRequest> all(1, request);
  const auto faces =
      face_coverage({plate.front, plate.lines}, plate.wall, all,
                    {plate.asked_thickness, plate.reached_thickness, plate.reason, nullptr, &first_heights});
  EXPECT_EQ(faces[FaceId(0)].asked_first_height, 2.5 / 3);
  EXPECT_EQ(faces[FaceId(1)].asked_first_height, 1);
  const PatchCoverage c = patch_coverage(plate.wall, faces, all, IdVector<FaceId, char>(2, 1))[PatchId(0)];
  EXPECT_EQ(c.first_height_met_percent, 50);
  EXPECT_EQ(c.asked_first_height.min, 2.5 / 3);
  EXPECT_EQ(c.asked_first_height.max, 1);
  EXPECT_EQ(c.full_percent, 100);
}

TEST(Coverage, OfAPatchWithoutLayersIsItsArea) {
  const PlateLayers p;
  const IdVector<PatchId, PatchRequest> none(1, PatchRequest{false, 0, 0, 0});
  const auto faces =
      face_coverage({p.front, p.lines}, p.wall, none, {p.asked_thickness, p.reached_thickness, p.reason});
  const PatchCoverage c = patch_coverage(p.wall, faces, none, IdVector<FaceId, char>(2, 1))[PatchId(0)];
  EXPECT_EQ(c.area, 4);
  EXPECT_FALSE(c.has_layers);
  EXPECT_EQ(c.any_percent, 0);
}

}  // namespace
}  // namespace nearwall::quality

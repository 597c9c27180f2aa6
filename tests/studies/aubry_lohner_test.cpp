#include "nearwall/studies/aubry_lohner.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/core/errors.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/shapes/shapes.h"
#include "nearwall/surface/features.h"
#include "studies/scenes.h"
#include "studies/stopwatch.h"

namespace nearwall::studies {
namespace {

/// Of sweeps over a star with ridges and valleys.
class StarSweeps : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto star = shapes::make_shape("star", {{"points", 8}}, 0.1);
    results_ = new std::vector<SweepResult>(compare_sweeps(star, {.repetitions = 1}, silent_progress()));
  }
  static void TearDownTestSuite() { delete results_; }

  static const SweepResult& of(SweepKind kind) {
    const SweepResult& result = results_->at(static_cast<std::size_t>(kind));
    EXPECT_EQ(result.kind, kind);
    return result;
  }

  static inline std::vector<SweepResult>* results_ = nullptr;
};

TEST_F(StarSweeps, SearchWhereTheirKindSays) {
  EXPECT_EQ(of(SweepKind::Plain).direct_percent, 0);
  EXPECT_EQ(of(SweepKind::Direct).direct_percent, 100);
  EXPECT_GT(of(SweepKind::Triggered).direct_percent, 10);
  EXPECT_LT(of(SweepKind::Triggered).direct_percent, 90);
}

TEST_F(StarSweeps, IterateToTheResultOfTheDirectMethod) {
  const SweepResult& direct = of(SweepKind::Direct);
  for (const SweepKind kind : {SweepKind::IterativeHalf, SweepKind::IterativeChosen}) {
    SCOPED_TRACE(kSweepNames[static_cast<std::size_t>(kind)]);
    EXPECT_GT(of(kind).mean_iterations, 1);
    EXPECT_LE(of(kind).mean_iterations, 300);
    EXPECT_LT(of(kind).not_converged_percent, 20);
    // Five sweeps carry each search's tolerance of 1e-4 rad on.
    EXPECT_NEAR(of(kind).worst_angle_deg, direct.worst_angle_deg, 0.5);
    EXPECT_NEAR(of(kind).edge_angle_deg, direct.edge_angle_deg, 0.1);
  }
  EXPECT_TRUE(std::isnan(direct.mean_iterations));
}

TEST_F(StarSweeps, LeaveTheNormalsAloneIfTheyOnlyStream) {
  const SweepResult& start = of(SweepKind::Streaming);
  EXPECT_EQ(start.direct_percent, 0);
  EXPECT_EQ(start.n_blind, 0u);
  // The start is the best for each point by itself: no sweep can better the worst of all.
  for (const SweepResult& r : *results_) {
    SCOPED_TRACE(kSweepNames[static_cast<std::size_t>(r.kind)]);
    EXPECT_LE(start.edge_angle_deg, r.edge_angle_deg + 1e-9);
    EXPECT_LE(start.worst_angle_deg, r.worst_angle_deg + 1e-9);
    EXPECT_GT(r.seconds, 0);
  }
}

TEST(AubryLohnerStudy, RefusesToMeasureNothing) {
  EXPECT_THROW(study_aubry_lohner({.repetitions = 0}, silent_progress()), InputError);
  EXPECT_THROW(compare_sweeps(shapes::make_shape("box", {}, 1), {.repetitions = 0}, silent_progress()), InputError);
}

TEST(Scenes, AreClosedAndOfThePapersSizesWithManyRidges) {
  const auto check = [](const Scene& scene, double n_points) {
    const mesh::Topology topology(scene.mesh);
    EXPECT_TRUE(topology.is_closed()) << scene.name;
    EXPECT_NEAR(static_cast<double>(scene.mesh.points.size()), n_points, 1000) << scene.name;
    const auto features = surface::find_features(scene.mesh, topology);
    const auto n_smooth = std::count(features.kind.begin(), features.kind.end(), surface::PointKind::Smooth);
    EXPECT_LT(static_cast<double>(n_smooth), 0.95 * n_points) << scene.name;
    EXPECT_GT(features.n_concave, 500u) << scene.name;
    const std::set<std::string> names(scene.mesh.patch_names.begin(), scene.mesh.patch_names.end());
    EXPECT_EQ(names.size(), scene.mesh.patch_names.size()) << scene.name;
  };
  check(flyer_scene(), 121000);
  check(block_scene(), 109000);
}

TEST(Median, IsTheMiddleOne) { EXPECT_EQ(median({5, 1, 9, 2, 3}), 3); }

}  // namespace
}  // namespace nearwall::studies

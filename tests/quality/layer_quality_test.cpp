#include "nearwall/quality/layer_quality.h"

#include <numbers>

#include <gtest/gtest.h>

#include "nearwall/core/parallel.h"
#include "tests/quality/hand_made_layers.h"

namespace nearwall::quality {
namespace {

TEST(LayerQuality, OfStraightPrismsIsKnown) {
  const PlateLayers plate;
  const LayerQuality q = layer_quality({plate.front, plate.lines}, plate.wall);
  // Right-angled isosceles triangles: 45 degrees, over the 60 of the ideal prism.
  const double expected = (1 / std::numbers::sqrt2) * (2 / std::numbers::sqrt3);
  EXPECT_EQ(q.scaled_jacobian.count, 6u);
  EXPECT_NEAR(q.scaled_jacobian.min, expected, 1e-15);
  EXPECT_NEAR(q.scaled_jacobian.max, expected, 1e-15);
  EXPECT_EQ(q.growth.count, 8u);  // two ratios on each of four lines
  EXPECT_EQ(q.growth.min, 2);
  EXPECT_EQ(q.growth.max, 2);
  EXPECT_EQ(q.volume_ratio.count, 4u);
  EXPECT_NEAR(q.volume_ratio.median, 2, 1e-14);
  EXPECT_NEAR(q.aspect_ratio.max, 2 * std::numbers::sqrt2, 1e-14);
  EXPECT_NEAR(q.aspect_ratio.min, std::numbers::sqrt2, 1e-14);  // the middle layer: height 2, diagonal 2 sqrt 2
  EXPECT_EQ(q.orthogonality.max, 0);
}

TEST(LayerQuality, FindsTheWorstCellAndTheLeaningLine) {
  PlateLayers plate;
  plate.lines.pieces[3].direction = {1, -1, 1};  // over the second triangle only
  const LayerQuality q = layer_quality({plate.front, plate.lines}, plate.wall);
  EXPECT_EQ(q.worst_column, FrontFaceId(1));
  EXPECT_NEAR(q.orthogonality.max, std::atan(std::numbers::sqrt2) * 180 / std::numbers::pi, 1e-12);
  EXPECT_EQ(q.orthogonality.min, 0);
}

TEST(LayerQuality, CountsPyramidsAndTetrahedraRoundABlockedVertex) {
  PlateLayers plate;
  plate.limit(1, 0, mesh::LimitReason::Visibility);
  const LayerQuality q = layer_quality({plate.front, plate.lines}, plate.wall);
  EXPECT_EQ(q.scaled_jacobian.count, 6u);
  EXPECT_EQ(q.growth.count, 6u);
  EXPECT_GT(q.scaled_jacobian.min, 0);
}

TEST(LayerQuality, OfNothingIsEmpty) {
  PlateLayers plate;
  for (std::size_t i = 0; i < 4; ++i) plate.limit(i, 0, mesh::LimitReason::Gap);
  const LayerQuality q = layer_quality({plate.front, plate.lines}, plate.wall);
  EXPECT_EQ(q.scaled_jacobian.count, 0u);
  EXPECT_EQ(q.orthogonality.count, 0u);
}

TEST(LayerQuality, HasTheSameBitsOnOneThread) {
  PlateLayers plate;
  plate.lines.pieces[3].direction = {0.3, -0.1, 1.1};
  const mesh::LayerMesh layers(plate.front, plate.lines);
  const LayerQuality many = layer_quality(layers, plate.wall);
  const ThreadLimit one(1);
  const LayerQuality single = layer_quality(layers, plate.wall);
  EXPECT_EQ(many.scaled_jacobian.mean, single.scaled_jacobian.mean);
  EXPECT_EQ(many.growth.mean, single.growth.mean);
  EXPECT_EQ(many.volume_ratio.p99, single.volume_ratio.p99);
}

}  // namespace
}  // namespace nearwall::quality

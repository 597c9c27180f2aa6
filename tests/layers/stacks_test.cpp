#include "layers/stacks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/growing.h"

namespace nearwall::layers {
namespace {

constexpr int kCount = 10;
constexpr std::uint32_t kPatch = 0;

IdVector<PatchId, PatchSchedule> schedules(OnConflict on_conflict, std::optional<int> step = {}) {
  PatchSchedule schedule;
  schedule.heights = growing_for_tests::geometric(1.0, 1.2, kCount);
  schedule.on_conflict = on_conflict;
  schedule.max_level_step = step;
  return IdVector<PatchId, PatchSchedule>(1, schedule);
}

/// The patch's own stack.
constexpr StackRequest kAsked = {kPatch, 1.0, 1.0, kCount};

Stack fit(const Stacks& stacks, double limit) { return stacks.fit(kAsked, limit, kCount); }

/// Distance of a level of a stack from the wall.
double distance_of(const Stacks& stacks, const Stack& stack, Level level) {
  const mesh::HeightTable table = stacks.table();
  const mesh::Heights& h = stack.heights;
  const double upper = h.weight_1 == 0 ? 0 : h.weight_1 * table.row(h.row + 1)[level];
  return h.weight_0 * table.row(h.row)[level] + upper;
}

TEST(Stacks, GivesAllThatIsAskedWhereThereIsRoom) {
  for (const auto on_conflict : {OnConflict::Auto, OnConflict::Compress, OnConflict::Stair}) {
    const Stacks stacks(schedules(on_conflict));
    const Stack stack = fit(stacks, 2.0);
    EXPECT_EQ(stack.end, kCount);
    EXPECT_DOUBLE_EQ(stack.thickness, 1.0);
    EXPECT_EQ(fit(stacks, 0).end, 0);
  }
}

TEST(Stacks, IsNeverThickerThanAllowed) {
  for (const auto on_conflict : {OnConflict::Compress, OnConflict::Stair}) {
    const Stacks stacks(schedules(on_conflict));
    for (double limit = 1.1; limit > 1e-6; limit *= 0.97) {
      const Stack stack = fit(stacks, limit);
      EXPECT_LE(stack.thickness, limit);
      if (stack.end == 0) continue;
      EXPECT_NEAR(distance_of(stacks, stack, stack.end), stack.thickness, 1e-12 * limit);
    }
  }
}

TEST(Stacks, LeavesOutLayersOfStairsOnly) {
  const auto asked = growing_for_tests::geometric(1.0, 1.2, kCount);
  const Stacks stacks(schedules(OnConflict::Stair));
  double thickness = 0;
  for (Level levels = 1; levels <= kCount; ++levels) {
    thickness += asked[levels - std::size_t{1}];
    EXPECT_EQ(fit(stacks, thickness * (1 + 1e-12)).end, levels);
    EXPECT_EQ(fit(stacks, thickness * (1 - 1e-12)).end, levels - 1);
    EXPECT_NEAR(distance_of(stacks, fit(stacks, thickness * (1 + 1e-12)), 1), asked[0], 1e-15);
  }
}

TEST(Stacks, KeepsTheFirstHeightThenItsHundredthThenDropsLayers) {
  const double first = growing_for_tests::geometric(1.0, 1.2, kCount).front();
  const Stacks stacks(schedules(OnConflict::Compress));
  const auto first_height = [&](const Stack& stack) { return distance_of(stacks, stack, 1); };
  const Stack uniform = fit(stacks, kCount * first);
  EXPECT_EQ(uniform.end, kCount);
  EXPECT_NEAR(first_height(uniform), first, 1e-12);
  const Stack thinnest = fit(stacks, 0.01 * kCount * first * (1 + 1e-12));
  EXPECT_EQ(thinnest.end, kCount);
  EXPECT_NEAR(first_height(thinnest), 0.01 * first, 1e-12);
  const Stack half = fit(stacks, 0.01 * kCount * first / 2 * (1 + 1e-12));
  EXPECT_EQ(half.end, kCount / 2);
  EXPECT_NEAR(first_height(half), 0.01 * first, 1e-12);
  EXPECT_EQ(fit(stacks, 0.005 * first).end, 0) << "not even one layer";
}

TEST(Stacks, FitsWhatItFittedOnceMore) {
  for (const auto on_conflict : {OnConflict::Compress, OnConflict::Stair}) {
    const Stacks stacks(schedules(on_conflict));
    for (double limit = 1.1; limit > 1e-5; limit *= 0.993) {
      const Stack once = fit(stacks, limit), twice = fit(stacks, once.thickness);
      EXPECT_EQ(once.end, twice.end);
      EXPECT_NEAR(once.thickness, twice.thickness, 1e-12 * limit);
    }
  }
}

TEST(Stacks, CutsOffAtALevelWithoutAnotherHeight) {
  for (const auto on_conflict : {OnConflict::Compress, OnConflict::Stair}) {
    const Stacks stacks(schedules(on_conflict));
    const Stack whole = fit(stacks, 0.7), cut = stacks.fit(kAsked, 0.7, 3);
    EXPECT_EQ(cut.end, 3);
    for (Level j = 1; j <= 3; ++j) EXPECT_EQ(distance_of(stacks, cut, j), distance_of(stacks, whole, j));
    EXPECT_EQ(cut.thickness, distance_of(stacks, cut, 3));
  }
}

TEST(Stacks, OfAVertexAreTheirPatchesScaled) {
  for (const auto on_conflict : {OnConflict::Auto, OnConflict::Compress, OnConflict::Stair}) {
    const Stacks stacks(schedules(on_conflict));
    const StackRequest threefold = {kPatch, 3.0, 3.0, kCount};
    for (double limit = 1.1; limit > 1e-4; limit *= 0.93) {
      const Stack one = fit(stacks, limit), three = stacks.fit(threefold, 3 * limit, kCount);
      EXPECT_EQ(one.end, three.end);
      for (Level j = 1; j <= one.end; ++j) {
        EXPECT_NEAR(distance_of(stacks, three, j), 3 * distance_of(stacks, one, j), 1e-14 * limit);
      }
    }
  }
}

TEST(Stacks, ThinnerThanTheirPatchesLoseGrowthBeforeFirstHeight) {
  const double first = growing_for_tests::geometric(1.0, 1.2, kCount).front();
  const Stacks stacks(schedules(OnConflict::Stair));
  for (const double thickness : {0.9, 0.6, 0.2}) {
    const StackRequest asked = {kPatch, 1.0, thickness, kCount};
    const Stack stack = stacks.fit(asked, thickness, kCount);
    EXPECT_EQ(stack.end, kCount);
    EXPECT_NEAR(distance_of(stacks, stack, kCount), thickness, 1e-15);
    EXPECT_NEAR(distance_of(stacks, stack, 1), std::min(first, thickness / kCount), 1e-16);
    EXPECT_NEAR(stacks.first_height(asked), distance_of(stacks, stack, 1), 1e-16);
  }
}

TEST(Stacks, UpToALowerLevelNeedOnlyTheRoomForThat) {
  const auto heights = growing_for_tests::geometric(1.0, 1.2, kCount);
  const double thickness = heights[0] + heights[1] + heights[2];
  const Stacks stacks(schedules(OnConflict::Auto));
  const StackRequest asked = {kPatch, 1.0, thickness, 3};
  const Stack whole = stacks.fit(asked, 1.0, kCount), squeezed = stacks.fit(asked, 0.97 * thickness, kCount);
  EXPECT_EQ(whole.end, 3);
  EXPECT_EQ(whole.thickness, thickness);
  EXPECT_NEAR(distance_of(stacks, whole, 3), thickness, 1e-15);
  EXPECT_EQ(squeezed.end, 3);
  EXPECT_NEAR(distance_of(stacks, squeezed, 3), 0.97 * thickness, 1e-15);
  EXPECT_NEAR(distance_of(stacks, squeezed, 1), heights[0], 1e-16) << "the first height is kept";
}

}  // namespace
}  // namespace nearwall::layers

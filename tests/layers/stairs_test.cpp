#include <gtest/gtest.h>

#include "tests/support/gallery.h"

// What on_conflict and max_level_step do to whole meshes.

namespace nearwall::layers {
namespace {

using growing_for_tests::geometric;
using growing_for_tests::TestWall;

constexpr int kLayers = 12;

/// Every second patch has five layers, the others twelve, as thick in all.
GrowOptions two_schedules(const mesh::SurfaceMesh& surface, OnConflict on_conflict, std::optional<int> step) {
  const double thickness = 0.03 * gallery::diagonal(surface);
  GrowOptions options;
  for (std::size_t p = 0; p < surface.patch_names.size(); ++p) {
    PatchSchedule schedule;
    schedule.heights = geometric(thickness, 1.2, p % 2 == 0 ? kLayers : 5);
    schedule.on_conflict = on_conflict;
    schedule.max_level_step = step;
    options.schedules.push_back(schedule);
  }
  return options;
}

/// Calls body(u, v) with the windows of the two ends of each edge whose lines both move.
template <class Body>
void for_each_moving_edge(const TestWall& wall, const Growth& growth, const Body& body) {
  const auto window = [&](VertexId v) { return growth.lines.windows[growth.front.line_of(v)]; };
  for (const VertexId v : wall.surface().points.ids()) {
    for (const HalfedgeId h : wall.topology().fan(v)) {
      const mesh::Window a = window(v), b = window(wall.topology().target(h));
      if (a.moves() && b.moves()) body(a, b);
    }
  }
}

TEST(Stairs, StepByNoMoreLevelsThanAskedWhateverThePatches) {
  for (const auto& shape : gallery::few_shapes()) {
    const TestWall wall(gallery::into_the_fluid(shape), shape.fluid_is_inside);
    for (const auto on_conflict : {OnConflict::Compress, OnConflict::Stair}) {
      for (const int step : {1, 3}) {
        const Growth growth = grow(wall.wall(), two_schedules(wall.surface(), on_conflict, step));
        const mesh::LayerMesh layers(growth.front, growth.lines);
        EXPECT_TRUE(certify::certify_layers(layers, wall.certified_wall()).is_valid()) << shape.name;
        for_each_moving_edge(wall, growth,
                             [&](mesh::Window a, mesh::Window b) { EXPECT_LE(a.end - b.end, step) << shape.name; });
      }
    }
  }
}

TEST(Stairs, KeepTheHeightsOfAllLayersTheyHave) {
  const TestWall wall(gallery::catalogued("notch", {{"angle", 20}}, 0.2));
  const GrowOptions options = two_schedules(wall.surface(), OnConflict::Stair, std::nullopt);
  const Growth growth = grow(wall.wall(), options);
  std::size_t n_short = 0;
  for (const LineId line : growth.lines.windows.ids()) {
    const mesh::Window window = growth.lines.windows[line];
    if (!window.moves()) continue;
    n_short += window.end < 5;
    double thickness = 0;
    const auto& heights = growth.lines.table.row(growth.lines.heights[line].row);
    for (Level j = 1; j <= window.end; ++j) thickness = heights[j];
    EXPECT_EQ(growth.lines.height(line, window.end), thickness) << "no height is scaled";
    EXPECT_NEAR(growth.reached_thickness[line], thickness, 1e-12 * thickness);
  }
  EXPECT_GT(n_short, 0u) << "there is no room for all layers in the notch";
}

TEST(Stairs, OfStepsLeaveHeightsAlone) {
  // A step between two patches is no lack of room: no layer becomes thinner for it.
  const TestWall wall(gallery::catalogued("box", {}, 0.1));
  const auto options = two_schedules(wall.surface(), OnConflict::Compress, 1);
  const Growth growth = grow(wall.wall(), options);
  for (const LineId line : growth.lines.windows.ids()) {
    ASSERT_TRUE(growth.lines.windows[line].moves());
    const double first = growth.lines.height(line, static_cast<Level>(growth.lines.windows[line].start + 1));
    EXPECT_GE(first, 0.99 * options.schedules[PatchId(0)].heights.front());
  }
}

TEST(Stairs, GiveAReasonForLinesCutOffByTheirNeighbours) {
  const TestWall wall(gallery::catalogued("box", {}, 0.1));
  const Growth growth = grow(wall.wall(), two_schedules(wall.surface(), OnConflict::Compress, 2));
  std::size_t n_cut = 0;
  for (const LineId line : growth.lines.windows.ids()) {
    if (!(growth.reached_thickness[line] < growth.asked_thickness[line])) continue;
    ++n_cut;
    EXPECT_NE(growth.reason[line], mesh::LimitReason::None);
  }
  EXPECT_GT(n_cut, 0u);
}

}  // namespace
}  // namespace nearwall::layers

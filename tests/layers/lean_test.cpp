#include "layers/lean.h"

#include <cmath>

#include <gtest/gtest.h>

#include "layers/layout.h"
#include "layers/line_set.h"
#include "layers/merit.h"
#include "layers/swept_limit.h"
#include "nearwall/certify/certificate.h"
#include "tests/layers/asked.h"

namespace nearwall::layers {
namespace {

using growing_for_tests::options_for;
using growing_for_tests::TestWall;

/// Shares of the wall's faces whose lines cross below their thickness.
double share_that_crosses(const Asked& a) {
  std::size_t n = 0;
  for (const FaceId f : a.wall.surface().faces.ids()) {
    const auto tops = tops_of(a.plan, a.field, a.wall.wall(), f);
    n += kSweptShare * swept_limit(a.wall.surface().triangle(f), tops) < 1;
  }
  return double(n) / double(a.wall.surface().faces.size());
}

TEST(LinePlan, PassesItsKnotsAndGoesOnStraight) {
  LinePlan plan;
  plan.direction.push_back({0, 0, 1});
  plan.stretch.push_back(1.0);
  const LineId line(0);
  EXPECT_EQ(plan.offset(line, 3), Vec3(0, 0, 3));
  plan.bends.push_back({{1, {0, 0, 1}}, {2, {1, 0, 2}}});
  EXPECT_EQ(plan.foot(line), Vec3(0, 0, 1));
  EXPECT_EQ(plan.offset(line, 0.5), Vec3(0, 0, 0.5));
  EXPECT_EQ(plan.offset(line, 1), Vec3(0, 0, 1));
  EXPECT_EQ(plan.offset(line, 1.5), Vec3(0.5, 0, 1.5));
  EXPECT_EQ(plan.offset(line, 2), Vec3(1, 0, 2));
  EXPECT_EQ(plan.offset(line, 4), Vec3(2, 0, 4)) << "from the base through the last knot";
}

TEST(Lean, LeavesBodiesWhoseLinesDoNotCrossAlone) {
  for (const auto& surface : {shapes_for_tests::sphere(3), shapes_for_tests::cube()}) {
    Asked a(surface, 0.5);
    lean_lines(a.wall.wall(), a.field, a.plan);
    EXPECT_TRUE(a.plan.bends.empty());
  }
}

TEST(Lean, UncrossesLinesBesideSquareCorners) {
  // Layers three edges thick in a corner of three walls: without leaning two lines beside each ridge cross.
  Asked a(gallery::catalogued("octants", {}, 0.1), 0.3);
  const double before = share_that_crosses(a);
  ASSERT_GT(before, 0.01);
  lean_lines(a.wall.wall(), a.field, a.plan);
  EXPECT_LT(share_that_crosses(a), 0.1 * before);
}

TEST(Lean, KeepsFirstHeights) {
  Asked a(gallery::catalogued("step", {}, 0.1), 0.3);
  const LinePlan straight = a.plan;
  lean_lines(a.wall.wall(), a.field, a.plan);
  std::size_t n_bent = 0;
  for (const LineId line : a.plan.direction.ids()) {
    if (!a.plan.is_bent(line)) continue;
    ++n_bent;
    const VertexId v = a.plan.front.line_vertex[line];
    // No edge is shorter than 2^-6 of the thickness, so nothing crosses below that and all lines start as they were.
    EXPECT_EQ(a.plan.foot(line), straight.direction[line] * straight.stretch[line]);
    EXPECT_EQ(a.plan.bends[line].back().at, a.field.thickness[v]);
  }
  EXPECT_GT(n_bent, 10u);
}

TEST(Lean, KeepsFullThicknessBesideConcaveCorners) {
  for (const char* name : {"step", "octants"}) {
    const TestWall wall(gallery::catalogued(name, {}, 0.1));
    GrowOptions options = options_for(wall.surface(), growing_for_tests::geometric(0.3, 1.2, 8));
    const auto n_full = [&] {
      const Growth growth = grow(wall.wall(), options);
      std::size_t n = 0;
      for (const LineId l : growth.reached_thickness.ids()) {
        n += growth.reached_thickness[l] > 0.95 * growth.asked_thickness[l];
      }
      return double(n) / double(growth.reached_thickness.size());
    };
    EXPECT_EQ(n_full(), 1) << name;
    options.lean_lines = options.search_lines = false;
    EXPECT_LT(n_full(), 0.98) << name;
  }
}

TEST(Lean, BringsLinesWhereTheyWerePlanned) {
  std::size_t n_bent = 0;
  for (const char* name : {"step", "fin-on-plate", "wing-body"}) {
    const TestWall wall(gallery::catalogued(name, {}, 0.1));
    const double thickness = 0.05 * gallery::diagonal(wall.surface());
    const GrowOptions options = options_for(wall.surface(), growing_for_tests::geometric(thickness, 1.2, 20));
    const Stacks stacks(options.schedules);
    Layout layout = best_layout(wall.wall(), options, ask(wall.wall(), options, stacks));
    const mesh::Lines lines = make_lines(wall.wall(), layout.plan, stacks, layout.field);
    for (const LineId line : lines.base.ids()) {
      n_bent += layout.plan.is_bent(line);
      if (lines.windows[line].end == 0) continue;
      const VertexId v = layout.plan.front.line_vertex[line];
      const Vec3 planned = layout.plan.offset(line, layout.field.reached[v]);
      const Vec3 top = lines.position(line, lines.windows[line].end) - lines.base[line];
      EXPECT_LT(distance(top, planned), 1e-9 * thickness) << name << " line " << line.index();
    }
  }
  EXPECT_GT(n_bent, 100u);
}

TEST(Lean, BendsLinesGently) {
  // Steps grow by 1.2 in height; along a line by no more than 1.3.
  const TestWall wall(gallery::catalogued("step", {}, 0.05));
  const Growth growth = grow(wall.wall(), options_for(wall.surface(), growing_for_tests::geometric(0.2, 1.2, 20)));
  double largest = 0;
  for (const LineId line : growth.lines.base.ids()) {
    for (Level level = 2; level <= growth.lines.windows[line].end; ++level) {
      const auto step = [&](int j) {
        return distance(growth.lines.position(line, static_cast<Level>(j)),
                        growth.lines.position(line, static_cast<Level>(j - 1)));
      };
      largest = std::max(largest, step(level) / step(level - 1));
    }
  }
  EXPECT_GT(largest, 1.21) << "some line bends";
  EXPECT_LT(largest, 1.3);
}

TEST(Lean, AtOnePlaceDoesNotDependOnWhatThereIsElsewhere) {
  const mesh::SurfaceMesh step = gallery::catalogued("step", {}, 0.1);
  const mesh::SurfaceMesh small =
      shapes_for_tests::translated(shapes_for_tests::scaled(step, 0x1p-10), Vec3(100, 0, 0));
  const auto tops_with = [&](const mesh::SurfaceMesh& surface) {
    Asked a(surface, 0.3);
    for (const VertexId v : surface.points.ids()) {
      if (v.index() >= step.points.size()) a.field.thickness[v] *= 0x1p-10;
    }
    lean_lines(a.wall.wall(), a.field, a.plan);
    std::vector<Vec3> tops;
    for (const VertexId v : step.points.ids()) tops.push_back(a.plan.offset(a.plan.front.line_of(v), 0.3));
    return tops;
  };
  EXPECT_EQ(tops_with(step), tops_with(shapes_for_tests::joined(step, small)));
}

TEST(Layout, SearchesOnlyForWhatKeepsMore) {
  for (const gallery::Shape& shape : gallery::few_shapes()) {
    const TestWall wall(gallery::into_the_fluid(shape), shape.fluid_is_inside);
    const double diagonal = gallery::diagonal(wall.surface());
    GrowOptions options = options_for(wall.surface(), growing_for_tests::geometric(0.02 * diagonal, 1.2, 8));
    const Stacks stacks(options.schedules);
    const VertexField asked = ask(wall.wall(), options, stacks);
    const auto kept = [&] {
      const Layout layout = best_layout(wall.wall(), options, asked);
      double sum = 0;
      for (const FaceId f : wall.surface().faces.ids()) {
        const auto [x, y, z] = wall.surface().triangle(f);
        sum += norm(cross(y - x, z - x)) * merit(wall.wall(), layout.plan, layout.field, asked.asked, f);
      }
      return sum;
    };
    options.lean_lines = options.search_lines = options.try_fans = false;
    const double none = kept();
    options.try_fans = true;
    EXPECT_GE(kept(), none) << shape.name << ": fans are kept where they win";
    options.lean_lines = options.search_lines = true;
    // Limits and grading follow after the directions are chosen: what is won there may be lost again, a little.
    EXPECT_GE(kept(), 0.99 * none) << shape.name;
  }
}

TEST(Layout, TriesFansOnlyWhereSomethingIsLacking) {
  const TestWall cube(shapes_for_tests::cube());
  EXPECT_EQ(grow(cube.wall(), options_for(cube.surface(), {0.01, 0.01})).front.n_lines(), 8u);

  // A block with a notch of 60 degrees: where its bottom line comes out of the side, a corner of two walls that turn by
  // 90 degrees and one ridge that is concave, a single line serves none of them well.
  const TestWall notch(gallery::catalogued("notch", {}, 0.2));
  GrowOptions options = options_for(notch.surface(), growing_for_tests::geometric(0.1, 1.2, 8));
  const Growth with = grow(notch.wall(), options);
  options.try_fans = false;
  const Growth without = grow(notch.wall(), options);
  EXPECT_GT(with.front.n_lines(), without.front.n_lines());
  options.several_lines = false;
  options.try_fans = true;
  EXPECT_EQ(grow(notch.wall(), options).front.n_lines(), notch.surface().points.size()) << "one line is one line";
}

}  // namespace
}  // namespace nearwall::layers

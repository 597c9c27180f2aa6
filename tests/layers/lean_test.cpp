#include "layers/lean.h"

#include <cmath>

#include <gtest/gtest.h>

#include "layers/layout.h"
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

/// A square plate, 10 wide and 1 thick, with a square hole 1 wide in its middle, in as few triangles as there can be:
/// at the rims, which turn by 90 degrees, single lines lean into the hole from all sides.
mesh::SurfaceMesh plate_with_hole() {
  mesh::SurfaceMesh plate;
  plate.patch_names.push_back("plate");
  for (const double z : {0.0, 1.0}) {
    for (const double half : {5.0, 0.5}) {
      plate.points.push_back({-half, -half, z});
      plate.points.push_back({half, -half, z});
      plate.points.push_back({half, half, z});
      plate.points.push_back({-half, half, z});
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    plate.faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
    plate.faces.push_back({VertexId(a), VertexId(c), VertexId(d)});
  };
  // Outer corners 0 … 3 below and 8 … 11 above, those of the hole 4 more.
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4;
    add(8 + k, 8 + next, 12 + next, 12 + k);
    add(next, k, 4 + k, 4 + next);
    add(k, next, 8 + next, 8 + k);
    add(4 + next, 4 + k, 12 + k, 12 + next);
  }
  plate.face_patch.resize(plate.faces.size(), PatchId(0));
  return plate;
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

  const TestWall plate(plate_with_hole());
  GrowOptions options = options_for(plate.surface(), growing_for_tests::geometric(0.4, 1.2, 8));
  const auto n_full = [](const Growth& growth) {
    std::size_t n = 0;
    for (const LineId l : growth.reached_thickness.ids()) n += growth.reached_thickness[l] == growth.asked_thickness[l];
    return double(n) / double(growth.front.n_lines());
  };
  const Growth with = grow(plate.wall(), options);
  options.try_fans = false;
  const Growth without = grow(plate.wall(), options);
  EXPECT_GT(with.front.n_lines(), 16u);
  EXPECT_EQ(without.front.n_lines(), 16u);
  EXPECT_GT(n_full(with), n_full(without) + 0.1);
}

}  // namespace
}  // namespace nearwall::layers

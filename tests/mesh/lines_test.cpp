#include "nearwall/mesh/lines.h"

#include <vector>

#include <gtest/gtest.h>

namespace nearwall::mesh {
namespace {

/// One line from (1, 0, 0) along z, heights 1, 2, 4 with a uniform row after it.
Lines one_line() {
  Lines lines;
  lines.table = HeightTable({{0, 1, 3, 7}, {0, 1, 2, 3}});
  lines.base.push_back({1, 0, 0});
  lines.pieces = {{{0, 0, 1}, 0}};
  lines.first_piece = {0, 1};
  lines.heights.push_back({});
  lines.windows.push_back({0, 3});
  return lines;
}

const LineId kLine(0);

TEST(Lines, StandOnTheirBaseAndFollowTheTable) {
  const Lines lines = one_line();
  EXPECT_EQ(lines.position(kLine, 0), Vec3(1, 0, 0));
  EXPECT_EQ(lines.position(kLine, 2), Vec3(1, 0, 3));
  EXPECT_EQ(lines.position(kLine, 3), Vec3(1, 0, 7));
}

TEST(Lines, StayPutOutsideTheirWindow) {
  Lines lines = one_line();
  lines.windows[kLine] = {1, 2};
  EXPECT_EQ(lines.position(kLine, 1), Vec3(1, 0, 0));
  EXPECT_EQ(lines.position(kLine, 2), Vec3(1, 0, 3)) << "a late start takes its first two heights in one step";
  EXPECT_EQ(lines.position(kLine, 3), Vec3(1, 0, 3));
  lines.windows[kLine] = {2, 2};
  EXPECT_EQ(lines.position(kLine, 3), Vec3(1, 0, 0)) << "a window without levels never moves";
}

TEST(Lines, BlendRowsAndKeepTheFirstHeight) {
  Lines lines = one_line();
  lines.heights[kLine] = {0, 0.25, 0.75};
  EXPECT_EQ(lines.position(kLine, 1).z(), 1);
  EXPECT_EQ(lines.position(kLine, 3).z(), 0.25 * 7 + 0.75 * 3);
}

TEST(Lines, BendWhereAPieceEnds) {
  Lines lines = one_line();
  lines.pieces = {{{0, 0, 1}, 0}, {{0, 1, 0}, 2}, {{1, 0, 0}, 5}};
  lines.first_piece = {0, 3};
  EXPECT_EQ(lines.position(kLine, 1), Vec3(1, 0, 1));
  EXPECT_EQ(lines.position(kLine, 2), Vec3(1, 1, 2));
  EXPECT_EQ(lines.position(kLine, 3), Vec3(3, 3, 2));
}

TEST(Lines, GiveTheSameBitsOneByOneAndInARow) {
  Lines lines = one_line();
  lines.heights[kLine] = {0, 0.3, 0.7};
  lines.pieces[0].direction = normalized({1, 2, 3}) * 1.1;
  std::vector<double> x(3), y(3), z(3);
  lines.positions(kLine, 1, 3, x.data(), y.data(), z.data());
  for (Level j = 1; j <= 3; ++j) {
    EXPECT_EQ(lines.position(kLine, j), Vec3(x[j - 1u], y[j - 1u], z[j - 1u]));
  }
}

}  // namespace
}  // namespace nearwall::mesh

// Every cell type against GMP's integers, on cells made to deceive. Built twice: some seconds for every day, and
// millions of cells (NEARWALL_TIMES) under the label slow.

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "nearwall/predicates/cells.h"
#include "tests/predicates/adversary.h"
#include "tests/predicates/reference.h"

#ifndef NEARWALL_TIMES
#define NEARWALL_TIMES 1
#endif

namespace nearwall::predicates {
namespace {

using adversary::Adversary;
using adversary::Trap;

constexpr int kTimes = NEARWALL_TIMES;

Positivity positive_if(bool holds) { return holds ? Positivity::Positive : Positivity::NotPositive; }

TEST(Reference, FindsParabolasWithoutRootsAsSturmDoes) {
  int n_touching = 0;
  for (int at_0 = 1; at_0 <= 12; ++at_0) {
    for (int at_1 = 1; at_1 <= 12; ++at_1) {
      for (int four_at_half = -20; four_at_half <= 40; ++four_at_half) {
        const int roots = reference::roots_in_unit_interval(at_0, four_at_half, at_1);
        ASSERT_EQ(reference::is_parabola_positive(at_0, four_at_half, at_1), roots == 0);
        n_touching += roots == 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(n_touching, 10);
}

class CellsInTraps : public testing::TestWithParam<Trap> {};
INSTANTIATE_TEST_SUITE_P(, CellsInTraps, testing::ValuesIn(adversary::kAllTraps),
                         [](const auto& trap) { return adversary::name_of(trap.param); });

TEST_P(CellsInTraps, TetrahedraAgreeWithIntegers) {
  Adversary adversary(GetParam(), 51);
  int n_positive = 0;
  constexpr int kRounds = 4000 * kTimes;
  for (int i = 0; i < kRounds; ++i) {
    const auto p = adversary.tetrahedron();
    const bool expected = reference::orientation(p[0], p[1], p[2], p[3]) > 0;
    ASSERT_EQ(tetrahedron(p), positive_if(expected)) << adversary::text_of(p);
    n_positive += expected ? 1 : 0;
  }
  EXPECT_GT(n_positive, kRounds / 100);
  EXPECT_LT(n_positive, kRounds);
}

TEST_P(CellsInTraps, PyramidsAgreeWithIntegers) {
  Adversary adversary(GetParam(), 52);
  int n_positive = 0;
  constexpr int kRounds = 4000 * kTimes;
  for (int i = 0; i < kRounds; ++i) {
    const auto p = adversary.pyramid();
    const bool expected = reference::is_pyramid_positive(p);
    ASSERT_EQ(pyramid(p), positive_if(expected)) << adversary::text_of(p);
    n_positive += expected ? 1 : 0;
  }
  EXPECT_GT(n_positive, kRounds / 500);
  EXPECT_LT(n_positive, kRounds);
}

TEST_P(CellsInTraps, WedgesAgreeWithIntegers) {
  Adversary adversary(GetParam(), 53);
  int n_positive = 0;
  constexpr int kRounds = 8000 * kTimes;
  for (int i = 0; i < kRounds; ++i) {
    const auto p = adversary.wedge();
    const bool expected = reference::is_wedge_positive(p);
    ASSERT_EQ(wedge(p), positive_if(expected)) << adversary::text_of(p);
    n_positive += expected ? 1 : 0;
  }
  EXPECT_GT(n_positive, kRounds / 1000);
  EXPECT_LT(n_positive, kRounds);
}

TEST_P(CellsInTraps, HexahedraAgreeWithIntegers) {
  Adversary adversary(GetParam(), 54);
  std::array<int, 3> seen{};
  const bool is_costly = GetParam() == Trap::Touching;  // what touches zero is cut up many times
  const int n_rounds = (is_costly ? 4 : 1000) * kTimes;
  for (int i = 0; i < n_rounds; ++i) {
    const auto p = adversary.hexahedron();
    const Positivity expected = reference::hexahedron_positivity(p);
    ASSERT_EQ(hexahedron(p), expected) << adversary::text_of(p);
    ++seen[static_cast<std::size_t>(expected)];
  }
  EXPECT_GT(seen[1], 0);
  if (is_costly && kTimes > 1) {
    EXPECT_GT(seen[2], 0) << "undecided";
  }
}

/// Lines through the corners of a wedge, straight on above and below it but for a last place here and there.
struct Column {
  std::array<std::array<std::vector<double>, 3>, 3> c;  ///< axis, line, level

  Column(const std::array<Vec3, 6>& w, int n_levels, Adversary& adversary) {
    const int level_of_wedge = adversary.integer(0, n_levels - 1);
    for (int j = 0; j <= n_levels; ++j) {
      std::array<Vec3, 3> nodes;
      for (std::size_t k = 0; k < 3; ++k) nodes[k] = w[k] + (j - level_of_wedge) * (w[3 + k] - w[k]);
      if (adversary.integer(0, 3) == 0) adversary.nudge(nodes);
      for (std::size_t k = 0; k < 3; ++k) {
        for (int axis = 0; axis < 3; ++axis) c[static_cast<std::size_t>(axis)][k].push_back(nodes[k][axis]);
      }
    }
  }
  WedgeColumn view() const {
    return {{c[0][0].data(), c[0][1].data(), c[0][2].data()},
            {c[1][0].data(), c[1][1].data(), c[1][2].data()},
            {c[2][0].data(), c[2][1].data(), c[2][2].data()}};
  }
  std::array<Vec3, 6> wedge_at(std::size_t level) const {
    std::array<Vec3, 6> w;
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t line = i % 3, at = level + i / 3;
      w[i] = {c[0][line][at], c[1][line][at], c[2][line][at]};
    }
    return w;
  }
};

TEST_P(CellsInTraps, ColumnsEndWhereTheirWedgesDo) {
  Adversary adversary(GetParam(), 55);
  int n_good = 0, n_levels_in_all = 0;
  for (int i = 0; i < 1000 * kTimes; ++i) {
    const int n_levels = adversary.integer(1, 9);
    const Column column(adversary.wedge(), n_levels, adversary);
    int expected = 0;
    while (expected < n_levels && reference::is_wedge_positive(column.wedge_at(static_cast<std::size_t>(expected)))) {
      ASSERT_EQ(wedge(column.wedge_at(static_cast<std::size_t>(expected))), Positivity::Positive);
      ++expected;
    }
    ASSERT_EQ(first_bad_wedge(column.view(), n_levels), expected) << adversary::text_of(column.wedge_at(0));
    n_good += expected;
    n_levels_in_all += n_levels;
  }
  EXPECT_GT(n_good, 0);
  EXPECT_LT(n_good, n_levels_in_all);
}

}  // namespace
}  // namespace nearwall::predicates

#include "layers/height_rows.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/growing.h"

namespace nearwall::layers {
namespace {

double thickness(const mesh::HeightTable& table, const mesh::Heights& heights, Level level) {
  const double* a = table.row(heights.row);
  return heights.weight_1 == 0 ? heights.weight_0 * a[level]
                               : heights.weight_0 * a[level] + heights.weight_1 * table.row(heights.row + 1)[level];
}

class Fit : public testing::Test {
 protected:
  const std::vector<double> heights_ = growing_for_tests::geometric(1.0, 1.2, 20);
  const HeightRows rows_{{heights_}};
  const mesh::HeightTable table_ = rows_.table();
};

TEST_F(Fit, GivesWhatIsAskedWhereItFits) {
  for (const double limit : {1.0, 5.0}) {
    const mesh::Heights h = rows_.fit(0, limit, 20);
    double sum = 0;
    for (std::size_t j = 0; j < heights_.size(); ++j) {
      sum += heights_[j];
      EXPECT_NEAR(thickness(table_, h, static_cast<Level>(j + 1)), sum, 1e-15);
    }
  }
}

TEST_F(Fit, ReachesTheLimitExactlyAndKeepsTheFirstHeight) {
  const double uniform = 20 * heights_.front();
  for (double limit = 0.99; limit > uniform; limit -= 0.037) {
    const mesh::Heights h = rows_.fit(0, limit, 20);
    EXPECT_NEAR(thickness(table_, h, 20), limit, 1e-14);
    EXPECT_NEAR(thickness(table_, h, 1), heights_.front(), 1e-16);
    double last = 0;
    for (Level j = 1; j <= 20; ++j) {
      const double height = thickness(table_, h, j) - thickness(table_, h, static_cast<Level>(j - 1));
      EXPECT_LE(height, j > 1 ? last * (1.2 + 1e-12) : heights_.front() * 1.001) << "never grows faster than asked";
      EXPECT_GE(height, last * (1 - 1e-12));
      last = height;
    }
  }
}

TEST_F(Fit, ScalesTheUniformStackWhereEvenThatIsTooThick) {
  const double limit = heights_.front();
  const mesh::Heights h = rows_.fit(0, limit, 20);
  EXPECT_NEAR(thickness(table_, h, 20), limit, 1e-16);
  EXPECT_NEAR(thickness(table_, h, 1), limit / 20, 1e-16);
}

TEST_F(Fit, OfALowerLevelReachesTheLimitThere) {
  // Eight layers, the first of 1.2 % of the whole stack of twenty: 8.8 % of it.
  const double asked = rows_.asked_thickness(0, 8), uniform = 8 * heights_.front();
  for (double share = 0.97; share > 0; share -= 0.08) {
    const double limit = uniform + share * (asked - uniform);
    const mesh::Heights h = rows_.fit(0, limit, 8);
    EXPECT_NEAR(thickness(table_, h, 8), limit, 1e-15);
    EXPECT_NEAR(thickness(table_, h, 1), heights_.front(), 1e-16);
  }
  EXPECT_NEAR(thickness(table_, rows_.fit(0, 0.5 * uniform, 8), 8), 0.5 * uniform, 1e-16);
  EXPECT_EQ(rows_.fit(0, asked, 8).weight_1, 0);
}

TEST(HeightRows, SharesTheRowsOfEqualSchedules) {
  const HeightRows rows({{1, 2, 3}, {1, 1}, {1, 2, 3}, {}});
  EXPECT_EQ(rows.first_row(0), rows.first_row(2));
  EXPECT_NE(rows.first_row(0), rows.first_row(1));
  EXPECT_EQ(rows.n_levels(1), 2);
  EXPECT_EQ(rows.n_levels(3), 0);
  EXPECT_EQ(rows.table().n_levels(), 3);
}

TEST(HeightRows, KeepsLayersThinnerThanTheFirst) {
  const HeightRows rows({{2, 1, 4}});
  EXPECT_DOUBLE_EQ(rows.uniform_thickness(0, 3), 2 + 1 + 2);
}

}  // namespace
}  // namespace nearwall::layers

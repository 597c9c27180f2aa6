#include "nearwall/quality/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace nearwall::quality {
namespace {

double share_of_all_bars(const Statistics& s) {
  return std::accumulate(s.bars.begin(), s.bars.end(), 0.0, [](double sum, const Bar& b) { return sum + b.share; });
}

TEST(WeightedStatistics, QuantilesFollowTheWeights) {
  const std::vector<double> values = {5, 1, 3, 2};
  const std::vector<double> weights = {0.005, 0.5, 0.015, 0.48};
  const Statistics s = weighted_statistics(values, weights);
  EXPECT_EQ(s.count, 4u);
  EXPECT_EQ(s.min, 1);
  EXPECT_EQ(s.p01, 1);
  EXPECT_EQ(s.median, 1);
  EXPECT_EQ(s.p99, 3);
  EXPECT_EQ(s.max, 5);
  EXPECT_NEAR(s.mean, 0.025 + 0.5 + 0.045 + 0.96, 1e-15);
  EXPECT_NEAR(share_of_all_bars(s), 1, 1e-14);
}

TEST(WeightedStatistics, LeavesOutWhatHasNoWeight) {
  const Statistics s = weighted_statistics(std::vector<double>{7, 1}, std::vector<double>{1, 0});
  EXPECT_EQ(s.min, 7);
  EXPECT_EQ(s.count, 1u);
  EXPECT_EQ(weighted_statistics({}, {}).count, 0u);
}

TEST(WeightedStatistics, DoesNotFeelTheOrder) {
  std::mt19937 random(7);
  std::vector<std::pair<double, double>> data(1000);
  for (auto& [v, w] : data) v = static_cast<double>(random() % 50), w = 1.0 / static_cast<double>(1 + random() % 97);
  const auto statistics = [&] {
    std::vector<double> v, w;
    for (const auto& d : data) v.push_back(d.first), w.push_back(d.second);
    return weighted_statistics(v, w);
  };
  const Statistics a = statistics();
  std::shuffle(data.begin(), data.end(), random);
  const Statistics b = statistics();
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.median, b.median);
  EXPECT_EQ(a.bars[3].share, b.bars[3].share);
}

TEST(Histogram, HasTheQuantilesOfTheSortedValuesUpToABin) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.3, 0.1);
  Histogram histogram(Binning::linear(-1, 1, 2000));
  std::vector<double> all;
  for (int i = 0; i < 20000; ++i) {
    all.push_back(normal(random));
    histogram.add(all.back());
  }
  std::sort(all.begin(), all.end());
  const Statistics s = histogram.statistics();
  EXPECT_EQ(s.min, all.front());
  EXPECT_EQ(s.max, all.back());
  EXPECT_NEAR(s.p01, all[199], 0.001);
  EXPECT_NEAR(s.median, all[9999], 0.001);
  EXPECT_NEAR(s.p99, all[19799], 0.001);
  EXPECT_NEAR(s.mean, std::accumulate(all.begin(), all.end(), 0.0) / 20000, 1e-12);
  EXPECT_NEAR(share_of_all_bars(s), 1, 1e-12);
  EXPECT_GT(s.bars.size(), 10u);
}

TEST(Histogram, OfEqualValuesIsExact) {
  Histogram histogram(Binning::doublings(-4, 4, 64));
  for (int i = 0; i < 10; ++i) histogram.add(1.2);
  const Statistics s = histogram.statistics();
  EXPECT_EQ(s.median, 1.2);
  EXPECT_EQ(s.p99, 1.2);
  EXPECT_EQ(s.mean, 1.2);
}

TEST(Histogram, OfDoublingsKeepsARelativeWidth) {
  Histogram histogram(Binning::doublings(0, 30, 128));
  for (int i = 0; i <= 1000; ++i) histogram.add(std::pow(10.0, i / 200.0));  // 1 … 1e5
  EXPECT_NEAR(histogram.statistics().median, std::pow(10, 2.5), std::pow(10, 2.5) / 64);
}

TEST(Histogram, CountsWhatLiesOutsideItsBins) {
  Histogram histogram(Binning::linear(0, 1, 10));
  histogram.add(-5);
  histogram.add(7);
  histogram.add(std::numeric_limits<double>::infinity());
  const Statistics s = histogram.statistics();
  EXPECT_EQ(s.count, 3u);
  EXPECT_EQ(s.min, -5);
  EXPECT_TRUE(std::isinf(s.max));
}

TEST(Histogram, MergesAsIfAllWereAddedToOne) {
  Histogram whole(Binning::linear(0, 1, 100)), a(Binning::linear(0, 1, 100)), b(Binning::linear(0, 1, 100));
  for (int i = 0; i < 50; ++i) {
    whole.add(i / 64.0);
    (i < 20 ? a : b).add(i / 64.0);
  }
  a.merge(b);
  EXPECT_EQ(a.statistics().median, whole.statistics().median);
  EXPECT_EQ(a.statistics().mean, whole.statistics().mean);  // multiples of 1/64: sums are exact
}

TEST(Histogram, OfNothingIsAllZero) { EXPECT_EQ(Histogram(Binning::linear(0, 1, 10)).statistics().bars.size(), 0u); }

}  // namespace
}  // namespace nearwall::quality

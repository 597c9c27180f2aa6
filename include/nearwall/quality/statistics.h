#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nearwall::quality {

/// A bar of a histogram: the share of all weight with low <= value < high.
struct Bar {
  double low = 0;
  double high = 0;
  double share = 0;  ///< 0 … 1
};

/// How a quantity is distributed. All zero where there was nothing to look at (count == 0).
struct Statistics {
  std::uint64_t count = 0;
  double min = 0;
  double p01 = 0;  ///< first percentile
  double median = 0;
  double p99 = 0;  ///< 99th percentile
  double max = 0;
  double mean = 0;
  std::vector<Bar> bars;  ///< for pictures; about 40, over the range that holds all but the extreme values
};

/// Statistics of values with weights (areas): exact quantiles by sorting. The p-quantile is the smallest value such
/// that the weight of all values up to it is at least p times the whole. \param values, weights  (n); values without
/// weight are left out; a value that is not finite counts as the largest \param logarithmic      bars at equal ratios
/// rather than equal steps; for values > 0 Cost: O(n log n).
Statistics weighted_statistics(std::span<const double> values, std::span<const double> weights,
                               bool logarithmic = false);

/// Bins with fixed limits, so that any number of cells can be counted in constant memory.
struct Binning {
  bool logarithmic = false;
  double low = 0;
  double high = 1;
  int bins = 0;  ///< linear: in all; logarithmic: for each doubling, a power of two

  /// `bins` equal steps from low to high.
  static Binning linear(double low, double high, int bins) { return {false, low, high, bins}; }
  /// `per_octave` equal steps in each doubling from 2^low_exponent to 2^high_exponent.
  static Binning doublings(int low_exponent, int high_exponent, int per_octave) {
    return {true, static_cast<double>(low_exponent), static_cast<double>(high_exponent), per_octave};
  }
};

/// Counts values in bins. Min, max and mean are exact; quantiles are exact up to the width of a bin (values beyond the
/// first and last bin are counted in these). Merging histograms in a fixed order gives the same bits on any number of
/// threads.
class Histogram {
 public:
  explicit Histogram(const Binning& binning);
  void add(double value);
  void merge(const Histogram& other);
  Statistics statistics() const;
  std::uint64_t count() const { return count_; }

 private:
  std::size_t bin_of(double value) const;
  double limit(std::size_t bin) const;
  double quantile(double p) const;
  std::vector<Bar> bars() const;

  Binning binning_;
  std::vector<std::uint64_t> counts_;
  std::uint64_t count_ = 0;
  double min_;
  double max_;
  double sum_ = 0;
};

}  // namespace nearwall::quality

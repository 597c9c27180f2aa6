#include "nearwall/quality/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "nearwall/core/expect.h"
#include "nearwall/geometry/measures.h"

namespace nearwall::quality {

namespace {

constexpr double kLowQuantile = 0.01;
constexpr double kHighQuantile = 0.99;
constexpr std::size_t kNBars = 40;

/// Limits of the bars between two values: equal steps, or equal ratios where both are positive.
class BarAxis {
 public:
  BarAxis(double low, double high, bool logarithmic)
      : logarithmic_(logarithmic && low > 0), low_(map(low)), high_(map(high)) {}

  bool is_flat() const { return !(high_ > low_) || !std::isfinite(high_ - low_); }
  std::size_t bar_of(double value) const {
    const double t = (map(value) - low_) / (high_ - low_) * kNBars;
    return static_cast<std::size_t>(std::clamp(t, 0.0, static_cast<double>(kNBars - 1)));
  }
  double limit(std::size_t bar) const {
    const double t = low_ + (high_ - low_) * (static_cast<double>(bar) / kNBars);
    return logarithmic_ ? std::exp(t) : t;
  }

 private:
  double map(double value) const { return logarithmic_ ? std::log(value) : value; }

  bool logarithmic_;
  double low_;
  double high_;
};

std::vector<Bar> empty_bars(const BarAxis& axis) {
  std::vector<Bar> bars(kNBars);
  for (std::size_t i = 0; i < kNBars; ++i) bars[i] = {axis.limit(i), axis.limit(i + 1), 0};
  return bars;
}

/// The bars reach from the first to the 99th percentile and as far again as the extremes allow, so that a few odd
/// values do not squeeze all others into one bar.
std::pair<double, double> bar_range(const Statistics& s) {
  const double spread = s.p99 - s.p01;
  const double margin = spread > 0 ? 0.5 * spread : std::abs(s.median) * 0.5;
  return {std::max(s.min, s.p01 - margin), std::min(s.max, s.p99 + margin)};
}

}  // namespace

Statistics weighted_statistics(std::span<const double> values, std::span<const double> weights, bool logarithmic) {
  expect(values.size() == weights.size(), "each value has a weight");
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (weights[i] > 0) order.push_back(i);
  }
  Statistics s;
  if (order.empty()) return s;
  const auto key = [&](std::size_t i) {
    return std::isnan(values[i]) ? std::numeric_limits<double>::infinity() : values[i];
  };
  // Equal values by weight, so that the sums below do not depend on how the triangles are numbered.
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) != key(b) ? key(a) < key(b) : weights[a] < weights[b]; });
  geometry::CompensatedSum total, moment;
  for (const std::size_t i : order) {
    total.add(weights[i]);
    moment.add(weights[i] * key(i));
  }
  const auto quantile = [&](double p) {
    geometry::CompensatedSum sum;
    for (const std::size_t i : order) {
      sum.add(weights[i]);
      if (sum.value() >= p * total.value()) return key(i);
    }
    return key(order.back());
  };
  s.count = order.size();
  s.min = key(order.front());
  s.max = key(order.back());
  s.p01 = quantile(kLowQuantile);
  s.median = quantile(0.5);
  s.p99 = quantile(kHighQuantile);
  s.mean = std::clamp(moment.value() / total.value(), s.min, s.max);

  const auto [low, high] = bar_range(s);
  const BarAxis axis(low, high, logarithmic);
  if (axis.is_flat()) {
    s.bars = {{s.min, s.max, 1}};
    return s;
  }
  s.bars = empty_bars(axis);
  for (const std::size_t i : order) s.bars[axis.bar_of(key(i))].share += weights[i] / total.value();
  return s;
}

Histogram::Histogram(const Binning& binning)
    : binning_(binning), min_(std::numeric_limits<double>::infinity()), max_(-std::numeric_limits<double>::infinity()) {
  expect(binning.bins > 0 && binning.high > binning.low, "a histogram has bins");
  const double n = binning.logarithmic ? (binning.high - binning.low) * binning.bins : binning.bins;
  counts_.assign(static_cast<std::size_t>(n), 0);
}

std::size_t Histogram::bin_of(double value) const {
  const double last = static_cast<double>(counts_.size() - 1);
  double position = 0;
  if (binning_.logarithmic) {
    // Exponent and mantissa rather than a logarithm: exact, and the same for values scaled by powers of two.
    if (!(value > 0)) return 0;
    if (std::isinf(value)) return counts_.size() - 1;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);  // 0.5 … 1, value = mantissa 2^exponent
    position = (exponent - 1 - binning_.low + (2 * mantissa - 1)) * binning_.bins;
  } else {
    position = (value - binning_.low) / (binning_.high - binning_.low) * binning_.bins;
  }
  return static_cast<std::size_t>(std::clamp(position, 0.0, last));
}

double Histogram::limit(std::size_t bin) const {
  if (!binning_.logarithmic) {
    return binning_.low + (binning_.high - binning_.low) * (static_cast<double>(bin) / binning_.bins);
  }
  const std::size_t per_octave = static_cast<std::size_t>(binning_.bins);
  const double fraction = static_cast<double>(bin % per_octave) / binning_.bins;
  return std::ldexp(1 + fraction, static_cast<int>(binning_.low) + static_cast<int>(bin / per_octave));
}

void Histogram::add(double value) {
  if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
  ++counts_[bin_of(value)];
  ++count_;
  min_ = std::min(min_, value);
  max_ = std::max(max_, value);
  sum_ += value;
}

void Histogram::merge(const Histogram& other) {
  expect(counts_.size() == other.counts_.size(), "only histograms of the same bins can be merged");
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  count_ += other.count_;
  min_ = std::min(min_, other.min_);
  max_ = std::max(max_, other.max_);
  sum_ += other.sum_;
}

double Histogram::quantile(double p) const {
  const double target = p * static_cast<double>(count_);
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (counts_[i] == 0) continue;
    if (static_cast<double>(below + counts_[i]) >= target) {
      const double t = (target - static_cast<double>(below)) / static_cast<double>(counts_[i]);
      return std::clamp(limit(i) + t * (limit(i + 1) - limit(i)), min_, max_);
    }
    below += counts_[i];
  }
  return max_;
}

std::vector<Bar> Histogram::bars() const {
  Statistics s;
  s.min = min_, s.max = max_, s.p01 = quantile(kLowQuantile), s.median = quantile(0.5), s.p99 = quantile(kHighQuantile);
  const auto [low, high] = bar_range(s);
  const BarAxis axis(low, high, binning_.logarithmic);
  if (axis.is_flat() || bin_of(low) == bin_of(high)) return {{min_, max_, 1}};
  std::vector<Bar> bars = empty_bars(axis);
  // A bin that straddles the limit of two bars counts in that of its middle.
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const double middle = std::clamp(0.5 * (limit(i) + limit(i + 1)), low, high);
    bars[axis.bar_of(middle)].share += static_cast<double>(counts_[i]) / static_cast<double>(count_);
  }
  return bars;
}

Statistics Histogram::statistics() const {
  Statistics s;
  if (count_ == 0) return s;
  s.count = count_;
  s.min = min_;
  s.p01 = quantile(kLowQuantile);
  s.median = quantile(0.5);
  s.p99 = quantile(kHighQuantile);
  s.max = max_;
  s.mean = std::clamp(sum_ / static_cast<double>(count_), min_, max_);
  s.bars = bars();
  return s;
}

}  // namespace nearwall::quality

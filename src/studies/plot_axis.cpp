#include "studies/plot_axis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::studies {

namespace {

constexpr double kMostTicks = 7;

/// Smallest of 1, 2, 5 times a power of ten that cuts the span into at most `kMostTicks`.
double round_step(double span) {
  const double power = std::pow(10.0, std::floor(std::log10(span / kMostTicks)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (span <= kMostTicks * factor * power) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

Axis::Axis(const std::vector<double>& values, bool is_log) : is_log_(is_log) {
  bool is_empty = true;
  for (const double value : values) {
    if (!can_show(value)) continue;
    const double v = is_log ? std::log10(value) : value;
    low_ = is_empty ? v : std::min(low_, v);
    high_ = is_empty ? v : std::max(high_, v);
    is_empty = false;
  }
  if (is_empty) throw InputError("plot: expected numbers to show, found none");
  if (low_ == high_) low_ -= 0.5, high_ += 0.5;
  if (is_log) {
    place_log_ticks();
  } else {
    place_linear_ticks();
  }
}

bool Axis::can_show(double value, bool is_log) { return std::isfinite(value) && (!is_log || value > 0); }

double Axis::place(double value) const { return ((is_log_ ? std::log10(value) : value) - low_) / (high_ - low_); }

void Axis::place_linear_ticks() {
  const double step = round_step(high_ - low_);
  const double first = std::floor(low_ / step), last = std::ceil(high_ / step);
  for (double i = first; i <= last; ++i) ticks_.push_back(i * step);
  low_ = first * step, high_ = last * step;
}

void Axis::place_log_ticks() {
  constexpr double kFewDecades = 2;  // fewer than these get ticks at 2 and 5, too
  const double span = high_ - low_;
  const double step = std::max(1.0, std::ceil(span / kMostTicks));
  for (double exponent = std::floor(low_); exponent <= std::ceil(high_); exponent += step) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor == 1.0 || span < kFewDecades) ticks_.push_back(factor * std::pow(10.0, exponent));
    }
  }
  // The axis ends at the last tick below all values and the first above.
  const auto first_inside = std::upper_bound(ticks_.begin(), ticks_.end(), std::pow(10.0, low_));
  if (first_inside != ticks_.begin()) ticks_.erase(ticks_.begin(), first_inside - 1);
  const auto first_above = std::lower_bound(ticks_.begin(), ticks_.end(), std::pow(10.0, high_));
  if (first_above != ticks_.end()) ticks_.erase(first_above + 1, ticks_.end());
  low_ = std::min(low_, std::log10(ticks_.front()));
  high_ = std::max(high_, std::log10(ticks_.back()));
}

std::string Axis::label(double tick) {
  constexpr double kSmall = 5e-4, kLarge = 1e5;  // beyond these, powers of ten are shorter
  constexpr double kRounding = 1e-9;             // of ticks and their logarithms, generously
  const double size = std::abs(tick);
  if (size == 0 || (size >= kSmall && size < kLarge)) return fmt::format("{:.4g}", tick);
  const double exponent = std::floor(std::log10(size) + kRounding);
  const double mantissa = tick / std::pow(10.0, exponent);
  const std::string factor = std::abs(mantissa - 1.0) < kRounding ? "" : fmt::format("{:.2g}·", mantissa);
  return fmt::format("{}10<tspan dy='-4' font-size='9'>{}</tspan>", factor,
                     exponent < 0 ? fmt::format("−{:.0f}", -exponent) : fmt::format("{:.0f}", exponent));
}

}  // namespace nearwall::studies

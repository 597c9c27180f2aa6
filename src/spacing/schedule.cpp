#include "nearwall/spacing/schedule.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "spacing/law.h"

namespace nearwall::spacing {

namespace {

/// Relative amount by which a stack may fall short of an asked thickness and still count as reaching it: figures are
/// typed with a few digits.
constexpr double kTypedDigits = 1e-4;

[[noreturn]] void reject(const std::string& message) { throw InputError(message); }

void expect_length(const std::optional<double>& value, const char* name) {
  if (value && (!(*value > 0) || !std::isfinite(*value))) {
    reject(fmt::format("{}: expected a length above 0, found {}", name, *value));
  }
}

void expect_range(double value, double low, double high, const char* name) {
  if (!(value >= low && value <= high)) {
    reject(fmt::format("{}: expected a number from {} to {}, found {}{}", name, low, high, value,
                       value < 1 && value > 0 && low == 1 ? "; layers never get thinner away from the wall" : ""));
  }
}

void expect_in_range(const ScheduleRequest& r) {
  expect_length(r.first_height, "first_height");
  expect_length(r.total_thickness, "total_thickness");
  if (r.growth) expect_range(*r.growth, 1, kMaxGrowth, "growth");
  if (r.count) expect_range(*r.count, 1, kMaxCount, "count");
  if (r.law != Law::Table && !r.heights.empty()) {
    reject(fmt::format("heights: are for the law \"table\", the law is \"{}\"", law_name(r.law)));
  }
  if (r.law != Law::Accelerating) return;
  expect_range(r.constant_layers, 1, kMaxCount, "constant_layers");
  expect_range(r.acceleration, 0, 1, "acceleration");
  expect_range(r.largest_growth, 1, kMaxGrowth, "largest_growth");
  if (r.growth && *r.growth > r.largest_growth) {
    reject(
        fmt::format("growth: {} is above largest_growth = {}; lower it or raise the cap", *r.growth, r.largest_growth));
  }
}

/// Fills in growth and count where fewer than three quantities are given.
ScheduleRequest with_defaults(ScheduleRequest r) {
  if (!r.first_height && !r.total_thickness) {
    reject("the heights are missing: give first_height (or y_plus with [flow]) or total_thickness");
  }
  const auto n_given = [&r] {
    return int{r.first_height.has_value()} + int{r.growth.has_value()} + int{r.count.has_value()} +
           int{r.total_thickness.has_value()};
  };
  if (n_given() == 4) {
    reject("any three of first_height, growth, count and total_thickness determine the fourth; leave out one");
  }
  const Acceleration cap{r.constant_layers, r.acceleration, r.largest_growth};
  if (n_given() < 3 && !r.growth) r.growth = std::min(kDefaultGrowth, largest_growth(r.law, cap));
  if (n_given() < 3) r.count = kDefaultCount;
  return r;
}

void solve_count(ScheduleRequest& r, const Acceleration& acceleration) {
  const double ratio = *r.total_thickness / *r.first_height;
  if (ratio < 1 - kTypedDigits) {
    reject(fmt::format("total_thickness: {} is less than the first layer alone, first_height = {}", *r.total_thickness,
                       *r.first_height));
  }
  int count = 1;
  while (relative_thickness(r.law, *r.growth, count, acceleration) < ratio * (1 - kTypedDigits)) {
    if (++count > kMaxCount) {
      reject(
          fmt::format("more than {} layers would be needed for total_thickness = {} from first_height = {} "
                      "with growth {}; raise the growth or the first height, or lower the thickness",
                      kMaxCount, *r.total_thickness, *r.first_height, *r.growth));
    }
  }
  r.count = count;
  // One layer more than needed at most: less growth, and only then a smaller first height, take up what is too much.
  const double thinnest = relative_thickness(r.law, 1, count, acceleration);
  if (thinnest >= ratio) {
    r.growth = 1;
    r.first_height = *r.total_thickness / thinnest;
  } else {
    r.growth = solve_growth(r.law, count, ratio, acceleration);
  }
}

void solve_for_growth(ScheduleRequest& r, const Acceleration& acceleration) {
  const double ratio = *r.total_thickness / *r.first_height;
  const double thinnest = relative_thickness(r.law, 1, *r.count, acceleration);
  if (ratio < thinnest * (1 - kTypedDigits)) {
    reject(fmt::format(
        "{} layers from first_height = {} are at least {:.6g} thick, more than total_thickness = {}: "
        "lower first_height to {:.6g} or less, lower count, or raise total_thickness",
        *r.count, *r.first_height, *r.first_height * thinnest, *r.total_thickness, *r.total_thickness / thinnest));
  }
  const double limit = largest_growth(r.law, acceleration);
  const double thickest = relative_thickness(r.law, limit, *r.count, acceleration);
  if (ratio > thickest * (1 + kTypedDigits)) {
    reject(
        fmt::format("{} layers from first_height = {} would have to grow by more than {} each to be {} thick: "
                    "raise count, raise first_height to {:.6g} or more, or lower total_thickness",
                    *r.count, *r.first_height, limit, *r.total_thickness, *r.total_thickness / thickest));
  }
  r.growth = solve_growth(r.law, *r.count, ratio, acceleration);
}

Schedule table(const ScheduleRequest& r) {
  if (r.first_height || r.growth || r.count || r.total_thickness) {
    reject("the law \"table\" takes heights alone; leave out first_height, growth, count and total_thickness");
  }
  if (r.heights.empty()) reject("heights: the law \"table\" needs at least one height");
  expect_range(static_cast<double>(r.heights.size()), 1, kMaxCount, "number of heights");
  for (double h : r.heights) expect_length(h, "heights");
  Schedule s{Law::Table, r.heights.front(), 1, static_cast<int>(r.heights.size()), 0, r.heights};
  s.total_thickness = std::accumulate(s.heights.begin(), s.heights.end(), 0.0);
  for (std::size_t k = 1; k < s.heights.size(); ++k) s.growth = std::max(s.growth, s.heights[k] / s.heights[k - 1]);
  return s;
}

}  // namespace

std::string_view law_name(Law law) {
  switch (law) {
    case Law::Geometric:
      return "geometric";
    case Law::Accelerating:
      return "accelerating";
    case Law::Tanh:
      return "tanh";
    case Law::Table:
      break;
  }
  return "table";
}

Schedule solve_schedule(const ScheduleRequest& request) {
  expect_in_range(request);
  if (request.law == Law::Table) return table(request);
  ScheduleRequest r = with_defaults(request);
  const Acceleration acceleration{r.constant_layers, r.acceleration, r.largest_growth};

  if (!r.count) solve_count(r, acceleration);
  if (!r.growth) solve_for_growth(r, acceleration);
  if (!r.first_height)
    r.first_height = *r.total_thickness / relative_thickness(r.law, *r.growth, *r.count, acceleration);

  Schedule s{
      r.law, *r.first_height, *r.growth, *r.count, 0, relative_heights(r.law, *r.growth, *r.count, acceleration)};
  for (double& h : s.heights) h *= s.first_height;
  s.total_thickness = std::accumulate(s.heights.begin(), s.heights.end(), 0.0);
  if (!std::isfinite(s.total_thickness)) reject("the heights overflow; lower growth or count");
  return s;
}

std::vector<double> layer_heights(const ScheduleRequest& request) { return solve_schedule(request).heights; }

double total_thickness(double first_height, double growth, int count) {
  expect_length(first_height, "first_height");
  expect_range(growth, 1, kMaxGrowth, "growth");
  expect_range(count, 1, kMaxCount, "count");
  return first_height * relative_thickness(Law::Geometric, growth, count, {});
}

double growth_ratio(double first_height, int count, double thickness) {
  ScheduleRequest r;
  r.first_height = first_height;
  r.count = count;
  r.total_thickness = thickness;
  expect_in_range(r);
  solve_for_growth(r, {});
  return *r.growth;
}

}  // namespace nearwall::spacing

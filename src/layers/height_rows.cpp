#include "height_rows.h"

#include <algorithm>
#include <cmath>

namespace nearwall::layers {

namespace {

/// Rows between a schedule and its uniform stack. A blend of neighbours makes thickness continuous whatever the number;
/// 32 keep the growth of a blend within 0.1 % of a true power, and 1000 layers at 256 kB.
constexpr int kRowsPerSchedule = 32;

std::vector<double> distances(const std::vector<double>& heights, double exponent) {
  std::vector<double> result{0.0};
  result.reserve(heights.size() + 1);
  const double first = heights.front();
  for (const double h : heights) {
    // A layer thinner than the first keeps its ratio: only what is thicker can give way.
    const double ratio = h / first;
    result.push_back(result.back() + (ratio > 1 ? first * std::pow(ratio, exponent) : h));
  }
  return result;
}

}  // namespace

mesh::Heights ScheduleRows::fit(double limit) const {
  const auto row = [&](std::size_t r) { return static_cast<std::uint32_t>(first + r); };
  if (limit >= thickness.front()) return {row(0), 1.0, 0.0};
  const std::size_t last = thickness.size() - 1;
  if (limit <= thickness[last]) return {row(last), limit / thickness[last], 0.0};
  const auto above = std::partition_point(thickness.begin(), thickness.end(), [&](double t) { return t >= limit; });
  const auto r = static_cast<std::size_t>(above - thickness.begin()) - 1;
  const double weight = (limit - thickness[r + 1]) / (thickness[r] - thickness[r + 1]);
  return {row(r), weight, 1.0 - weight};
}

HeightRows::HeightRows(const std::vector<std::vector<double>>& schedules) {
  for (std::size_t i = 0; i < schedules.size(); ++i) {
    const auto same = std::find(schedules.begin(), schedules.begin() + static_cast<std::ptrdiff_t>(i), schedules[i]);
    const auto k = static_cast<std::size_t>(same - schedules.begin());
    if (k < i) {
      of_schedule_.push_back(of_schedule_[k]);
      continue;
    }
    of_schedule_.push_back(rows_.size());
    add_rows(schedules[i]);
  }
}

void HeightRows::add_rows(const std::vector<double>& heights) {
  ScheduleRows rows;
  rows.first = distances_.size();
  rows.n_levels = static_cast<Level>(heights.size());
  if (!heights.empty()) {
    for (int k = kRowsPerSchedule; k >= 0; --k) {
      std::vector<double> d = distances(heights, double(k) / kRowsPerSchedule);
      if (!rows.thickness.empty() && d.back() >= rows.thickness.back()) break;  // uniform already
      rows.thickness.push_back(d.back());
      distances_.push_back(std::move(d));
    }
  }
  rows_.push_back(std::move(rows));
}

mesh::HeightTable HeightRows::table() const {
  std::size_t n_levels = 0;
  for (const auto& d : distances_) n_levels = std::max(n_levels, d.size());
  std::vector<std::vector<double>> padded = distances_;
  for (auto& d : padded) d.resize(n_levels, d.back());  // levels above a schedule's own are never asked for
  if (padded.empty()) padded.push_back({0.0});
  return mesh::HeightTable(padded);
}

}  // namespace nearwall::layers

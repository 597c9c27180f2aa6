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
  Rows rows;
  rows.begin = distances_.size();
  rows.n_levels = static_cast<Level>(heights.size());
  if (!heights.empty()) {
    for (int k = kRowsPerSchedule; k >= 0; --k) {
      std::vector<double> d = distances(heights, double(k) / kRowsPerSchedule);
      if (distances_.size() > rows.begin && d.back() >= distances_.back().back()) break;  // uniform already
      distances_.push_back(std::move(d));
    }
  }
  rows.end = distances_.size();
  rows_.push_back(rows);
}

mesh::Heights HeightRows::fit(std::size_t schedule, double limit, Level level) const {
  const Rows& rows = rows_of(schedule);
  if (limit >= distances_[rows.begin][level]) return {static_cast<std::uint32_t>(rows.begin), 1.0, 0.0};
  const std::size_t last = rows.end - 1;
  if (limit <= distances_[last][level]) {
    return {static_cast<std::uint32_t>(last), limit / distances_[last][level], 0.0};
  }
  const auto begin = distances_.begin() + static_cast<std::ptrdiff_t>(rows.begin);
  const auto end = distances_.begin() + static_cast<std::ptrdiff_t>(rows.end);
  const auto below = std::partition_point(begin, end, [&](const auto& row) { return row[level] >= limit; });
  const auto above = below - 1;
  const double weight = (limit - (*below)[level]) / ((*above)[level] - (*below)[level]);
  return {static_cast<std::uint32_t>(above - distances_.begin()), weight, 1.0 - weight};
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

#include "stacks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nearwall::layers {

namespace {

/// "auto" and "compress": layers are thinned as long as no height falls below this share of the first one asked.
constexpr double kLeastScale = 0.01;

std::vector<std::vector<double>> heights_of(const IdVector<PatchId, PatchSchedule>& schedules) {
  std::vector<std::vector<double>> heights;
  for (const PatchSchedule& s : schedules) heights.push_back(s.has_layers ? s.heights : std::vector<double>());
  return heights;
}

}  // namespace

Stacks::Stacks(const IdVector<PatchId, PatchSchedule>& schedules) : rows_(heights_of(schedules)) {
  for (const PatchSchedule& s : schedules) {
    Rule rule;
    rule.is_stair = s.on_conflict == OnConflict::Stair;
    rule.least_scale = kLeastScale;
    rule.level_step = s.max_level_step.value_or(std::numeric_limits<Level>::max());
    rule.distances.push_back(0);
    if (s.has_layers) {
      for (const double h : s.heights) rule.distances.push_back(rule.distances.back() + h);
    }
    rules_.push_back(std::move(rule));
  }
}

Stack Stacks::fit(std::uint32_t patch, double limit) const {
  const ScheduleRows& rows = rows_.schedule(patch);
  const Rule& rule = rules_[patch];
  const auto asked = static_cast<std::uint32_t>(rows.first);
  if (!(limit > 0) || rows.n_levels == 0) return {};
  if (limit >= rows.asked_thickness()) return {{asked, 1.0, 0.0}, rows.n_levels, rows.asked_thickness()};
  if (rule.is_stair) {
    const auto above = std::upper_bound(rule.distances.begin(), rule.distances.end(), limit);
    const auto end = static_cast<Level>(above - rule.distances.begin() - 1);
    return {{asked, 1.0, 0.0}, end, rule.distances[end]};
  }
  const double thinnest = rule.least_scale * rows.thickness.back();
  if (limit >= thinnest) return {rows.fit(limit), rows.n_levels, limit};
  const double height = thinnest / rows.n_levels;
  const auto end = static_cast<Level>(std::floor(limit / height));
  return {rows.fit(thinnest), end, height * end};
}

double Stacks::thickness_of(std::uint32_t patch, int levels) const {
  const ScheduleRows& rows = rows_.schedule(patch);
  if (levels >= rows.n_levels) return rows.asked_thickness();
  const Rule& rule = rules_[patch];
  if (rule.is_stair) return rule.distances[static_cast<std::size_t>(levels)];
  return rule.least_scale * rows.thickness.back() * (double(levels) / rows.n_levels);
}

}  // namespace nearwall::layers

#include "stacks.h"

#include <algorithm>
#include <limits>

namespace nearwall::layers {

namespace {

/// "compress": layers are thinned as long as no height falls below this share of the first one asked. "auto" thins
/// without end: docs/theory/layers.md, section 4, has the figures.
constexpr double kLeastScale = 0.01;

/// More levels than any line has.
constexpr int kAnyStep = std::numeric_limits<Level>::max();

std::vector<std::vector<double>> heights_of(const IdVector<PatchId, PatchSchedule>& schedules) {
  std::vector<std::vector<double>> heights;
  for (const PatchSchedule& s : schedules) heights.push_back(s.has_layers ? s.heights : std::vector<double>());
  return heights;
}

}  // namespace

Stacks::Stacks(const IdVector<PatchId, PatchSchedule>& schedules)
    : rows_(heights_of(schedules)), table_(rows_.table()) {
  for (const PatchSchedule& s : schedules) {
    rules_.push_back({s.on_conflict == OnConflict::Stair, s.on_conflict == OnConflict::Compress ? kLeastScale : 0.0,
                      s.max_level_step.value_or(kAnyStep)});
  }
}

bool Stacks::has_level_steps() const {
  return std::any_of(rules_.begin(), rules_.end(), [](const Rule& r) { return r.level_step < kAnyStep; });
}

double Stacks::distance(const mesh::Heights& h, Level level) const {
  return h.weight_1 == 0 ? h.weight_0 * table_.row(h.row)[level]
                         : h.weight_0 * table_.row(h.row)[level] + h.weight_1 * table_.row(h.row + 1)[level];
}

Stack Stacks::fit(std::uint32_t patch, double limit, Level max_level) const {
  const ScheduleRows& rows = rows_.schedule(patch);
  if (!(limit > 0) || rows.n_levels == 0) return {};
  const double asked = rows.asked_thickness(), thinnest = rules_[patch].least_scale * rows.thickness.back();
  const bool is_stair = rules_[patch].is_stair;
  Stack stack;
  stack.heights = rows.fit(is_stair ? asked : std::max(limit, thinnest));
  stack.end = rows.n_levels;
  if (limit < (is_stair ? asked : thinnest)) {
    while (stack.end > 0 && distance(stack.heights, stack.end) > limit) --stack.end;
  }
  if (stack.end <= max_level) {
    // Of a whole stack that was fitted, the limit itself: blending two rows would give it to rounding only.
    stack.thickness = stack.end == rows.n_levels ? std::min(limit, asked) : distance(stack.heights, stack.end);
  } else {
    stack.end = max_level;
    stack.thickness = distance(stack.heights, stack.end);
  }
  return stack;
}

}  // namespace nearwall::layers

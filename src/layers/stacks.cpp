#include "stacks.h"

#include <algorithm>
#include <limits>

namespace nearwall::layers {

namespace {

/// "compress": layers are thinned as long as no height falls below this share of the first one asked. "auto" thins
/// without end: docs/theory/layers.md, section 4, has the figures.
constexpr double kLeastScale = 0.01;

/// Levels by which lines that end where their layers are isotropic step: thickness then changes by one such layer over
/// about one edge.
constexpr int kIsotropicStep = 1;

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
                      s.max_level_step.value_or(s.is_until_isotropic ? kIsotropicStep : kAnyStep)});
  }
}

bool Stacks::has_level_steps() const {
  return std::any_of(rules_.begin(), rules_.end(), [](const Rule& r) { return r.level_step < kAnyStep; });
}

double Stacks::distance(const mesh::Heights& h, Level level) const {
  return h.weight_1 == 0 ? h.weight_0 * table_.row(h.row)[level]
                         : h.weight_0 * table_.row(h.row)[level] + h.weight_1 * table_.row(h.row + 1)[level];
}

mesh::Heights Stacks::heights(const StackRequest& asked, double thickness) const {
  mesh::Heights h = rows_.fit(asked.patch, thickness / asked.scale, asked.levels);
  h.weight_0 *= asked.scale;
  h.weight_1 *= asked.scale;
  return h;
}

double Stacks::first_height(const StackRequest& asked) const {
  return asked.thickness > 0 && asked.levels > 0 ? distance(heights(asked, asked.thickness), 1) : 0.0;
}

Stack Stacks::fit(const StackRequest& asked, double limit, Level max_level) const {
  if (!(limit > 0) || !(asked.thickness > 0) || asked.levels == 0) return {};
  const Rule& rule = rules_[asked.patch];
  const double uniform = asked.scale * rows_.uniform_thickness(asked.patch, asked.levels);
  const double thinnest = rule.is_stair ? asked.thickness : rule.least_scale * std::min(asked.thickness, uniform);
  Stack stack;
  stack.heights = heights(asked, std::clamp(limit, thinnest, asked.thickness));
  stack.end = asked.levels;
  if (limit < thinnest) {
    while (stack.end > 0 && distance(stack.heights, stack.end) > limit) --stack.end;
  }
  if (stack.end <= max_level) {
    // Of a whole stack that was fitted, the limit itself: blending two rows would give it to rounding only.
    stack.thickness = stack.end == asked.levels ? std::min(limit, asked.thickness) : distance(stack.heights, stack.end);
  } else {
    stack.end = max_level;
    stack.thickness = distance(stack.heights, stack.end);
  }
  return stack;
}

}  // namespace nearwall::layers

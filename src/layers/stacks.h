#pragma once

#include <vector>

#include "height_rows.h"
#include "nearwall/layers/grow.h"

namespace nearwall::layers {

/// What a line gets that may be so and so thick.
struct Stack {
  mesh::Heights heights;
  Level end = 0;         ///< last level that the line reaches; 0: it stays at the wall
  double thickness = 0;  ///< of all its layers, at most what was allowed
};

/// The stacks of all patches, and what becomes of each where there is no room for it: layers become thinner, or fewer.
/// Source: docs/theory/layers.md, section 4.
class Stacks {
 public:
  explicit Stacks(const IdVector<PatchId, PatchSchedule>& schedules);

  Level n_levels(std::uint32_t patch) const { return rows_.schedule(patch).n_levels; }
  double asked_thickness(std::uint32_t patch) const { return rows_.schedule(patch).asked_thickness(); }
  const mesh::HeightTable& table() const { return table_; }

  /// \param limit      thickness allowed
  /// \param max_level  last level allowed; heights do not depend on it
  Stack fit(std::uint32_t patch, double limit, Level max_level) const;

  /// Levels by which a line may rise above a neighbour that moves.
  int level_step(std::uint32_t patch) const { return rules_[patch].level_step; }
  /// Whether any patch bounds that.
  bool has_level_steps() const;

 private:
  struct Rule {
    bool is_stair = false;   ///< heights stay as asked, layers go
    double least_scale = 0;  ///< otherwise: no height falls below this share of the first one asked, layers go instead
    int level_step = 0;
  };

  double distance(const mesh::Heights& heights, Level level) const;

  HeightRows rows_;
  mesh::HeightTable table_;
  std::vector<Rule> rules_;
};

}  // namespace nearwall::layers

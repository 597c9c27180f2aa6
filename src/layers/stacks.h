#pragma once

#include <vector>

#include "height_rows.h"
#include "nearwall/layers/grow.h"

namespace nearwall::layers {

/// What a line is asked for: the stack of a patch, all its heights times a scale, up to a level, and no thicker than so
/// much: what is too thick loses growth before it loses first height.
struct StackRequest {
  std::uint32_t patch = 0;
  double scale = 1;
  double thickness = 0;  ///< up to the last level asked for; 0: no layers
  Level levels = 0;
};

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

  Level n_levels(std::uint32_t patch) const { return rows_.n_levels(patch); }
  /// Of the patch's own stack, up to a level.
  double thickness(std::uint32_t patch, Level level) const { return rows_.asked_thickness(patch, level); }
  const mesh::HeightTable& table() const { return table_; }

  /// \param limit      thickness allowed
  /// \param max_level  last level allowed; heights do not depend on it
  Stack fit(const StackRequest& asked, double limit, Level max_level) const;

  /// Height of the first layer of a line that gets all it is asked for; 0 where nothing is asked.
  double first_height(const StackRequest& asked) const;

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
  mesh::Heights heights(const StackRequest& asked, double thickness) const;

  HeightRows rows_;
  mesh::HeightTable table_;
  std::vector<Rule> rules_;
};

}  // namespace nearwall::layers

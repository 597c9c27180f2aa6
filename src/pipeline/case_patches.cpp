#include "pipeline/case_patches.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "pipeline/case_document.h"
#include "pipeline/patch_schedules.h"

namespace nearwall {

namespace {

/// Whether `name` fits `pattern`, in which '*' stands for any run of characters. Linear in most cases: only the last
/// star is ever tried again, one character further.
bool matches(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0, after_star = std::string_view::npos, retry = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      after_star = ++p;
      retry = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p, ++n;
    } else if (after_star != std::string_view::npos) {
      p = after_star;
      n = ++retry;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool is_pattern(const PatchRule& rule) { return rule.pattern.find('*') != std::string::npos; }

int n_quantities(const LayerSettings& s) {
  return int{s.has_first_height()} + int{s.growth.has_value()} + int{s.count.has_value()} +
         int{s.has_total_thickness()};
}

void drop_first_height(LayerSettings& s) { s.first_height.reset(), s.first_height_array.reset(), s.y_plus.reset(); }

void drop_total_thickness(LayerSettings& s) { s.total_thickness.reset(), s.total_thickness_array.reset(); }

/// Takes over what `over` gives; what is inherited gives way where both together would be too much.
LayerSettings merged(LayerSettings base, const LayerSettings& over) {
  if (n_quantities(over) > 0 && !base.heights.empty() && over.heights.empty()) base.heights.clear(), base.law.reset();
  if (!over.heights.empty()) {
    drop_first_height(base), drop_total_thickness(base);
    base.growth.reset(), base.count.reset(), base.law.reset();
  }
  if (over.has_first_height()) drop_first_height(base);
  if (over.has_total_thickness()) drop_total_thickness(base);
  if (over.until == Until::Isotropic) drop_total_thickness(base);
  const auto take = [](auto& to, const auto& from) {
    if (from) to = from;
  };
  take(base.first_height, over.first_height);
  take(base.first_height_array, over.first_height_array);
  take(base.y_plus, over.y_plus);
  take(base.growth, over.growth);
  take(base.count, over.count);
  take(base.total_thickness, over.total_thickness);
  take(base.total_thickness_array, over.total_thickness_array);
  take(base.until, over.until);
  take(base.law, over.law);
  take(base.constant_layers, over.constant_layers);
  take(base.acceleration, over.acceleration);
  take(base.largest_growth, over.largest_growth);
  take(base.on_conflict, over.on_conflict);
  take(base.max_level_step, over.max_level_step);
  take(base.min_coverage, over.min_coverage);
  if (!over.heights.empty()) base.heights = over.heights;
  if (!over.where.empty()) base.where = over.where;

  if (n_quantities(over) < 4 && n_quantities(base) == 4) {
    if (!over.growth) {
      base.growth.reset();
    } else if (!over.count) {
      base.count.reset();
    } else if (!over.has_total_thickness()) {
      drop_total_thickness(base);
    } else {
      drop_first_height(base);
    }
  }
  return base;
}

/// A thickness and an `until` that is inherited: neither is meant less than the other.
void check_until(const LayerSettings& base, const PatchRule& rule) {
  if (base.until != Until::Isotropic || rule.layers.until || !rule.layers.has_total_thickness()) return;
  throw InputError(
      fmt::format("{}: patches.{}: total_thickness and until = \"isotropic\", which is inherited, exclude each other; "
                  "add until = \"count\" here, or leave total_thickness out",
                  rule.layers.where, pipeline::quoted_key(rule.pattern)));
}

bool has_heights(const LayerSettings& s) {
  return s.has_first_height() || s.has_total_thickness() || !s.heights.empty();
}

[[noreturn]] void reject_rule(const PatchRule& rule, std::span<const std::string> patch_names) {
  const std::vector<std::string> names(patch_names.begin(), patch_names.end());
  const std::string near = nearest(rule.pattern, names);
  throw InputError(fmt::format("{}: patches.{}: no patch of the surface has this name; {}", rule.where,
                               pipeline::quoted_key(rule.pattern),
                               near.empty() ? fmt::format("its patches are \"{}\"", fmt::join(names, "\", \""))
                                            : fmt::format("nearest: \"{}\"", near)));
}

}  // namespace

spacing::Law LayerSettings::law_in_force() const {
  return law.value_or(heights.empty() ? spacing::Law::Geometric : spacing::Law::Table);
}

namespace pipeline {

void check_heights(const Case& settings) {
  const bool any =
      has_heights(settings.layers) || std::any_of(settings.patches.begin(), settings.patches.end(),
                                                  [](const PatchRule& rule) { return has_heights(rule.layers); });
  if (!any) {
    const std::string place = settings.layers.where.empty() ? settings.file.string() : settings.layers.where;
    const auto is_until = [](const LayerSettings& layers) { return layers.until == Until::Isotropic; };
    const bool is_isotropic =
        is_until(settings.layers) || std::any_of(settings.patches.begin(), settings.patches.end(),
                                                 [&](const PatchRule& rule) { return is_until(rule.layers); });
    throw InputError(fmt::format("{}: layers: the heights are missing: give first_height (or y_plus with [flow]){}",
                                 place, is_isotropic ? ", which until = \"isotropic\" needs" : " or total_thickness"));
  }
  if (has_heights(settings.layers)) check_schedule(settings, settings.layers, "layers");
}

/// Names of the patches that a run may make itself: a rule for them need match none of the file's.
bool may_be_made(const Case& settings, const std::string& pattern) {
  if (settings.volume.fill == Fill::None && settings.volume.symmetry.empty()) return false;
  for (const char* stem : {"farfield", "symmetry"}) {
    if (pattern == stem || pattern.starts_with(std::string(stem) + "-")) return true;
  }
  return false;
}

std::vector<PatchLayers> settings_of_patches(const Case& settings, std::span<const std::string> patch_names) {
  for (const PatchRule& rule : settings.patches) {
    const bool is_used = rule.pattern == "*" || may_be_made(settings, rule.pattern) ||
                         std::any_of(patch_names.begin(), patch_names.end(),
                                     [&](const auto& name) { return matches(rule.pattern, name); });
    if (!is_used) reject_rule(rule, patch_names);
  }
  std::vector<PatchLayers> patches;
  for (const std::string& name : patch_names) {
    PatchLayers& patch = patches.emplace_back();
    patch.layers = settings.layers;
    for (const bool exact : {false, true}) {
      for (const PatchRule& rule : settings.patches) {
        if (is_pattern(rule) == exact || !matches(rule.pattern, name)) continue;
        patch.type = rule.type.value_or(patch.type);
        if (has_layers(patch.type)) check_until(patch.layers, rule);
        patch.layers = merged(patch.layers, rule.layers);
      }
    }
  }
  return patches;
}

}  // namespace pipeline

std::vector<PatchType> patch_types(const Case& settings, std::span<const std::string> patch_names) {
  std::vector<PatchType> types;
  for (const pipeline::PatchLayers& patch : pipeline::settings_of_patches(settings, patch_names)) {
    types.push_back(patch.type);
  }
  return types;
}

}  // namespace nearwall

#include "pipeline/case_patches.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"

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
  return int{s.first_height || s.y_plus} + int{s.growth.has_value()} + int{s.count.has_value()} +
         int{s.total_thickness.has_value()};
}

/// Takes over what `over` gives; what is inherited gives way where both together would be too much.
LayerSettings merged(LayerSettings base, const LayerSettings& over) {
  if (n_quantities(over) > 0 && !base.heights.empty() && over.heights.empty()) base.heights.clear(), base.law.reset();
  if (!over.heights.empty()) {
    base.first_height.reset(), base.y_plus.reset(), base.growth.reset(), base.count.reset(),
        base.total_thickness.reset();
    base.law.reset();
  }
  if (over.first_height || over.y_plus) base.first_height.reset(), base.y_plus.reset();
  const auto take = [](auto& to, const auto& from) {
    if (from) to = from;
  };
  take(base.first_height, over.first_height);
  take(base.y_plus, over.y_plus);
  take(base.growth, over.growth);
  take(base.count, over.count);
  take(base.total_thickness, over.total_thickness);
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
    } else if (!over.total_thickness) {
      base.total_thickness.reset();
    } else {
      base.first_height.reset(), base.y_plus.reset();
    }
  }
  return base;
}

bool has_heights(const LayerSettings& s) {
  return s.first_height || s.y_plus || s.total_thickness || !s.heights.empty();
}

void check_flow(const Case& settings) {
  const auto& flow = settings.flow;
  std::vector<std::string> missing;
  if (!flow || flow->velocity == 0) missing.emplace_back("velocity");
  if (!flow || flow->kinematic_viscosity == 0) missing.emplace_back("kinematic_viscosity");
  if (!flow || flow->reference_length == 0) missing.emplace_back("reference_length");
  if (!missing.empty()) {
    throw InputError(
        fmt::format("y_plus needs [flow] with velocity, kinematic_viscosity and reference_length; missing: {}",
                    fmt::join(missing, ", ")));
  }
}

spacing::Schedule schedule_of(const Case& settings, const LayerSettings& s) {
  spacing::ScheduleRequest request;
  request.law = s.law_in_force();
  request.first_height = s.first_height;
  if (s.y_plus) {
    if (s.first_height) throw InputError("first_height and y_plus exclude each other; leave out one");
    check_flow(settings);
    request.first_height = spacing::first_cell_height(*settings.flow, *s.y_plus);
  }
  request.growth = s.growth;
  request.count = s.count;
  request.total_thickness = s.total_thickness;
  request.heights = s.heights;
  const bool has_acceleration = s.constant_layers || s.acceleration || s.largest_growth;
  if (has_acceleration && request.law != spacing::Law::Accelerating) {
    throw InputError(
        fmt::format("constant_layers, acceleration and largest_growth are for the law \"accelerating\", the law "
                    "is \"{}\"",
                    law_name(request.law)));
  }
  request.constant_layers = s.constant_layers.value_or(request.constant_layers);
  request.acceleration = s.acceleration.value_or(request.acceleration);
  request.largest_growth = s.largest_growth.value_or(request.largest_growth);
  return spacing::solve_schedule(request);
}

/// Adds the place to what the schedule says.
spacing::Schedule schedule_at(const Case& settings, const LayerSettings& s, const std::string& table) {
  try {
    return schedule_of(settings, s);
  } catch (const InputError& e) {
    const std::string place = s.where.empty() ? settings.file.string() : s.where;
    throw InputError(fmt::format("{}: {}: {}", place, table, e.what()));
  }
}

[[noreturn]] void reject_rule(const PatchRule& rule, std::span<const std::string> patch_names) {
  const std::vector<std::string> names(patch_names.begin(), patch_names.end());
  const std::string near = nearest(rule.pattern, names);
  throw InputError(fmt::format("{}: patches.{}: no patch of the surface has this name; {}", rule.where, rule.pattern,
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
    throw InputError(
        fmt::format("{}: layers: the heights are missing: give first_height (or y_plus with [flow]) or "
                    "total_thickness",
                    place));
  }
  if (has_heights(settings.layers)) schedule_at(settings, settings.layers, "layers");
}

}  // namespace pipeline

std::vector<PatchSettings> resolve_patches(const Case& settings, std::span<const std::string> patch_names) {
  for (const PatchRule& rule : settings.patches) {
    const bool is_used =
        rule.pattern == "*" || std::any_of(patch_names.begin(), patch_names.end(),
                                           [&](const auto& name) { return matches(rule.pattern, name); });
    if (!is_used) reject_rule(rule, patch_names);
  }
  std::vector<PatchSettings> patches;
  for (const std::string& name : patch_names) {
    PatchSettings patch;
    LayerSettings layers = settings.layers;
    for (const bool exact : {false, true}) {
      for (const PatchRule& rule : settings.patches) {
        if (is_pattern(rule) == exact || !matches(rule.pattern, name)) continue;
        layers = merged(layers, rule.layers);
        patch.type = rule.type.value_or(patch.type);
      }
    }
    if (patch.type == PatchType::Wall) {
      patch.schedule = schedule_at(settings, layers, fmt::format("layers of patch \"{}\"", name));
      patch.min_coverage = layers.min_coverage.value_or(0);
      patch.on_conflict = layers.on_conflict.value_or(OnConflict::Auto);
      if (layers.max_level_step.value_or(0) > 0) patch.max_level_step = layers.max_level_step;
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

}  // namespace nearwall

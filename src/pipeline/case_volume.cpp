#include "pipeline/case_volume.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "pipeline/case_values.h"

namespace nearwall::pipeline {

namespace {

int checked_axis(const Entry& entry) {
  const Key axis = {.kind = Kind::Choice, .choices = {"x", "y", "z"}};
  return static_cast<int>(kAxisNames.find(std::get<std::string>(checked_value(entry, axis))));
}

/// { axis = "y", at = 0.0 }
SymmetrySetting plane_of_table(const std::vector<Entry>& keys, const Entry& entry) {
  SymmetrySetting plane;
  bool has_axis = false;
  for (const Entry& key : keys) {
    const std::string& name = key.path.back();
    if (name == "axis") {
      plane.axis = checked_axis(key);
      has_axis = true;
    } else if (name == "at") {
      plane.at = checked_number(key, {.kind = Kind::Number, .unit = "length"});
    } else {
      const std::string near = nearest(name, std::vector<std::string>{"axis", "at"});
      throw InputError(fmt::format("{}: {}: unknown key; {}", key.key_place, name_of(key),
                                   near.empty() ? "a plane takes axis, at" : "nearest: " + near));
    }
  }
  if (!has_axis) {
    throw InputError(fmt::format("{}: {}.axis: missing: \"x\", \"y\" or \"z\", the axis that the plane is across",
                                 entry.key_place, name_of(entry)));
  }
  return plane;
}

SymmetrySetting plane_of(const Entry& item, const Key& key) {
  if (item.is_table) return plane_of_table(item.items, item);
  if (!std::holds_alternative<std::string>(item.value)) reject_value(item, key);
  return {checked_axis(item), std::nullopt};
}

/// Looks up where the keys of [volume] stand.
class VolumeCheck {
 public:
  VolumeCheck(const Case& settings, std::span<const Entry> entries) : settings_(settings), entries_(entries) {}

  void check() const {
    check_given();
    check_box();
    check_planes();
  }

 private:
  using Path = std::vector<std::string>;

  [[noreturn]] void reject(const Path& path, const std::string& what) const {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.path == path; });
    throw InputError(fmt::format("{}: {}: {}", found == entries_.end() ? settings_.file.string() : found->key_place,
                                 fmt::join(path, "."), what));
  }
  [[noreturn]] void reject_far_field(const char* key, const std::string& what) const {
    reject({"volume", "farfield", key}, what);
  }

  /// That only one of what says the same is there.
  void demand_none(std::initializer_list<std::pair<const char*, bool>> keys, const std::string& why) const {
    for (const auto& [key, is_there] : keys) {
      if (is_there) reject_far_field(key, why);
    }
  }

  void check_given() const {
    const bool is_inside = settings_.surface.fluid == surface::FluidSide::Inside;
    if (far_field_.shape == FarFieldShape::Given) {
      if (!is_inside) {
        reject_far_field("shape",
                         "\"given\" needs fluid = \"inside\" in [surface]: the outer boundary is a part of "
                         "the surface, and the fluid lies inside of that");
      }
      const bool is_there = std::any_of(settings_.patches.begin(), settings_.patches.end(),
                                        [](const PatchRule& rule) { return rule.type == PatchType::FarField; });
      if (!is_there) {
        reject_far_field("shape",
                         "\"given\" needs the patch of the surface that is the outer boundary: "
                         "[patches.NAME] with type = \"farfield\"");
      }
    }
    if (!is_inside) return;
    demand_none({{"radius", far_field_.radius.has_value()},
                 {"size", far_field_.size.has_value()},
                 {"centre", far_field_.centre.has_value()},
                 {"lower", far_field_.lower.has_value()},
                 {"upper", far_field_.upper.has_value()}},
                "no far field is made where the fluid lies inside of the surface, which is the outer boundary then; "
                "leave it out");
  }

  void check_box() const {
    const auto &lower = far_field_.lower, &upper = far_field_.upper;
    if (!lower && !upper) return;
    if (far_field_.shape != FarFieldShape::Box) {
      reject_far_field(lower ? "lower" : "upper", "for shape = \"box\" alone; a sphere has radius and centre");
    }
    if (!upper) reject_far_field("lower", "upper is missing: a box needs both corners, or radius");
    if (!lower) reject_far_field("upper", "lower is missing: a box needs both corners, or radius");
    demand_none({{"radius", far_field_.radius.has_value()}, {"centre", far_field_.centre.has_value()}},
                "lower and upper determine the box; leave one or the other out");
    for (int axis = 0; axis < 3; ++axis) {
      if ((*lower)[axis] < (*upper)[axis]) continue;
      reject_far_field("lower",
                       fmt::format("expected less than upper along every axis, found {} = {} to {}",
                                   kAxisNames[static_cast<std::size_t>(axis)], (*lower)[axis], (*upper)[axis]));
    }
  }

  void check_planes() const {
    const auto& planes = settings_.volume.symmetry;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (planes[i].axis != planes[j].axis || (planes[i].at && planes[j].at && planes[i].at != planes[j].at))
          continue;
        reject({"volume", "symmetry"}, fmt::format("two planes across \"{}\" need an `at` each, and not the same one",
                                                   kAxisNames[static_cast<std::size_t>(planes[i].axis)]));
      }
    }
  }

  const Case& settings_;
  const FarFieldSettings& far_field_ = settings_.volume.far_field;
  std::span<const Entry> entries_;
};

}  // namespace

std::vector<SymmetrySetting> checked_planes(const Entry& entry, const Key& key) {
  if (std::holds_alternative<std::string>(entry.value)) return {plane_of(entry, key)};
  const auto* texts = std::get_if<std::vector<std::string>>(&entry.value);
  if (entry.items.empty() && !texts) reject_value(entry, key);
  std::vector<SymmetrySetting> planes;
  for (const Entry& item : entry.items) planes.push_back(plane_of(item, key));
  return planes;
}

void check_volume(const Case& settings, std::span<const Entry> entries) { VolumeCheck(settings, entries).check(); }

}  // namespace nearwall::pipeline

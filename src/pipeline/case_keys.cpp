#include "pipeline/case_keys.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace nearwall::pipeline {

const std::vector<std::string_view>& case_tables() {
  static const std::vector<std::string_view> tables = {"",        "surface",         "patches", "features",
                                                       "normals", "smoothing",       "layers",  "flow",
                                                       "volume",  "volume.farfield", "output"};
  return tables;
}

const std::vector<Key>& case_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    for (const auto& part : {general_keys(), layer_keys(), volume_keys()})
      all.insert(all.end(), part.begin(), part.end());
    const auto place = [](const Key& key) {
      const auto& tables = case_tables();
      return std::find(tables.begin(), tables.end(), key.table) - tables.begin();
    };
    std::stable_sort(all.begin(), all.end(), [&](const Key& a, const Key& b) { return place(a) < place(b); });
    return all;
  }();
  return keys;
}

const Key* find_key(std::string_view table, std::string_view name) {
  for (const Key& key : case_keys()) {
    if (key.table == table && key.name == name) return &key;
  }
  return nullptr;
}

std::string dotted(const Key& key) {
  if (key.table == "patches") return fmt::format("patches.NAME.{}", key.name);
  return key.table.empty() ? std::string(key.name) : fmt::format("{}.{}", key.table, key.name);
}

namespace {

std::string allowed_numbers(const Key& key, std::string_view noun) {
  const Range& r = key.range;
  const bool has_low = std::isfinite(r.low), has_high = std::isfinite(r.high);
  if (has_low && has_high) {
    if (r.low == r.high) return fmt::format("{}", r.low);
    if (r.is_low_open) return fmt::format("{} above {}, at most {}", noun, r.low, r.high);
    return fmt::format("{} from {} to {}", noun, r.low, r.high);
  }
  if (has_low) return fmt::format("{} {} {}", noun, r.is_low_open ? "above" : "of at least", r.low);
  return std::string(noun);
}

}  // namespace

std::string allowed(const Key& key) {
  std::string phrase;
  switch (key.kind) {
    case Kind::Number:
      phrase = allowed_numbers(key, "a number");
      break;
    case Kind::Integer:
      phrase = allowed_numbers(key, "an integer");
      break;
    case Kind::Boolean:
      return key.takes_auto ? "\"auto\" or false" : "true or false";
    case Kind::Text:
      return "a text in quotes";
    case Kind::Choice:
      return fmt::format("\"{}\"", fmt::join(key.choices, "\", \""));
    case Kind::Choices:
      return fmt::format("a list of \"{}\"", fmt::join(key.choices, "\", \""));
    case Kind::Numbers:
      phrase = fmt::format("a list, [h1, h2, …], each {}", allowed_numbers(key, "a number"));
      break;
    case Kind::Point:
      phrase = "a list [x, y, z] of numbers";
      break;
    case Kind::Planes:
      return "a list of \"x\", \"y\", \"z\" or { axis = \"y\", at = 0.0 }";
  }
  if (!key.unit.empty()) phrase += fmt::format(" ({})", key.unit);
  if (key.takes_auto) phrase += " or \"auto\"";
  if (key.array) phrase += " or { array = \"NAME\" }";
  return phrase;
}

}  // namespace nearwall::pipeline

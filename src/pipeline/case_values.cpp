#include "pipeline/case_values.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "pipeline/case_volume.h"

namespace nearwall::pipeline {

namespace {

void check_range(const Entry& entry, const Key& key, double value) {
  const Range& r = key.range;
  const bool is_inside = std::isfinite(value) && value <= r.high && (r.is_low_open ? value > r.low : value >= r.low);
  if (!is_inside) reject_value(entry, key);
}

void check_choice(const Entry& entry, const Key& key, const std::string& value) {
  if (std::find(key.choices.begin(), key.choices.end(), value) != key.choices.end()) return;
  if (std::find(key.later.begin(), key.later.end(), value) != key.later.end()) {
    throw InputError(fmt::format("{}: {}: \"{}\" is not in this version; expected {}", entry.value_place,
                                 name_of(entry), value, allowed(key)));
  }
  const std::vector<std::string> choices(key.choices.begin(), key.choices.end());
  const std::string near = nearest(value, choices);
  reject_value(entry, key, near.empty() ? "" : fmt::format("; nearest: \"{}\"", near));
}

/// A number typed with its unit, or a text where a number belongs.
std::string unit_advice(const Key& key) {
  if (key.unit.empty()) return "; write a plain number without quotes";
  if (key.unit == "degrees") return "; angles are plain numbers in degrees";
  return fmt::format("; write a plain number without quotes: {} in the scaled unit of the surface", key.unit);
}

}  // namespace

[[noreturn]] void reject_value(const Entry& entry, const Key& key, std::string_view more) {
  throw InputError(fmt::format("{}: {}: expected {}, found {}{}", entry.value_place, name_of(entry), allowed(key),
                               entry.found, more));
}

double checked_number(const Entry& entry, const Key& key) {
  double value = 0;
  if (const auto* v = std::get_if<double>(&entry.value)) {
    value = *v;
  } else if (const auto* i = std::get_if<std::int64_t>(&entry.value)) {
    value = static_cast<double>(*i);
  } else {
    reject_value(entry, key, std::holds_alternative<std::string>(entry.value) ? unit_advice(key) : "");
  }
  check_range(entry, key, value);
  return value;
}

namespace {

CaseValue checked_integer(const Entry& entry, const Key& key) {
  const auto* value = std::get_if<std::int64_t>(&entry.value);
  if (!value) reject_value(entry, key);
  check_range(entry, key, static_cast<double>(*value));
  return *value;
}

/// Three numbers.
CaseValue checked_point(const Entry& entry, const Key& key) {
  const auto* numbers = std::get_if<std::vector<double>>(&entry.value);
  if (!numbers || numbers->size() != 3) reject_value(entry, key);
  for (const double number : *numbers) check_range(entry, key, number);
  return *numbers;
}

CaseValue checked_list(const Entry& entry, const Key& key) {
  if (key.kind == Kind::Choices) {
    const auto* texts = std::get_if<std::vector<std::string>>(&entry.value);
    if (!texts || texts->empty()) reject_value(entry, key);
    for (const std::string& text : *texts) check_choice(entry, key, text);
    return *texts;
  }
  const auto* numbers = std::get_if<std::vector<double>>(&entry.value);
  if (!numbers || numbers->empty()) reject_value(entry, key);
  for (const double number : *numbers) check_range(entry, key, number);
  return *numbers;
}

}  // namespace

CaseValue checked_value(const Entry& entry, const Key& key) {
  const auto* text = std::get_if<std::string>(&entry.value);
  if (key.takes_auto && text && *text == kAuto) return *text;
  switch (key.kind) {
    case Kind::Number:
      return checked_number(entry, key);
    case Kind::Integer:
      return checked_integer(entry, key);
    case Kind::Boolean:
      if (!std::holds_alternative<bool>(entry.value)) reject_value(entry, key);
      return entry.value;
    case Kind::Text:
    case Kind::Choice:
      if (!text) reject_value(entry, key);
      if (text->empty()) reject_value(entry, key, ", which is empty");
      if (key.kind == Kind::Choice) check_choice(entry, key, *text);
      return *text;
    case Kind::Point:
      return checked_point(entry, key);
    case Kind::Planes:
      return checked_planes(entry, key);
    case Kind::Choices:
    case Kind::Numbers:
      break;
  }
  return checked_list(entry, key);
}

}  // namespace nearwall::pipeline

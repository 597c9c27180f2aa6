#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "nearwall/pipeline/case.h"
#include "pipeline/case_document.h"
#include "pipeline/case_keys.h"
#include "pipeline/case_patches.h"

namespace nearwall {

namespace {

using namespace pipeline;

constexpr std::string_view kPatches = "patches";

std::string join(const std::vector<std::string>& path) { return fmt::format("{}", fmt::join(path, ".")); }

std::vector<std::string> names_in(std::string_view table) {
  std::vector<std::string> names;
  for (const Key& key : case_keys()) {
    if (key.table == table || (table == kPatches && key.table == "layers")) names.emplace_back(key.name);
  }
  return names;
}

/// "; did you mean …" for a key that is not known in its table.
std::string advice(std::string_view table, const std::string& name) {
  const std::vector<std::string> names = names_in(table);
  if (const std::string near = nearest(name, names); !near.empty()) return fmt::format("; nearest: {}", near);
  for (const Key& key : case_keys()) {
    if (key.name == name) return fmt::format("; nearest: {}", dotted(key));
  }
  std::vector<std::string> all;
  for (const Key& key : case_keys()) all.push_back(dotted(key));
  if (const std::string near = nearest(name, all); !near.empty()) return fmt::format("; nearest: {}", near);
  if (names.empty()) return "";
  return fmt::format("; keys of {} are {}", table.empty() ? "the top level" : fmt::format("[{}]", table),
                     fmt::join(names, ", "));
}

bool is_table_name(std::string_view name) {
  const auto& tables = case_tables();
  return std::find(tables.begin(), tables.end(), name) != tables.end();
}

[[noreturn]] void reject_unknown_table(const Entry& entry) {
  std::vector<std::string> tables;
  for (const auto table : case_tables()) {
    if (!table.empty()) tables.emplace_back(table);
  }
  const std::string near = nearest(join(entry.path), tables);
  throw InputError(fmt::format(
      "{}: {}: unknown table{}", entry.key_place, join(entry.path),
      near.empty() ? fmt::format("; tables are {}", fmt::join(tables, ", ")) : fmt::format("; nearest: [{}]", near)));
}

[[noreturn]] void reject_value(const Entry& entry, const Key& key, std::string_view more = "") {
  throw InputError(fmt::format("{}: {}: expected {}, found {}{}", entry.value_place, join(entry.path), allowed(key),
                               entry.found, more));
}

[[noreturn]] void reject_as_later(const Entry& entry) {
  throw InputError(fmt::format("{}: {}: {} is not in this version", entry.value_place, join(entry.path), entry.found));
}

void check_range(const Entry& entry, const Key& key, double value) {
  const Range& r = key.range;
  const bool is_inside = std::isfinite(value) && value <= r.high && (r.is_low_open ? value > r.low : value >= r.low);
  if (!is_inside) reject_value(entry, key);
}

void check_choice(const Entry& entry, const Key& key, const std::string& value) {
  if (std::find(key.choices.begin(), key.choices.end(), value) != key.choices.end()) return;
  if (std::find(key.later.begin(), key.later.end(), value) != key.later.end()) {
    throw InputError(fmt::format("{}: {}: \"{}\" is not in this version; expected {}", entry.value_place,
                                 join(entry.path), value, allowed(key)));
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

CaseValue checked_number(const Entry& entry, const Key& key) {
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

CaseValue checked_integer(const Entry& entry, const Key& key) {
  const auto* value = std::get_if<std::int64_t>(&entry.value);
  if (!value) reject_value(entry, key);
  check_range(entry, key, static_cast<double>(*value));
  return *value;
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

/// The value in the type of its key. \throws InputError
CaseValue checked(const Entry& entry, const Key& key) {
  if (key.is_later && entry.found != key.default_text && key.kind != Kind::Choice && key.kind != Kind::Number) {
    reject_as_later(entry);
  }
  const auto* text = std::get_if<std::string>(&entry.value);
  if (key.takes_auto && text && *text == kAuto) return *text;
  if (key.is_later && key.kind == Kind::Number) {
    if (key.takes_auto) reject_as_later(entry);
    const CaseValue number = checked_number(entry, key);
    if (std::get<double>(number) != std::stod(std::string(key.default_text))) reject_as_later(entry);
    return number;
  }
  switch (key.kind) {
    case Kind::Number:
      return checked_number(entry, key);
    case Kind::Integer:
      return checked_integer(entry, key);
    case Kind::Boolean:
      if (!std::holds_alternative<bool>(entry.value)) reject_value(entry, key);
      if (std::get<bool>(entry.value) && !key.later.empty()) reject_as_later(entry);
      return entry.value;
    case Kind::Text:
    case Kind::Choice:
      if (!text) reject_value(entry, key);
      if (text->empty()) reject_value(entry, key, ", which is empty");
      if (key.kind == Kind::Choice) check_choice(entry, key, *text);
      return *text;
    case Kind::Choices:
    case Kind::Numbers:
      break;
  }
  return checked_list(entry, key);
}

PatchRule& rule_for(Case& settings, const Entry& entry) {
  for (PatchRule& rule : settings.patches) {
    if (rule.pattern == entry.path[1]) return rule;
  }
  PatchRule& rule = settings.patches.emplace_back();
  rule.pattern = entry.path[1];
  rule.where = entry.key_place;
  return rule;
}

/// The key of [layers] or of a patch that may be a point array; null if the path names no such key.
const Key* find_length(std::span<const std::string> path) {
  const bool is_in_layers = path.size() == 2 && path.front() == "layers";
  const bool is_of_patch = path.size() == 3 && path.front() == kPatches;
  const Key* key = is_in_layers || is_of_patch ? find_key("layers", path.back()) : nullptr;
  return key && key->array ? key : nullptr;
}

/// That of which an entry is the array or the factor; null if it is neither.
const Key* length_of_part(const Entry& entry) {
  return find_length(std::span(entry.path).first(entry.path.size() - 1));
}

/// Layers that an entry below [layers] or [patches.NAME] belongs to.
LayerSettings& layers_for(Case& settings, const Entry& entry) {
  LayerSettings& layers = entry.path.front() == kPatches ? rule_for(settings, entry).layers : settings.layers;
  if (layers.where.empty()) layers.where = entry.key_place;
  return layers;
}

/// "array" or "factor" of a length.
void read_length_part(Case& settings, const Entry& entry, const Key& key) {
  ArrayLength& length = key.array(layers_for(settings, entry));
  const std::string& part = entry.path.back();
  if (part == "array") {
    const auto* name = std::get_if<std::string>(&entry.value);
    if (!name || name->empty()) {
      throw InputError(fmt::format("{}: {}: expected the name of a point array of the surface file in quotes, found {}",
                                   entry.value_place, join(entry.path), entry.found));
    }
    length.array = *name;
  } else if (part == "factor") {
    const Key factor = {.kind = Kind::Number, .range = key.range};
    length.factor = std::get<double>(checked_number(entry, factor));
  } else {
    throw InputError(fmt::format("{}: {}: unknown key; a length from an array takes array, factor", entry.key_place,
                                 join(entry.path)));
  }
}

/// A length that is a table needs an array in it.
void check_lengths_have_arrays(const std::vector<Entry>& entries) {
  for (const Entry& entry : entries) {
    std::vector<std::string> wanted = entry.path;
    if (length_of_part(entry)) {
      wanted.back() = "array";
    } else if (entry.is_table && find_length(entry.path)) {
      wanted.emplace_back("array");
    } else {
      continue;
    }
    if (std::any_of(entries.begin(), entries.end(), [&](const Entry& e) { return e.path == wanted; })) continue;
    throw InputError(
        fmt::format("{}: {}: missing: the name of a point array of the surface file", entry.key_place, join(wanted)));
  }
}

void read_table(Case& settings, const Entry& entry) {
  if (entry.path.front() == kPatches && entry.path.size() <= 2) {
    if (entry.path.size() == 2) rule_for(settings, entry);
    return;
  }
  if (is_table_name(join(entry.path))) return;
  std::string table = join({entry.path.begin(), entry.path.end() - 1});
  if (entry.path.front() == kPatches) table = entry.path.size() == 3 ? kPatches : "";
  const Key* key = find_key(table, entry.path.back());
  if (!key && table == kPatches) key = find_key("layers", entry.path.back());
  if (key && key->array) {
    layers_for(settings, entry);  // their first key may be this one
    return;
  }
  if (key) reject_value(entry, *key);
  reject_unknown_table(entry);
}

void read_value(Case& settings, const Entry& entry) {
  const std::vector<std::string>& path = entry.path;
  const std::string& name = path.back();
  if (is_table_name(join(path)) || (path.front() == kPatches && path.size() == 2)) {
    throw InputError(fmt::format("{}: {}: expected a table, found {}", entry.value_place, join(path), entry.found));
  }
  if (const Key* length = length_of_part(entry)) return read_length_part(settings, entry, *length);
  const bool is_of_patch = path.front() == kPatches && path.size() == 3;
  const std::string table = is_of_patch ? std::string(kPatches) : join({path.begin(), path.end() - 1});
  if (!is_of_patch && !is_table_name(table)) reject_unknown_table(entry);
  const Key* key = find_key(table, name);
  if (!key && is_of_patch) key = find_key("layers", name);
  if (!key || (table == kPatches && !is_of_patch)) {
    throw InputError(fmt::format("{}: {}: unknown key{}", entry.key_place, join(path), advice(table, name)));
  }
  const CaseValue value = checked(entry, *key);
  if (!key->set) return;
  PatchRule* rule = is_of_patch ? &rule_for(settings, entry) : nullptr;
  LayerSettings& layers = rule ? rule->layers : settings.layers;
  if (key->table == "layers" && layers.where.empty()) layers.where = entry.key_place;
  key->set({settings, layers, rule}, value);
}

/// Puts the overrides in the place of what they override; new ones come last.
void apply_overrides(std::vector<Entry>& entries, std::span<const std::string> overrides) {
  for (const std::string& text : overrides) {
    const Entry entry = read_override(text);
    std::erase_if(entries, [&](const Entry& old) { return !old.is_table && old.path == entry.path; });
    entries.push_back(entry);
  }
}

void check_name(const Case& settings, const std::filesystem::path& file) {
  const std::string name = settings.output_name();
  const bool is_good = !name.empty() && name.front() != '.' && name.front() != '-' &&
                       std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == '/'; });
  if (!is_good) {
    throw InputError(
        fmt::format("{}: name: expected a text that can begin a file name, found \"{}\"", file.string(), name));
  }
}

}  // namespace

Case parse_case(const std::string& text, const std::filesystem::path& file, std::span<const std::string> overrides) {
  std::vector<Entry> entries = read_document(text, file);
  apply_overrides(entries, overrides);
  Case settings;
  settings.file = file;
  for (const Entry& entry : entries) entry.is_table ? read_table(settings, entry) : read_value(settings, entry);
  check_lengths_have_arrays(entries);
  if (settings.surface.file.empty()) {
    throw InputError(
        fmt::format("{}: surface.file: missing: the surface to mesh, relative to this file", file.string()));
  }
  check_name(settings, file);
  check_heights(settings);
  return settings;
}

Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InputError(fmt::format("{}: no such case file", file.string()));
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(fmt::format("{}: expected a case file, found a folder", file.string()));
  }
  std::ifstream in(file, std::ios::binary);
  // Not `<< in.rdbuf()`, which calls an empty file a failure.
  const std::string text(std::istreambuf_iterator<char>(in), {});
  if (!in) throw IoError(fmt::format("{}: cannot be read", file.string()));
  return parse_case(text, file, overrides);
}

Case read_case(const std::filesystem::path& file) { return read_case(file, {}); }

}  // namespace nearwall

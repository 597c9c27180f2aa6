#include <algorithm>
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
#include "pipeline/case_values.h"
#include "pipeline/case_volume.h"

namespace nearwall {

namespace {

using namespace pipeline;

constexpr std::string_view kPatches = "patches";

std::string join(std::span<const std::string> path) { return fmt::format("{}", fmt::join(path, ".")); }

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

/// The table of an entry's first `n` names as keys are looked up: "patches" for patches.NAME.
std::string table_of(const Entry& entry, std::size_t n) {
  if (entry.path.front() == kPatches && n == 2) return std::string(kPatches);
  return join(std::span(entry.path).first(n));
}

/// Refuses an entry of which a table is none: a mistyped one, or a mistyped key with a table behind it.
[[noreturn]] void reject_unknown_table(const Entry& entry) {
  std::size_t n = 0;
  while (n + 1 < entry.path.size() && (is_table_name(table_of(entry, n + 1)))) ++n;
  const std::string& wrong = entry.path[n];
  const std::string name = name_of(std::span(entry.path).first(n + 1));
  std::vector<std::string> tables;
  for (const auto table : case_tables()) {
    if (!table.empty()) tables.emplace_back(table);
  }
  if (const std::string near = nearest(name, tables); !near.empty() && near != name) {
    throw InputError(fmt::format("{}: {}: unknown table; nearest: [{}]", entry.key_place, name, near));
  }
  if (n == 0) {
    throw InputError(
        fmt::format("{}: {}: unknown table; tables are {}", entry.key_place, name, fmt::join(tables, ", ")));
  }
  const std::string table = table_of(entry, n);
  const Key* key = find_key(table, wrong);
  if (!key && table == kPatches) key = find_key("layers", wrong);
  if (key) {
    throw InputError(fmt::format("{}: {}: expected {}, found a table", entry.key_place, name, allowed(*key)));
  }
  throw InputError(fmt::format("{}: {}: unknown key{}", entry.key_place, name, advice(table, wrong)));
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
                                   entry.value_place, name_of(entry), entry.found));
    }
    length.array = *name;
  } else if (part == "factor") {
    const Key factor = {.kind = Kind::Number, .range = key.range};
    length.factor = checked_number(entry, factor);
  } else {
    throw InputError(fmt::format("{}: {}: unknown key; a length from an array takes array, factor", entry.key_place,
                                 name_of(entry)));
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
  if (is_table_name(name_of(entry))) return;
  std::string table = join(std::span(entry.path).first(entry.path.size() - 1));
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
  const std::string table = is_of_patch ? std::string(kPatches) : join(std::span(path).first(path.size() - 1));
  if (!is_of_patch && !is_table_name(table)) reject_unknown_table(entry);
  const Key* key = find_key(table, name);
  if (!key && is_of_patch) key = find_key("layers", name);
  if (!key || (table == kPatches && !is_of_patch)) {
    throw InputError(fmt::format("{}: {}: unknown key{}", entry.key_place, join(path), advice(table, name)));
  }
  const CaseValue value = checked_value(entry, *key);
  if (!key->set) return;
  PatchRule* rule = is_of_patch ? &rule_for(settings, entry) : nullptr;
  LayerSettings& layers = rule ? rule->layers : settings.layers;
  if (key->table == "layers" && layers.where.empty()) layers.where = entry.key_place;
  key->set({settings, layers, rule}, value);
}

/// Puts the overrides in the place of what they override, with all that is below; they come last.
void apply_overrides(std::vector<Entry>& entries, std::span<const std::string> overrides) {
  for (const std::string& text : overrides) {
    const std::vector<Entry> added = read_override(text);
    const std::vector<std::string>& path = added.front().path;
    std::erase_if(entries, [&](const Entry& old) {
      return old.path.size() >= path.size() && std::equal(path.begin(), path.end(), old.path.begin());
    });
    entries.insert(entries.end(), added.begin(), added.end());
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
  check_volume(settings, entries);
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

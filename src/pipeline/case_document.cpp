#include "pipeline/case_document.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <sstream>

#include <fmt/format.h>
#include <toml++/impl/preprocessor.h>

// toml++ 3.3 assumes that a table header begins with a key before it has looked: "[=" ends a debug build and is
// undefined in a release build. Without the assumption the parser goes on to its own check, which reports the place.
#undef TOML_ASSERT
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(expression) static_assert(true)
#define TOML_ASSERT_ASSUME(expression) static_assert(true)
#include <toml++/toml.h>

#include "nearwall/core/errors.h"
#include "pipeline/toml_text.h"

namespace nearwall::pipeline {

namespace {

std::string place(const std::filesystem::path& file, const toml::source_region& region) {
  return fmt::format("{}:{}:{}", file.string(), region.begin.line, region.begin.column);
}

std::string as_text(const toml::node& node);

std::string as_list(const toml::array& list) {
  constexpr std::size_t kMostItems = 6;
  std::string text;
  for (std::size_t i = 0; i < list.size() && i < kMostItems; ++i) text += (i ? ", " : "") + as_text(list[i]);
  return fmt::format("[{}{}]", text, list.size() > kMostItems ? ", …" : "");
}

constexpr std::size_t kLongest = 60;  ///< bytes of what was found that are shown

std::string quoted(const std::string& text) {
  if (text.size() <= kLongest) return fmt::format("\"{}\"", text);
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;  // between characters of UTF-8
  return fmt::format("\"{}…\"", text.substr(0, end));
}

std::string as_text(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (const auto* list = node.as_array(); list && !list->is_array_of_tables()) return as_list(*list);
  if (node.is_array()) return "a list of tables";
  if (const auto* text = node.as_string()) return quoted(text->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  std::ostringstream out;
  node.visit([&out](const auto& n) {
    if constexpr (!toml::is_container<decltype(n)>) out << n;
  });
  std::string text = out.str();
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "…";
  return text;
}

CaseValue value_of(const toml::node& node) {
  if (const auto* v = node.as_boolean()) return v->get();
  if (const auto* v = node.as_integer()) return std::int64_t{v->get()};
  if (const auto* v = node.as_floating_point()) return v->get();
  if (const auto* v = node.as_string()) return v->get();
  const toml::array* list = node.as_array();
  if (!list) return {};
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (const toml::node& item : *list) {
    if (item.is_string()) texts.push_back(item.as_string()->get());
    if (item.is_number()) numbers.push_back(*item.value<double>());
  }
  if (texts.size() == list->size()) return texts;
  if (numbers.size() == list->size()) return numbers;
  return {};
}

/// Where something stands in the text, for messages.
using PlaceOf = std::function<std::string(const toml::source_region&)>;

void flatten(const toml::table& table, const std::vector<std::string>& path, const PlaceOf& place_of,
             std::vector<Entry>& entries);

/// All but the place of the key.
Entry entry_of(const toml::node& node, const std::vector<std::string>& path, const PlaceOf& place_of) {
  Entry entry;
  entry.path = path;
  entry.value_place = place_of(node.source());
  entry.found = as_text(node);
  entry.is_table = node.is_table();
  if (entry.is_table) return entry;
  entry.value = value_of(node);
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& item : *list) {
      Entry& of_item = entry.items.emplace_back(entry_of(item, path, place_of));
      of_item.key_place = of_item.value_place;
      if (of_item.is_table) flatten(*item.as_table(), path, place_of, of_item.items);
    }
  }
  return entry;
}

void flatten(const toml::table& table, const std::vector<std::string>& path, const PlaceOf& place_of,
             std::vector<Entry>& entries) {
  for (const auto& [key, node] : table) {
    std::vector<std::string> here = path;
    here.emplace_back(key.str());
    Entry& entry = entries.emplace_back(entry_of(node, here, place_of));
    entry.key_place = place_of(key.source());
    entry.line = key.source().begin.line;
    if (node.is_table()) flatten(*node.as_table(), here, place_of, entries);
  }
}

/// Splits "patches.wing.type" at its dots; parts may be quoted.
std::vector<std::string> split_key(const std::string& key) {
  std::vector<std::string> parts(1);
  char quote = 0;
  for (const char c : key) {
    if (quote) {
      if (c == quote) {
        quote = 0;
      } else {
        parts.back() += c;
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '.') {
      parts.emplace_back();
    } else if (c != ' ') {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace

std::string quoted_key(const std::string& part) {
  const bool is_plain = !part.empty() && std::all_of(part.begin(), part.end(), [](unsigned char c) {
    return c == '_' || c == '-' || (c < 0x80 && std::isalnum(c));
  });
  return is_plain ? part : fmt::format("\"{}\"", part);
}

std::string name_of(std::span<const std::string> path) {
  std::string name;
  for (const std::string& part : path) name += (name.empty() ? "" : ".") + quoted_key(part);
  return name;
}

std::string name_of(const Entry& entry) { return name_of(entry.path); }

std::vector<Entry> read_document(const std::string& text, const std::filesystem::path& file) {
  if (const auto stray = first_stray_character(text)) {
    throw InputError(fmt::format("{}:{}:{}: unexpected character; what is not ASCII belongs in quotes or comments",
                                 file.string(), stray->line, stray->column));
  }
  toml::table document;
  try {
    document = toml::parse(text, file.string());
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}: {}", place(file, e.source()), e.description()));
  }
  std::vector<Entry> entries;
  flatten(
      document, {}, [&](const toml::source_region& region) { return place(file, region); }, entries);
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.line < b.line; });
  return entries;
}

std::vector<Entry> read_override(const std::string& override_text) {
  const std::string where = fmt::format("--set {}", override_text);
  const std::size_t equals = override_text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError(fmt::format("{}: expected KEY=VALUE, for instance --set layers.count=20", where));
  }
  const std::vector<std::string> path = split_key(override_text.substr(0, equals));
  const std::string value = override_text.substr(equals + 1);
  const PlaceOf place_of = [&](const toml::source_region&) { return where; };
  if (!first_stray_character(value)) {
    try {
      const toml::table parsed = toml::parse("value = " + value);
      if (parsed.size() != 1) throw InputError(fmt::format("{}: expected one value", where));
      const toml::node& node = *parsed.get("value");
      std::vector<Entry> entries = {entry_of(node, path, place_of)};
      entries.front().key_place = where;
      if (node.is_table()) flatten(*node.as_table(), path, place_of, entries);
      return entries;
    } catch (const toml::parse_error&) {
      // What is no TOML is meant as plain text: file names, choices without quotes.
    }
  }
  Entry text;
  text.path = path;
  text.key_place = text.value_place = where;
  text.value = value;
  text.found = fmt::format("\"{}\"", value);
  return {text};
}

}  // namespace nearwall::pipeline

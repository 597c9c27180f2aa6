#include "pipeline/case_document.h"

#include <algorithm>
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

std::string as_text(const toml::node& node) {
  constexpr std::size_t kLongest = 60;
  if (node.is_table()) return "a table";
  if (const auto* list = node.as_array(); list && !list->is_array_of_tables()) return as_list(*list);
  if (node.is_array()) return "a list of tables";
  if (const auto* text = node.as_string(); text && text->get().size() <= kLongest) {
    return fmt::format("\"{}\"", text->get());
  }
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

void flatten(const toml::table& table, const std::vector<std::string>& path, const std::filesystem::path& file,
             std::vector<Entry>& entries) {
  for (const auto& [key, node] : table) {
    Entry entry;
    entry.path = path;
    entry.path.emplace_back(key.str());
    entry.key_place = place(file, key.source());
    entry.value_place = place(file, node.source());
    entry.line = key.source().begin.line;
    entry.found = as_text(node);
    entry.is_table = node.is_table();
    if (!entry.is_table) entry.value = value_of(node);
    const std::vector<std::string> here = entry.path;
    entries.push_back(std::move(entry));
    if (node.is_table()) flatten(*node.as_table(), here, file, entries);
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
  flatten(document, {}, file, entries);
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.line < b.line; });
  return entries;
}

Entry read_override(const std::string& override_text) {
  const std::string where = fmt::format("--set {}", override_text);
  const std::size_t equals = override_text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError(fmt::format("{}: expected KEY=VALUE, for instance --set layers.count=20", where));
  }
  Entry entry;
  entry.path = split_key(override_text.substr(0, equals));
  entry.key_place = entry.value_place = where;
  const std::string value = override_text.substr(equals + 1);
  // What is no TOML is meant as plain text: file names, choices without quotes.
  entry.value = value;
  entry.found = fmt::format("\"{}\"", value);
  if (first_stray_character(value)) return entry;
  try {
    const toml::table parsed = toml::parse("value = " + value);
    const toml::node& node = *parsed.get("value");
    if (parsed.size() != 1 || node.is_table()) throw InputError(fmt::format("{}: expected one value", where));
    entry.value = value_of(node);
    entry.found = as_text(node);
  } catch (const toml::parse_error&) {
    return entry;
  }
  return entry;
}

}  // namespace nearwall::pipeline

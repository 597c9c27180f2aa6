#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/case_keys.h"

namespace nearwall::pipeline {

/// A value as it stands in a TOML text.
struct Entry {
  std::vector<std::string> path;  ///< table names and the key
  CaseValue value;                ///< monostate: of a sort that no key takes (a date, a mixed list, a table)
  std::string found;              ///< the value for messages: 1.5, "abc", a date
  std::string key_place;          ///< "case.toml:3:1"
  std::string value_place;        ///< "case.toml:3:10"
  std::size_t line = 0;
  bool is_table = false;     ///< a table itself, not a value
  std::vector<Entry> items;  ///< of a list: each with the list's path; of a table in a list: its keys
};

/// A part of a dotted key as TOML wants it: in quotes unless it is a plain word.
std::string quoted_key(const std::string& part);

/// layers.first_height, patches."w*".type: for messages.
std::string name_of(std::span<const std::string> path);
std::string name_of(const Entry& entry);

/// All tables and values of a TOML text in the order in which they stand there. Integers, numbers, booleans, texts,
/// lists of numbers (as doubles) and lists of texts are values, others have items alone; inline tables are tables.
/// \throws InputError
/// "FILE:LINE:COLUMN: …" for a text that is not TOML
std::vector<Entry> read_document(const std::string& text, const std::filesystem::path& file);

/// "key=value" of --set. The value is read as TOML, and as plain text where it is none.
/// \returns the entry of the key, and those of its keys where the value is an inline table. \throws InputError
std::vector<Entry> read_override(const std::string& override_text);

}  // namespace nearwall::pipeline

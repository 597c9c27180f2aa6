#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nearwall/pipeline/case.h"

namespace nearwall::pipeline {

/// A value of the case file. monostate: not given and without default.
using CaseValue = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                               std::vector<std::string>, ArrayLength, std::vector<SymmetrySetting>>;

/// What a key takes. Number, Integer, Boolean and Point may take "auto" besides.
enum class Kind { Number, Integer, Boolean, Text, Choice, Choices, Numbers, Point, Planes };

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool is_low_open = false;  ///< low itself is not allowed
};

/// Where a value goes to.
struct Target {
  Case& settings;
  LayerSettings& layers;  ///< of [layers] or of a patch
  PatchRule* rule;        ///< null outside [patches]
};

/// One key of the case file. This description drives the reading, the template, the reference and the report.
struct Key {
  std::string_view table = {};  ///< "surface"; empty at the top; "patches" for keys of patches alone
  std::string_view name = {};
  Kind kind = Kind::Number;
  bool takes_auto = false;
  std::string_view unit = {};          ///< empty: none
  std::string_view default_text = {};  ///< as TOML; empty: no default
  std::string_view example = {};       ///< as TOML, for keys without default
  Range range = {};
  std::vector<std::string_view> choices = {};
  std::vector<std::string_view> later = {};  ///< choices of the format that this version does not do
  std::string_view doc = {};
  void (*set)(Target, const CaseValue&) = nullptr;
  /// Of keys that take { array = "NAME", factor = … } besides: the array of the settings instead of a number.
  ArrayLength& (*array)(LayerSettings&) = nullptr;
  CaseValue (*get)(const Case&, const LayerSettings&) = nullptr;
};

/// All keys, in the order of the case file. Keys of "layers" are those of patches, too.
const std::vector<Key>& case_keys();

/// The tables in the order of the case file, "" first; "patches" stands for [patches.NAME].
const std::vector<std::string_view>& case_tables();

/// The key, or null.
const Key* find_key(std::string_view table, std::string_view name);

/// "surface.scale"
std::string dotted(const Key& key);

/// What a key allows, as a phrase: "a number above 0", "one of none, safe".
std::string allowed(const Key& key);

/// Parts of case_keys().
std::vector<Key> general_keys();
std::vector<Key> layer_keys();
std::vector<Key> volume_keys();

inline constexpr std::string_view kAuto = "auto";
inline constexpr std::string_view kAxisNames = "xyz";

/// Of a choice: the enumerator at the place of its name.
template <class Enum, std::size_t n>
Enum enumerator(const std::array<std::string_view, n>& names, const CaseValue& v) {
  return static_cast<Enum>(std::find(names.begin(), names.end(), std::get<std::string>(v)) - names.begin());
}

inline bool is_auto(const CaseValue& v) {
  return std::holds_alternative<std::string>(v) && std::get<std::string>(v) == kAuto;
}

}  // namespace nearwall::pipeline

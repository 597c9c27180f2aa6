#pragma once

#include <optional>
#include <string_view>

namespace nearwall::pipeline {

struct TextPlace {
  std::size_t line = 1;
  std::size_t column = 1;
};

/// The first character outside of texts in quotes and comments that TOML has no use for there: control characters and
/// whatever is not ASCII. The parser of Debian 12 (toml++ 3.3) is undefined on these, so they are looked for
/// beforehand.
std::optional<TextPlace> first_stray_character(std::string_view text);

}  // namespace nearwall::pipeline

#include "pipeline/toml_text.h"

#include <algorithm>

namespace nearwall::pipeline {

namespace {

bool is_stray(char c) {
  const auto code = static_cast<unsigned char>(c);
  const bool is_blank = c == '\t' || c == '\n' || c == '\r';
  return (code < 0x20 && !is_blank) || code >= 0x7f;
}

/// Length of the text in quotes or the comment that begins here; 0 if none does. An unfinished one reaches to the end
/// (of the line, for those that must end there): the parser will complain.
std::size_t quoted_length(std::string_view rest) {
  if (rest.front() == '#') return std::min(rest.find('\n'), rest.size());
  if (rest.front() != '"' && rest.front() != '\'') return 0;
  const char quote = rest.front();
  const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
  const bool is_multi_line = rest.starts_with(three);
  for (std::size_t i = is_multi_line ? 3 : 1; i < rest.size(); ++i) {
    if (quote == '"' && rest[i] == '\\') {
      ++i;
    } else if (is_multi_line ? rest.substr(i).starts_with(three) : rest[i] == quote) {
      return i + (is_multi_line ? 3 : 1);
    } else if (!is_multi_line && rest[i] == '\n') {
      return i;
    }
  }
  return rest.size();
}

}  // namespace

std::optional<TextPlace> first_stray_character(std::string_view text) {
  // A mark of the byte order may stand in front.
  std::size_t i = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  TextPlace place;
  while (i < text.size()) {
    const std::size_t quoted = quoted_length(text.substr(i));
    if (quoted == 0 && is_stray(text[i])) return place;
    for (const std::size_t end = i + (quoted > 0 ? quoted : 1); i < end && i < text.size(); ++i) {
      if (text[i] == '\n') {
        place = {place.line + 1, 1};
      } else {
        ++place.column;
      }
    }
  }
  return std::nullopt;
}

}  // namespace nearwall::pipeline

#include "io/cgns_names.h"

#include <fmt/format.h>

namespace nearwall::io {
namespace {

/// At most that many bytes, no character of UTF-8 cut in two, no blanks at its end: the library drops blanks at the
/// ends of a node's name, but not where another node refers to it.
std::string_view cut(std::string_view text, std::size_t most) {
  if (text.size() > most) {
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
    text = text.substr(0, most);
  }
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

}  // namespace

std::string CgnsNames::add(std::string_view full) {
  std::string whole(full);
  for (char& c : whole) {
    if (c == '/' || static_cast<unsigned char>(c) < ' ') c = '_';
  }
  if (whole.find_first_not_of(" .") == std::string::npos) whole = "patch";
  whole.erase(0, whole.find_first_not_of(' '));
  std::string name(cut(whole, kMostInCgnsName));
  for (int number = 2; !used_.insert(name).second; ++number) {
    const std::string end = fmt::format("~{}", number);
    name = std::string(cut(whole, kMostInCgnsName - end.size())) + end;
  }
  return name;
}

}  // namespace nearwall::io

#include "io/cgns_names.h"

#include <fmt/format.h>

namespace nearwall::io {
namespace {

/// At most that many bytes, no character of UTF-8 cut in two.
std::string_view cut(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
  return text.substr(0, most);
}

}  // namespace

std::string CgnsNames::add(std::string_view full) {
  std::string whole(full);
  for (char& c : whole) {
    if (c == '/' || static_cast<unsigned char>(c) < ' ') c = '_';
  }
  if (whole.find_first_not_of(" .") == std::string::npos) whole = "patch";
  std::string name(cut(whole, kMostInCgnsName));
  for (int number = 2; !used_.insert(name).second; ++number) {
    const std::string end = fmt::format("~{}", number);
    name = std::string(cut(whole, kMostInCgnsName - end.size())) + end;
  }
  return name;
}

}  // namespace nearwall::io

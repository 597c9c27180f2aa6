#include "program/row_names.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "program/table.h"

namespace nearwall::program {

namespace {

/// Characters of UTF-8 text.
std::vector<std::string> characters(const std::string& text) {
  std::vector<std::string> all;
  for (const char c : text) {
    const bool begins = (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
    if (begins || all.empty()) all.emplace_back();
    all.back() += c;
  }
  return all;
}

/// `n` characters from the place `begin` on.
std::string part(const std::vector<std::string>& text, std::size_t begin, std::size_t n) {
  std::string out;
  for (std::size_t i = begin; i < std::min(begin + n, text.size()); ++i) out += text[i];
  return out;
}

/// \param end  in place of its own end; empty: half of the room for that
std::string shortened(const std::string& name, std::size_t longest, const std::string& end) {
  if (end.empty() && text_width(name) <= longest) return name;
  const std::vector<std::string> text = characters(name);
  const std::size_t n_end = end.empty() ? (longest - 1) / 2 : text_width(end);
  const std::size_t n_begin = longest - 1 - std::min(n_end, longest - 1);
  return part(text, 0, n_begin) + "…" + (end.empty() ? part(text, text.size() - n_end, n_end) : end);
}

}  // namespace

std::vector<std::string> row_names(const std::vector<std::string>& names, std::size_t longest) {
  std::vector<std::string> shown;
  std::map<std::string, std::size_t> n_of;
  for (const std::string& name : names) ++n_of[shown.emplace_back(shortened(name, longest, ""))];
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (n_of[shown[i]] > 1 && shown[i] != names[i]) shown[i] = shortened(names[i], longest, fmt::format("#{}", i + 1));
  }
  return shown;
}

}  // namespace nearwall::program

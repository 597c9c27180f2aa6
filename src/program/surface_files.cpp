#include "program/surface_files.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::program {

namespace fs = std::filesystem;

namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return text;
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

}  // namespace

void demand_vtp(const std::string& option, const fs::path& path) {
  if (lower_case(path.extension().string()) == ".vtp") return;
  throw InputError(fmt::format("{} {}: expected a name that ends in .vtp", option, path.string()));
}

bool is_case_file(const fs::path& path) {
  if (lower_case(path.extension().string()) != ".toml") return false;
  static const std::regex format_key(R"(^\s*format\s*=.*)");
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, format_key)) return true;
    if (line.starts_with('[')) return false;
  }
  return false;
}

std::vector<fs::path> files_below(const fs::path& folder, bool (*wanted)(const fs::path&)) {
  std::vector<fs::path> found;
  try {
    for (auto it = fs::recursive_directory_iterator(folder); it != fs::recursive_directory_iterator(); ++it) {
      if (it->is_directory() && is_hidden(it->path())) {
        it.disable_recursion_pending();
      } else if (it->is_regular_file() && !is_hidden(it->path()) && wanted(it->path())) {
        found.push_back(it->path());
      }
    }
  } catch (const fs::filesystem_error& e) {
    throw IoError(fmt::format("{}: {}", folder.string(), e.code().message()));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace nearwall::program

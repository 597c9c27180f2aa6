#include "pipeline/output_directory.h"

#include <algorithm>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr const char* kReports[] = {"report.json", "report.html"};
constexpr const char* kResultEndings[] = {".vtu", "-layers.vtu", "-surface.vtp", "-front.vtp", "-faults.vtp"};

/// Turns the errors of the file system into ours.
template <class Body>
auto on_disk(const fs::path& path, Body&& body) {
  try {
    return body();
  } catch (const fs::filesystem_error& e) {
    throw IoError(fmt::format("{}: {}", path.string(), e.code().message()));
  }
}

}  // namespace

OutputDirectory::OutputDirectory(fs::path directory, std::string name, bool is_forced)
    : directory_(std::move(directory)), name_(std::move(name)), aside_(directory_ / fmt::format(".{}-partial", name_)) {
  on_disk(directory_, [&] {
    if (fs::exists(directory_) && !fs::is_directory(directory_)) {
      throw InputError(fmt::format("output directory {}: is a file; give another with -o", directory_.string()));
    }
    const auto foreign = foreign_files();
    if (!foreign.empty() && !is_forced) {
      throw InputError(
          fmt::format("output directory {}: holds other things than results of \"{}\", for instance {}; give "
                      "another with -o, or --force to write there all the same",
                      directory_.string(), name_, foreign.front().filename().string()));
    }
    fs::remove_all(aside_);  // before the folder is made, which stays behind if this throws
    is_new_ = fs::create_directories(directory_);
  });
}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  fs::remove_all(aside_, ignored);
  if (is_new_) fs::remove(directory_, ignored);  // only if it is empty
}

bool OutputDirectory::is_result(const std::string& file) const {
  if (std::find(std::begin(kReports), std::end(kReports), file) != std::end(kReports)) return true;
  if (file == aside_.filename()) return true;
  if (!file.starts_with(name_)) return false;
  const std::string rest = file.substr(name_.size());
  if (std::find(std::begin(kResultEndings), std::end(kResultEndings), rest) != std::end(kResultEndings)) return true;
  return rest.starts_with('-') && rest.ends_with(".png");
}

std::vector<fs::path> OutputDirectory::foreign_files() const {
  std::vector<fs::path> foreign;
  if (!fs::exists(directory_)) return foreign;
  for (const auto& entry : fs::directory_iterator(directory_)) {
    if (!is_result(entry.path().filename().string())) foreign.push_back(entry.path());
  }
  std::sort(foreign.begin(), foreign.end());
  return foreign;
}

fs::path OutputDirectory::aside(const std::string& file) {
  files_.push_back(file);
  return scratch(file);
}

fs::path OutputDirectory::scratch(const std::string& file) {
  on_disk(aside_, [&] { fs::create_directories(aside_); });
  return aside_ / file;
}

std::vector<std::string> OutputDirectory::publish() {
  on_disk(directory_, [&] {
    // Earlier results go first: at no time do files of two runs stand side by side.
    for (const auto& entry : fs::directory_iterator(directory_)) {
      const std::string file = entry.path().filename().string();
      if (is_result(file) && file != aside_.filename()) fs::remove(entry.path());
    }
    std::erase_if(files_, [&](const std::string& file) { return !fs::exists(aside_ / file); });
    for (const std::string& file : files_) fs::rename(aside_ / file, directory_ / file);
    fs::remove_all(aside_);
  });
  return files_;
}

}  // namespace nearwall::pipeline

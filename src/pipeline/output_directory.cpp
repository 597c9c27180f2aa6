#include "pipeline/output_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/io/mesh_formats.h"

namespace nearwall::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr const char* kReports[] = {"report.json", "report.html"};
constexpr const char* kResultEndings[] = {"-layers.vtu", "-surface.vtp",     "-front.vtp",   "-layers-boundary.vtp",
                                          "-faults.vtp", "-fill-faults.vtp", "-boundary.vtp"};

/// Everything that meshes of a case may be written as.
std::vector<fs::path> mesh_files(const std::string& name) {
  std::vector<fs::path> all;
  for (std::size_t i = 0; i < io::kMeshFormatNames.size(); ++i) {
    for (const std::string& file : io::mesh_file_names(name, static_cast<io::MeshFormat>(i))) all.emplace_back(file);
  }
  return all;
}

/// Is it one of these, or a folder that holds one?
bool is_mesh(const std::string& file, const std::string& name) {
  const auto files = mesh_files(name);
  return std::any_of(files.begin(), files.end(), [&](const fs::path& mesh) { return *mesh.begin() == file; });
}

/// A folder of a solver's case may hold more than the mesh: its set-up and results stay.
void remove_mesh_in_folders(const fs::path& directory, const std::string& name) {
  for (const fs::path& file : mesh_files(name)) {
    if (!file.has_parent_path()) continue;
    fs::remove_all(directory / file);
    for (fs::path folder = file.parent_path(); !folder.empty(); folder = folder.parent_path()) {
      if (!fs::is_directory(directory / folder) || !fs::is_empty(directory / folder)) break;
      fs::remove(directory / folder);
    }
  }
}

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
    is_new_ = fs::create_directories(directory_);
    try {
      lock();
      fs::remove_all(aside_);
    } catch (...) {
      give_back();
      throw;
    }
  });
}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  fs::remove_all(aside_, ignored);
  give_back();
}

void OutputDirectory::give_back() {
  std::error_code ignored;
  if (is_new_) fs::remove(directory_, ignored);  // only if it is empty
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputDirectory::lock() {
  descriptor_ = ::open(directory_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // File systems without locks say so with other errors; there, runs have to be kept apart by their user.
  if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  is_new_ = false;  // it belongs to the other run
  throw InputError(
      fmt::format("output directory {}: another run is writing there; wait for its end, or give another with -o",
                  directory_.string()));
}

bool OutputDirectory::is_result(const std::string& file) const {
  if (std::find(std::begin(kReports), std::end(kReports), file) != std::end(kReports)) return true;
  if (file == aside_.filename() || is_mesh(file, name_)) return true;
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
  if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(file);
  return scratch(file);
}

fs::path OutputDirectory::scratch(const std::string& file) {
  on_disk(aside_, [&] { fs::create_directories((aside_ / file).parent_path()); });
  return aside_ / file;
}

std::vector<std::string> OutputDirectory::publish() {
  on_disk(directory_, [&] {
    for (const std::string& file : files_) {
      if (!fs::exists(aside_ / file)) throw IoError(fmt::format("{}: has vanished", (aside_ / file).string()));
    }
    // Earlier results go first: at no time do files of two runs stand side by side.
    for (const auto& entry : fs::directory_iterator(directory_)) {
      const std::string file = entry.path().filename().string();
      if (is_result(file) && entry.is_regular_file()) fs::remove(entry.path());
    }
    remove_mesh_in_folders(directory_, name_);
    for (const std::string& file : files_) {
      fs::create_directories((directory_ / file).parent_path());
      fs::rename(aside_ / file, directory_ / file);
    }
    fs::remove_all(aside_);
  });
  return files_;
}

}  // namespace nearwall::pipeline

#include "nearwall/io/pending_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  const char* advice = error == ENOSPC || error == EDQUOT  ? "; free some space and run again"
                       : error == EACCES || error == EPERM ? "; choose a folder that may be written to"
                       : error == ENOENT                   ? "; create the folder first"
                                                           : "";
  throw IoError(
      fmt::format("{}: cannot be written: {}{}", path.string(), std::system_category().message(error), advice));
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

std::filesystem::path hidden_name(const std::filesystem::path& path) {
  static std::atomic<unsigned> counter{0};
  return folder_of(path) / fmt::format(".{}.{}-{}.part", path.filename().string(), ::getpid(), counter++);
}

/// Makes the renaming itself survive a power cut; file systems that cannot do it are no reason to fail.
void flush_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

PendingFile::PendingFile(std::filesystem::path path) : path_(std::move(path)) {
  do {
    temporary_ = hidden_name(path_);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && (errno == EEXIST || errno == EINTR));
  if (descriptor_ < 0) fail(path_, errno);
}

PendingFile::~PendingFile() { remove(); }

void PendingFile::remove() noexcept {
  if (descriptor_ < 0) return;
  ::close(std::exchange(descriptor_, -1));
  ::unlink(temporary_.c_str());
}

void PendingFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
    size_ += static_cast<std::uint64_t>(n);
  }
}

void PendingFile::write_at(std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

void PendingFile::commit() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(path_, errno);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, errno);
  ::close(std::exchange(descriptor_, -1));
  flush_folder(folder_of(path_));
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  PendingFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace nearwall::io

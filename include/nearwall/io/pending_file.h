#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace nearwall::io {

/// A file that appears under its name only when it is complete: written aside in the same folder under a hidden name,
/// flushed to the disk and renamed by `commit`. Without `commit` the destructor removes what was written.
class PendingFile {
 public:
  /// \throws IoError naming the path and the reason (no such folder, no permission, disk full)
  explicit PendingFile(std::filesystem::path path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Appends. \throws IoError
  void write(std::string_view bytes);
  /// Writes at a place in the file, which may be behind its end: formats whose parts are made side by side. `write`
  /// goes on where it was, and overwrites what stands there. \throws IoError
  void write_at(std::uint64_t offset, std::string_view bytes);
  /// Flushes and renames; an older file of that name is replaced. Call once. \throws IoError
  void commit();

  const std::filesystem::path& path() const { return path_; }
  /// Where the bytes are until `commit`, for programs and libraries that write by name.
  const std::filesystem::path& temporary() const { return temporary_; }
  std::uint64_t size() const { return size_; }

 private:
  void remove() noexcept;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// Writes a whole file through a PendingFile. \throws IoError
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace nearwall::io

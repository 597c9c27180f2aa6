#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "nearwall/core/vec3.h"

namespace nearwall::volume {

/// A file in memory that no folder shows; gone with its last user.
class MemoryFile {
 public:
  /// \throws IoError
  explicit MemoryFile(const char* name);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int descriptor() const { return descriptor_; }
  void rewind() const;

 private:
  int descriptor_ = -1;
};

/// \throws IoError  unless all bytes could be written
void write_bytes(int file, const void* bytes, std::size_t size);
/// \throws BackendError  if the file ends before
void read_bytes(int file, void* bytes, std::size_t size);

template <class T>
void write_array(int file, std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  write_bytes(file, values.data(), values.size_bytes());
}

template <class T>
std::vector<T> read_array(int file, std::size_t n) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<T> values(n);
  read_bytes(file, values.data(), n * sizeof(T));
  return values;
}

}  // namespace nearwall::volume

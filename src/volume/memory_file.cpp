#include "volume/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::volume {

MemoryFile::MemoryFile(const char* name) : descriptor_(::memfd_create(name, MFD_CLOEXEC)) {
  if (descriptor_ < 0) {
    throw IoError(fmt::format("no memory for what goes to the tetrahedral mesher: {}", std::strerror(errno)));
  }
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

void MemoryFile::rewind() const { ::lseek(descriptor_, 0, SEEK_SET); }

void write_bytes(int file, const void* bytes, std::size_t size) {
  const char* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t n = ::write(file, next, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw IoError(fmt::format("the tetrahedral mesher cannot be written to: {}", std::strerror(errno)));
    next += n;
    size -= static_cast<std::size_t>(n);
  }
}

void read_bytes(int file, void* bytes, std::size_t size) {
  char* next = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t n = ::read(file, next, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw BackendError("the tetrahedral mesher gave less than it said");
    next += n;
    size -= static_cast<std::size_t>(n);
  }
}

}  // namespace nearwall::volume

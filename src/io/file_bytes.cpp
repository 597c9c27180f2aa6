#include "io/file_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <limits>
#include <memory>
#include <system_error>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;
constexpr int kGzipWindow = 15 + 16;  // zlib: largest window, gzip framing

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }

 private:
  int value_;
};

[[noreturn]] void fail_reading(const std::filesystem::path& path, int error) {
  if (error == ENOENT || error == ENOTDIR) {
    throw InputError(fmt::format("{}: no such file", path.string()));
  }
  throw IoError(fmt::format("{}: cannot be read: {}", path.string(), std::system_category().message(error)));
}

std::string read_plain(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (file.value() < 0 || ::fstat(file.value(), &status) != 0) fail_reading(path, errno);
  if (S_ISDIR(status.st_mode)) throw InputError(fmt::format("{}: is a folder, expected a file", path.string()));
  if (!S_ISREG(status.st_mode)) throw InputError(fmt::format("{}: is not a regular file", path.string()));

  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::read(file.value(), bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail_reading(path, errno);
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

struct InflateEnd {
  void operator()(z_stream* stream) const { inflateEnd(stream); }
};

/// All members of a gzip file, one after the other.
std::string unpack(std::string_view packed, const std::filesystem::path& path) {
  z_stream state{};
  expect(inflateInit2(&state, kGzipWindow) == Z_OK, "zlib starts");
  const std::unique_ptr<z_stream, InflateEnd> guard(&state);
  const auto fail = [&](std::string_view what) {
    throw GeometryError(fmt::format("{}: byte {}: {}; copy or pack the file again", path.string(),
                                    packed.size() - state.avail_in, what));
  };

  std::string bytes;
  std::size_t used = 0;
  std::size_t given = 0;
  for (;;) {
    if (state.avail_in == 0) {  // avail_in has 32 bits
      const std::size_t n = std::min<std::size_t>(packed.size() - given, std::numeric_limits<int>::max());
      if (n == 0) fail("the gzipped data ends too early");
      state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + given));
      state.avail_in = static_cast<uInt>(n);
      given += n;
    }
    if (bytes.size() - used < kChunk) bytes.resize(std::max(2 * bytes.size(), kChunk));
    const std::size_t room = std::min<std::size_t>(bytes.size() - used, std::numeric_limits<int>::max());
    state.next_out = reinterpret_cast<Bytef*>(bytes.data() + used);
    state.avail_out = static_cast<uInt>(room);
    const int result = inflate(&state, Z_NO_FLUSH);
    used += room - state.avail_out;
    if (result == Z_STREAM_END) {
      const std::string_view rest = packed.substr(given - state.avail_in);
      if (!is_gzip(rest)) break;  // padding behind the last member is ignored, as gzip itself does
      inflateReset(&state);
    } else if (result == Z_MEM_ERROR) {
      throw std::bad_alloc();
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      fail(fmt::format("the gzipped data is damaged ({})", state.msg ? state.msg : "zlib error"));
    }
  }
  bytes.resize(used);
  return bytes;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path) try {
  std::string bytes = read_plain(path);
  if (is_gzip(bytes)) return unpack(bytes, path);
  if (is_gzip_name(path)) {
    throw GeometryError(
        fmt::format("{}: the name ends in .gz but the data is not gzipped; take .gz off the name", path.string()));
  }
  return bytes;
} catch (const std::bad_alloc&) {
  throw IoError(fmt::format("{}: not enough memory to read the file", path.string()));
} catch (const std::length_error&) {
  throw IoError(fmt::format("{}: not enough memory to read the file", path.string()));
}

std::string gzip(std::string_view bytes) {
  z_stream state{};
  constexpr int kDefaultMemory = 8;
  expect(
      deflateInit2(&state, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipWindow, kDefaultMemory, Z_DEFAULT_STRATEGY) == Z_OK,
      "zlib starts");
  std::string packed;
  std::string chunk(kChunk, '\0');
  do {
    const std::size_t n = std::min(bytes.size(), kChunk);
    state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    state.avail_in = static_cast<uInt>(n);
    bytes.remove_prefix(n);
    do {
      state.next_out = reinterpret_cast<Bytef*>(chunk.data());
      state.avail_out = static_cast<uInt>(chunk.size());
      deflate(&state, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
      packed.append(chunk, 0, chunk.size() - state.avail_out);
    } while (state.avail_out == 0);
  } while (!bytes.empty());
  deflateEnd(&state);
  return packed;
}

bool is_gzip_name(const std::filesystem::path& path) { return lower(path.extension().string()) == ".gz"; }

std::string format_ending(const std::filesystem::path& path) {
  const std::string ending = lower((is_gzip_name(path) ? path.stem() : path).extension().string());
  return ending.empty() ? ending : ending.substr(1);
}

}  // namespace nearwall::io

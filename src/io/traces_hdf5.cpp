#include "io/hdf5_traces.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "io/objects_hdf5.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"

// HDF5 File Format Specification 3.0, IV.A.1.b: an object header of version 2 begins with a signature, a version,
// flags, and four times of 4 bytes if a flag says so; it ends with a checksum, Jenkins' lookup3 (III.G).
namespace nearwall::io {
namespace {

constexpr std::size_t kFlagsAt = 5;
constexpr std::size_t kTimesAt = 6;
constexpr std::size_t kTimes = 16;        // bytes
constexpr std::size_t kLongestHead = 34;  // with times, limits of attributes, and 8 bytes of size
constexpr unsigned kHasTimes = 0x20, kHasLimits = 0x10, kSizeWidth = 0x03;

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes.size() && i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return value;
}

/// Bob Jenkins' lookup3 of 2006, as HDF5 uses it.
std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t a = 0xdeadbeef + static_cast<std::uint32_t>(bytes.size()), b = a, c = a;
  const auto add = [&](std::string_view twelve) {
    a += little_endian(twelve);
    b += little_endian(twelve.size() > 4 ? twelve.substr(4) : std::string_view());
    c += little_endian(twelve.size() > 8 ? twelve.substr(8) : std::string_view());
  };
  const auto mix = [](std::uint32_t& x, std::uint32_t& y, std::uint32_t z, int turn) {
    y -= x;
    y ^= std::rotl(x, turn);
    x += z;
  };
  while (bytes.size() > 12) {
    add(bytes.substr(0, 12));
    mix(c, a, b, 4), mix(a, b, c, 6), mix(b, c, a, 8);
    mix(c, a, b, 16), mix(a, b, c, 19), mix(b, c, a, 4);
    bytes.remove_prefix(12);
  }
  if (bytes.empty()) return c;
  add(bytes);
  const auto finish = [](std::uint32_t& x, std::uint32_t y, int turn) {
    x ^= y;
    x -= std::rotl(y, turn);
  };
  finish(c, b, 14), finish(a, c, 11), finish(b, a, 25), finish(c, b, 16);
  finish(a, c, 4), finish(b, a, 14), finish(c, b, 24);
  return c;
}

/// Fills a text of fixed size with zeros behind its end.
herr_t clear_behind_end(hid_t object, const char* name, const H5A_info_t*, void*) {
  const Hdf5Object attribute(H5Aopen(object, name, H5P_DEFAULT));
  const Hdf5Object type(attribute ? H5Aget_type(attribute.id()) : H5I_INVALID_HID);
  if (!type) return -1;
  const Hdf5Object space(H5Aget_space(attribute.id()));
  const bool is_text = H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0;
  if (!is_text || H5Sget_simple_extent_npoints(space.id()) != 1) return 0;
  std::string text(H5Tget_size(type.id()), '\0');
  if (H5Aread(attribute.id(), type.id(), text.data()) < 0) return -1;
  const std::size_t end = std::min(text.find('\0'), text.size());
  if (text.find_first_not_of('\0', end) == std::string::npos) return 0;
  text.replace(end, std::string::npos, text.size() - end, '\0');
  return H5Awrite(attribute.id(), type.id(), text.data());
}

herr_t clear_texts(hid_t root, const char* name, const H5O_info_t* info, void* addresses) {
  static_cast<std::vector<haddr_t>*>(addresses)->push_back(info->addr);
  const Hdf5Object object(H5Oopen(root, name, H5P_DEFAULT));
  return object ? H5Aiterate2(object.id(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, clear_behind_end, nullptr) : -1;
}

/// Clears what is behind the ends of texts. \returns  where the headers of all objects begin
std::vector<haddr_t> clear_texts(const std::filesystem::path& path) {
  const Hdf5Session session;
  const Hdf5Object access = unlocked_access();
  const Hdf5Object file(written(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.id()), path));
  std::vector<haddr_t> headers;
  written(H5Ovisit2(file.id(), H5_INDEX_NAME, H5_ITER_NATIVE, clear_texts, &headers, H5O_INFO_BASIC), path);
  written(H5Fflush(file.id(), H5F_SCOPE_LOCAL), path);
  return headers;
}

class RawFile {
 public:
  explicit RawFile(const std::filesystem::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
    if (descriptor_ < 0) fail();
  }
  ~RawFile() { ::close(descriptor_); }
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  std::string read(std::uint64_t at, std::size_t n) const {
    std::string bytes(n, '\0');
    const ssize_t got = ::pread(descriptor_, bytes.data(), n, static_cast<off_t>(at));
    if (got < 0) fail();
    bytes.resize(static_cast<std::size_t>(got));
    return bytes;
  }
  void write(std::uint64_t at, std::string_view bytes) const {
    if (::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at)) !=
        static_cast<ssize_t>(bytes.size())) {
      fail();
    }
  }
  void flush() const {
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail();
  }

 private:
  [[noreturn]] void fail() const {
    throw IoError(fmt::format("{}: cannot be written: {}", path_.string(), std::system_category().message(errno)));
  }

  const std::filesystem::path& path_;
  int descriptor_;
};

/// Clears the times of one object.
void clear_times(const RawFile& file, haddr_t at) {
  const std::string head = file.read(at, kLongestHead);
  expect(head.starts_with("OHDR\2") && head.size() > kTimesAt, "object headers are of version 2");
  const auto flags = static_cast<unsigned char>(head[kFlagsAt]);
  if (!(flags & kHasTimes)) return;
  const std::size_t size_at = kTimesAt + kTimes + (flags & kHasLimits ? 4 : 0), width = 1u << (flags & kSizeWidth);
  const std::size_t n_messages = little_endian(std::string_view(head).substr(size_at, width));
  const std::size_t n = size_at + width + n_messages;
  std::string header = file.read(at, n + 4);
  expect(header.size() == n + 4 && checksum(std::string_view(header).substr(0, n)) == little_endian(header.substr(n)),
         "an object header ends with its checksum");
  header.replace(kTimesAt, kTimes, kTimes, '\0');
  const std::uint32_t sum = checksum(std::string_view(header).substr(0, n));
  for (std::size_t i = 0; i < 4; ++i) header[n + i] = static_cast<char>(sum >> (8 * i));
  file.write(at, header);
}

}  // namespace

void clear_traces(const std::filesystem::path& path) {
  const std::vector<haddr_t> headers = clear_texts(path);
  const RawFile file(path);
  for (const haddr_t at : headers) clear_times(file, at);
  file.flush();
}

}  // namespace nearwall::io

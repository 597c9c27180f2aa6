#include "io/vtk_xml_data.h"

#include <fmt/format.h>
#include <zlib.h>

#include "nearwall/core/parallel.h"

namespace nearwall::io {
namespace {

/// No deflated data grows by more on unpacking: what claims more is damaged.
constexpr std::uint64_t kMostInflation = 1040;

constexpr std::uint64_t kRawAtOnce = std::uint64_t{1} << 24;  // bytes of the blocks that are unpacked together

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes `n` bytes at the cursor and passes their last group of four characters.
std::string take_base64(Cursor& in, std::uint64_t n) {
  const auto n_bytes = static_cast<std::size_t>(n);
  if (n > in.left()) in.fail(fmt::format("expected {} bytes in base64, found the end of the file", n));
  const std::string_view text = in.bytes((n_bytes + 2) / 3 * 4, "base64 data");
  std::string out;
  out.reserve(n_bytes + 2);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const char c = text[i + k];
      const int digit = c == '=' ? 0 : base64_digit(c);
      if (digit < 0) in.fail_expected("base64 data", text.substr(i + k, 1));
      group = group << 6 | static_cast<std::uint32_t>(digit);
    }
    for (const int shift : {16, 8, 0}) out += static_cast<char>(group >> shift & 0xff);
  }
  out.resize(n_bytes);
  return out;
}

std::size_t header_width(const XmlEncoding& encoding) {
  return encoding.has_wide_headers ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
}

std::uint64_t header_number(Cursor& in, const XmlEncoding& encoding) {
  return encoding.has_wide_headers ? in.value<std::uint64_t>(encoding.order, "the size of an array")
                                   : in.value<std::uint32_t>(encoding.order, "the size of an array");
}

}  // namespace

XmlData::XmlData(const Cursor& where, const XmlEncoding& encoding) : in_(where) {
  encoding.is_compressed ? read_blocks(encoding) : read_plain(encoding);
}

/// The next n bytes, decoded into decoded_ if need be.
std::string_view XmlData::take(std::uint64_t n, bool is_base64) {
  if (!is_base64) return in_.bytes(static_cast<std::size_t>(n), "data of an array");
  decoded_ = take_base64(in_, n);
  return decoded_;
}

void XmlData::read_plain(const XmlEncoding& encoding) {
  const std::size_t width = header_width(encoding);
  Cursor after = in_;
  std::string size_bytes(encoding.is_base64 ? take_base64(after, width) : after.bytes(width, "the size of an array"));
  Cursor size_in(size_bytes, in_.file());
  n_bytes_ = header_number(size_in, encoding);
  if (n_bytes_ > in_.left())
    in_.fail(fmt::format("an array claims {} bytes, more than the file has; it is cut off or damaged", n_bytes_));
  // In base64 the size and the data are one run of characters.
  bytes_ = take(n_bytes_ + width, encoding.is_base64).substr(width);
}

/// Number of blocks, size of a block, size of the last one (0: whole), packed sizes; then the blocks.
void XmlData::read_blocks(const XmlEncoding& encoding) {
  const std::size_t width = header_width(encoding);
  const bool is_base64 = encoding.is_base64;
  Cursor peek = in_;
  const std::string first(is_base64 ? take_base64(peek, width) : peek.bytes(width, "the size of an array"));
  Cursor first_in(first, in_.file());
  const std::uint64_t n_blocks = header_number(first_in, encoding);
  if (n_blocks > in_.left() / width)
    in_.fail(fmt::format("an array claims {} blocks, more than fit the file; it is cut off or damaged", n_blocks));
  if (n_blocks == 0) return;

  const std::string header(take((3 + n_blocks) * width, is_base64));
  Cursor in(header, in_.file());
  header_number(in, encoding);
  full_block_ = header_number(in, encoding);
  const std::uint64_t last = header_number(in, encoding);
  begins_.push_back(0);
  for (std::uint64_t b = 0; b < n_blocks; ++b) {
    const std::uint64_t packed = header_number(in, encoding);
    if (packed > in_.left() || begins_.back() + packed > in_.left()) {
      in_.fail("a packed block reaches beyond the end of the file");
    }
    const std::uint64_t size = b + 1 == n_blocks && last > 0 ? last : full_block_;
    if (size > kMostInflation * (packed + 1)) in_.fail("a packed block claims more bytes than it can hold");
    begins_.push_back(begins_.back() + packed);
    n_bytes_ += size;
  }
  bytes_ = take(begins_.back(), is_base64);
}

std::uint64_t XmlData::block_size(std::size_t block) const {
  const std::size_t n_blocks = begins_.size() - 1;
  return block + 1 < n_blocks ? full_block_ : n_bytes_ - full_block_ * (n_blocks - 1);
}

std::string XmlData::unpacked(std::size_t block) const {
  const std::uint64_t size = block_size(block);
  const std::uint64_t n_packed = begins_[block + 1] - begins_[block];
  std::string raw(static_cast<std::size_t>(size), '\0');
  uLongf n = size;
  const int result =
      uncompress(reinterpret_cast<Bytef*>(raw.data()), &n,
                 reinterpret_cast<const Bytef*>(bytes_.data() + begins_[block]), static_cast<uLong>(n_packed));
  if (result != Z_OK || n != size) in_.fail("a packed block is damaged");
  return raw;
}

void XmlData::for_each_run(const std::function<void(std::string_view)>& take) const {
  if (begins_.empty()) return take(bytes_);
  const std::size_t n_blocks = begins_.size() - 1;
  for (std::size_t first = 0; first < n_blocks;) {
    std::uint64_t n_raw = 0;
    std::size_t end = first;
    while (end < n_blocks && (end == first || n_raw < kRawAtOnce)) n_raw += block_size(end++);
    std::vector<std::string> raw(end - first);
    parallel_blocks(raw.size(), 1, [&](std::size_t b, std::size_t) { raw[b] = unpacked(first + b); });
    for (const std::string& run : raw) take(run);
    first = end;
  }
}

}  // namespace nearwall::io

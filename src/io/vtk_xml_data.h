#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/cursor.h"

namespace nearwall::io {

/// How a VTK XML file stores the arrays that are not ascii.
struct XmlEncoding {
  std::endian order = std::endian::little;
  bool has_wide_headers = false;  ///< sizes of 64 bits instead of 32
  bool is_compressed = false;     ///< by zlib
  bool is_base64 = false;
};

/// The bytes of one array, inline or appended. They are unpacked block by block, never whole.
class XmlData {
 public:
  /// Reads the array's header at `where`. Its claims are held against the size of the file.
  XmlData(const Cursor& where, const XmlEncoding& encoding);
  XmlData(const XmlData&) = delete;
  XmlData& operator=(const XmlData&) = delete;

  std::uint64_t n_bytes() const { return n_bytes_; }
  /// Calls take(bytes) for one run of bytes after the other. Blocks are unpacked on several threads.
  void for_each_run(const std::function<void(std::string_view)>& take) const;

 private:
  void read_plain(const XmlEncoding& encoding);
  void read_blocks(const XmlEncoding& encoding);
  std::string_view take(std::uint64_t n, bool is_base64);
  std::uint64_t block_size(std::size_t block) const;
  std::string unpacked(std::size_t block) const;

  Cursor in_;
  std::uint64_t n_bytes_ = 0;
  std::string decoded_;                // what was base64
  std::string_view bytes_;             // of the file, or decoded_
  std::uint64_t full_block_ = 0;       // raw size of each block but the last
  std::vector<std::uint64_t> begins_;  // (n_blocks + 1) packed blocks in bytes_; empty: not compressed
};

}  // namespace nearwall::io

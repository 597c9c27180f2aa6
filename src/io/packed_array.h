#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/io/pending_file.h"

namespace nearwall::io {

/// Where finished bytes go.
using ByteSink = std::function<void(std::string_view)>;

/// One array of a VTK XML file on its way into it: takes raw values, keeps them as zlib blocks, on disk when they are
/// many. Blocks are cut at fixed places, so the bytes do not depend on how the values came or on the threads.
class PackedArray {
 public:
  /// \param type        "Float64", "Int32" ... as in the file
  /// \param spill_name  a path beside which large arrays may wait in a hidden file; empty: in memory whatever their
  /// size
  PackedArray(std::string name, std::string type, int components, std::filesystem::path spill_name);

  void append(std::string_view raw) { raw_ += raw; }
  template <class T>
  void append(std::span<const T> values) {
    append(std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
  }

  /// Bytes that the array takes in the file: its block table and its blocks. After `pack(arrays, true)`.
  std::uint64_t size() const;
  void copy_to(const ByteSink& write);
  /// The start of its tag: <DataArray type=… Name=… NumberOfComponents=…
  std::string tag() const;

  /// Compresses the whole blocks that the arrays hold by now, in parallel; with `all` also the rest.
  static void pack(std::span<PackedArray> arrays, bool all);

 private:
  struct Block {
    PackedArray* array;
    std::string_view raw;
    std::string packed;
  };
  void keep(const std::string& packed, std::size_t n_raw);

  std::string name_;
  std::string type_;
  int components_;
  std::filesystem::path spill_name_;
  std::string raw_;                   // not yet packed
  std::vector<std::uint64_t> sizes_;  // of the packed blocks
  std::uint64_t last_size_ = 0;       // raw size of the last block
  std::uint64_t packed_size_ = 0;
  std::string memory_;                  // packed blocks, up to the limit
  std::unique_ptr<PendingFile> spill_;  // the first packed blocks, if there are many; never committed
};

}  // namespace nearwall::io

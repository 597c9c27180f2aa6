#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/objects_hdf5.h"

namespace nearwall::io {

/// One array of an HDF5 file on its way into it: takes raw values, writes them as chunks packed by shuffle and zlib.
/// Chunks are cut at fixed places, so the bytes do not depend on how the values came or on the threads.
class ChunkedArray {
 public:
  /// \param parent      file or group
  /// \param type        of a number, as in the file and as in memory
  /// \param n_rows      how many there will be; of `components` numbers each, in one dimension if that is 1
  /// \param path        of the file, for messages
  ChunkedArray(hid_t parent, const std::string& name, hid_t type, std::uint64_t n_rows, std::uint64_t components,
               std::filesystem::path path);

  void append(std::string_view raw) { raw_ += raw; }

  /// Packs the whole chunks that the arrays hold by now, in parallel, and writes them; with `all` also the rest.
  /// \throws IoError
  static void pack(std::span<ChunkedArray> arrays, bool all);

 private:
  struct Chunk;
  void write(const Chunk& chunk);

  std::filesystem::path path_;
  Hdf5Object data_;
  std::size_t n_number_;          // bytes of a number
  std::size_t n_chunk_ = 1;       // bytes of a chunk
  std::uint64_t rows_chunk_ = 1;  // rows of a chunk
  std::uint64_t next_row_ = 0;
  bool is_plane_;
  std::string raw_;  // not yet packed
};

}  // namespace nearwall::io

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/objects_hdf5.h"

namespace nearwall::io {

/// Unpacks the chunks of an array one after the other. HDF5 1.10 itself trusts a damaged file that an unpacked chunk is
/// as large as it should be, and reads beyond it.
class ChunkReader {
 public:
  /// \returns false if the array is not in packed chunks of whole rows, by filters that are known here: shuffle,
  /// deflate
  bool open(hid_t data, const std::vector<hsize_t>& shape);

  /// Bytes of rows of the array as in the file. \returns false if they are damaged
  bool read(std::uint64_t first_row, std::uint64_t n_rows, std::string& out);
  /// Whether the array has packed chunks at all.
  bool has_filters() const { return has_filters_; }

 private:
  bool unpack(std::uint64_t chunk);

  hid_t data_ = H5I_INVALID_HID;
  std::vector<H5Z_filter_t> filters_;
  bool has_filters_ = false;
  std::uint64_t rows_chunk_ = 1;
  std::size_t rank_ = 1, n_number_ = 1, n_row_ = 1;  // bytes of a number, of a row
  std::uint64_t unpacked_ = UINT64_MAX;              // the chunk that is in values_
  std::string values_;
};

}  // namespace nearwall::io

#include "io/chunk_reader_hdf5.h"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace nearwall::io {
namespace {

/// Undoes HDF5's shuffle filter.
std::string in_order(const std::string& shuffled, std::size_t n_number) {
  std::string out = shuffled;
  const std::size_t n = shuffled.size() / n_number;
  for (std::size_t byte = 0; byte < n_number; ++byte) {
    for (std::size_t i = 0; i < n; ++i) out[i * n_number + byte] = shuffled[byte * n + i];
  }
  return out;
}

}  // namespace

bool ChunkReader::open(hid_t data, const std::vector<hsize_t>& shape) {
  const Hdf5Object properties(H5Dget_create_plist(data));
  if (!properties || H5Pget_layout(properties.id()) != H5D_CHUNKED || shape.empty()) return false;
  const int n_filters = H5Pget_nfilters(properties.id());
  has_filters_ = n_filters != 0;
  std::array<hsize_t, H5S_MAX_RANK> chunk{};
  const int rank = H5Pget_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data());
  if (n_filters <= 0 || rank != static_cast<int>(shape.size())) return false;
  const Hdf5Object type(H5Dget_type(data));
  n_row_ = n_number_ = H5Tget_size(type.id());
  for (std::size_t i = 1; i < shape.size(); ++i) {
    if (chunk[i] != shape[i]) return false;
    n_row_ *= shape[i];
  }
  for (unsigned i = 0; i < static_cast<unsigned>(n_filters); ++i) {
    unsigned flags = 0, config = 0;
    std::size_t n_values = 0;
    filters_.push_back(H5Pget_filter2(properties.id(), i, &flags, &n_values, nullptr, 0, nullptr, &config));
    if (filters_.back() != H5Z_FILTER_SHUFFLE && filters_.back() != H5Z_FILTER_DEFLATE) return false;
  }
  data_ = data;
  rank_ = shape.size();
  rows_chunk_ = chunk[0];
  return rows_chunk_ > 0;
}

bool ChunkReader::unpack(std::uint64_t chunk) {
  std::vector<hsize_t> offset(rank_, 0);
  offset[0] = chunk * rows_chunk_;
  const std::size_t n = rows_chunk_ * n_row_;
  hsize_t n_packed = 0;
  if (H5Dget_chunk_storage_size(data_, offset.data(), &n_packed) < 0) return false;
  if (n_packed == 0 || n_packed > compressBound(n)) return false;
  values_.assign(n_packed, '\0');
  std::uint32_t skipped = 0;
  if (H5Dread_chunk(data_, H5P_DEFAULT, offset.data(), &skipped, values_.data()) < 0) return false;
  for (std::size_t i = filters_.size(); i-- > 0;) {
    if (skipped >> i & 1u) continue;
    if (filters_[i] == H5Z_FILTER_SHUFFLE) {
      values_ = in_order(values_, n_number_);
      continue;
    }
    std::string unpacked(n, '\0');
    uLongf n_unpacked = n;
    if (uncompress(reinterpret_cast<Bytef*>(unpacked.data()), &n_unpacked,
                   reinterpret_cast<const Bytef*>(values_.data()), values_.size()) != Z_OK) {
      return false;
    }
    unpacked.resize(n_unpacked);
    values_ = std::move(unpacked);
  }
  unpacked_ = chunk;
  return values_.size() == n;
}

bool ChunkReader::read(std::uint64_t first_row, std::uint64_t n_rows, std::string& out) {
  out.clear();
  for (std::uint64_t row = first_row; row < first_row + n_rows;) {
    const std::uint64_t chunk = row / rows_chunk_, end = std::min((chunk + 1) * rows_chunk_, first_row + n_rows);
    if (unpacked_ != chunk && !unpack(chunk)) {
      unpacked_ = UINT64_MAX;
      return false;
    }
    out.append(values_, (row - chunk * rows_chunk_) * n_row_, (end - row) * n_row_);
    row = end;
  }
  return true;
}

}  // namespace nearwall::io

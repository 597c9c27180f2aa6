#include "io/chunked_array_hdf5.h"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kMostInChunk = std::size_t{1} << 18;  // raw bytes
constexpr int kFastest = 1;                                 // zlib's level; figures in docs/formats.md

/// HDF5's shuffle filter: the first bytes of all numbers, then the second ones, and so on.
std::string shuffled(std::string_view raw, std::size_t n_number) {
  std::string out(raw.size(), '\0');
  const std::size_t n = raw.size() / n_number;
  for (std::size_t byte = 0; byte < n_number; ++byte) {
    for (std::size_t i = 0; i < n; ++i) out[byte * n + i] = raw[i * n_number + byte];
  }
  return out;
}

std::string compressed(std::string_view raw) {
  uLongf n = compressBound(raw.size());
  std::string packed(n, '\0');
  expect(compress2(reinterpret_cast<Bytef*>(packed.data()), &n, reinterpret_cast<const Bytef*>(raw.data()), raw.size(),
                   kFastest) == Z_OK,
         "zlib packs a chunk");
  packed.resize(n);
  return packed;
}

}  // namespace

struct ChunkedArray::Chunk {
  ChunkedArray* array;
  std::string_view raw;
  std::string packed;
};

ChunkedArray::ChunkedArray(hid_t parent, const std::string& name, hid_t type, std::uint64_t n_rows,
                           std::uint64_t components, std::filesystem::path path)
    : path_(std::move(path)), is_plane_(components > 1) {
  const Hdf5Session session;
  n_number_ = H5Tget_size(type);
  const std::size_t n_row = n_number_ * components;
  const Hdf5Object properties(written(H5Pcreate(H5P_DATASET_CREATE), path_));
  written(H5Pset_obj_track_times(properties.id(), false), path_);
  const int n_dimensions = is_plane_ ? 2 : 1;
  if (n_rows > 0) {  // a chunk must not be larger than the array
    rows_chunk_ = std::min<std::uint64_t>(n_rows, kMostInChunk / n_row);
    n_chunk_ = rows_chunk_ * n_row;
    const std::array<hsize_t, 2> chunk = {rows_chunk_, components};
    written(H5Pset_chunk(properties.id(), n_dimensions, chunk.data()), path_);
    written(H5Pset_shuffle(properties.id()), path_);
    written(H5Pset_deflate(properties.id(), kFastest), path_);
  }
  const std::array<hsize_t, 2> shape = {n_rows, components};
  const Hdf5Object space(written(H5Screate_simple(n_dimensions, shape.data(), nullptr), path_));
  data_ = Hdf5Object(
      written(H5Dcreate2(parent, name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), path_));
}

void ChunkedArray::pack(std::span<ChunkedArray> arrays, bool all) {
  std::vector<Chunk> chunks;
  for (ChunkedArray& array : arrays) {
    // HDF5 has whole chunks only: what the last one lacks does not belong to the array.
    const std::size_t over = array.raw_.size() % array.n_chunk_;
    if (all && over > 0) array.raw_.resize(array.raw_.size() + array.n_chunk_ - over);
    for (std::string_view rest = array.raw_; rest.size() >= array.n_chunk_; rest.remove_prefix(array.n_chunk_)) {
      chunks.push_back({&array, rest.substr(0, array.n_chunk_), {}});
    }
  }
  parallel_blocks(chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      chunks[i].packed = compressed(shuffled(chunks[i].raw, chunks[i].array->n_number_));
    }
  });
  for (const Chunk& chunk : chunks) chunk.array->write(chunk);
  for (ChunkedArray& array : arrays) array.raw_.erase(0, array.raw_.size() / array.n_chunk_ * array.n_chunk_);
}

void ChunkedArray::write(const Chunk& chunk) {
  const Hdf5Session session;
  const std::array<hsize_t, 2> offset = {next_row_, 0};
  written(H5Dwrite_chunk(data_.id(), H5P_DEFAULT, 0, offset.data(), chunk.packed.size(), chunk.packed.data()), path_);
  next_row_ += rows_chunk_;
}

}  // namespace nearwall::io

#include "io/packed_array.h"

#include <fmt/format.h>
#include <zlib.h>

#include <fstream>
#include <utility>

#include "nearwall/core/errors.h"
#include "nearwall/core/expect.h"
#include "nearwall/core/parallel.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;     // raw bytes of a block
constexpr std::size_t kInMemory = std::size_t{1} << 24;  // packed bytes of an array that need no file
constexpr int kFastest = 1;                              // zlib's level; figures in docs/formats.md

std::string compressed(std::string_view raw) {
  uLongf n = compressBound(raw.size());
  std::string packed(n, '\0');
  expect(compress2(reinterpret_cast<Bytef*>(packed.data()), &n, reinterpret_cast<const Bytef*>(raw.data()), raw.size(),
                   kFastest) == Z_OK,
         "zlib packs a block");
  packed.resize(n);
  return packed;
}

std::string_view as_bytes(const std::vector<std::uint64_t>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(std::uint64_t)};
}

}  // namespace

PackedArray::PackedArray(std::string name, std::string type, int components, std::filesystem::path spill_name)
    : name_(std::move(name)), type_(std::move(type)), components_(components), spill_name_(std::move(spill_name)) {}

std::string PackedArray::tag() const {
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", type_, name_, components_);
}

void PackedArray::pack(std::span<PackedArray> arrays, bool all) {
  std::vector<Block> blocks;
  for (PackedArray& array : arrays) {
    std::string_view rest = array.raw_;
    while (rest.size() >= kBlock || (all && !rest.empty())) {
      blocks.push_back({&array, rest.substr(0, kBlock), {}});
      rest.remove_prefix(blocks.back().raw.size());
    }
  }
  parallel_blocks(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) blocks[i].packed = compressed(blocks[i].raw);
  });
  for (const Block& block : blocks) block.array->keep(block.packed, block.raw.size());
  for (PackedArray& array : arrays) array.raw_.erase(0, all ? array.raw_.size() : array.raw_.size() / kBlock * kBlock);
}

void PackedArray::keep(const std::string& packed, std::size_t n_raw) {
  sizes_.push_back(packed.size());
  last_size_ = n_raw;
  packed_size_ += packed.size();
  memory_ += packed;
  if (memory_.size() < kInMemory || spill_name_.empty()) return;
  if (!spill_) spill_ = std::make_unique<PendingFile>(spill_name_);
  spill_->write(memory_);
  memory_.clear();
}

std::uint64_t PackedArray::size() const { return (3 + sizes_.size()) * sizeof(std::uint64_t) + packed_size_; }

void PackedArray::copy_to(const ByteSink& write) {
  const std::uint64_t last = last_size_ == kBlock ? 0 : last_size_;  // the format's 0 says: as large as the others
  write(as_bytes({sizes_.size(), kBlock, last}));
  write(as_bytes(sizes_));
  if (spill_) {
    std::ifstream in(spill_->temporary(), std::ios::binary);
    std::string chunk(kInMemory, '\0');
    for (std::uint64_t left = spill_->size(); left > 0;) {
      in.read(chunk.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(left, chunk.size())));
      if (in.gcount() == 0) throw IoError(fmt::format("{}: cannot be read back", spill_->temporary().string()));
      write(std::string_view(chunk).substr(0, static_cast<std::size_t>(in.gcount())));
      left -= static_cast<std::uint64_t>(in.gcount());
    }
    spill_.reset();
  }
  write(std::exchange(memory_, {}));
}

}  // namespace nearwall::io

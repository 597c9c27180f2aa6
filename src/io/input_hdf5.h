#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/chunk_reader_hdf5.h"

/// HDF5 files of strangers: whatever is in them, reading gives values or a GeometryError. Only what the file itself
/// holds is read (no links to other files, no data kept outside), and sizes are held against that of the file before
/// memory is asked for.
namespace nearwall::io {

class Hdf5File;

/// An array of numbers of a file.
class Hdf5Array {
 public:
  std::uint64_t size() const { return size_; }  ///< of all dimensions together
  bool is_whole() const { return is_whole_; }   ///< integers
  const std::string& name() const { return name_; }

  /// Values from `first` on, row by row. \pre  they are there, and are whole rows \throws GeometryError
  void read(std::uint64_t first, std::span<std::int64_t> out) const;
  void read(std::uint64_t first, std::span<double> out) const;
  template <class T>
  std::vector<T> all() const {
    std::vector<T> values(size_);
    read(0, std::span<T>(values));
    return values;
  }
  /// Calls use(run of values) for n values from `first` on. \pre as above. Memory: a run.
  template <class T, class Use>
  void for_each_run(std::uint64_t first, std::uint64_t n, const Use& use) const {
    const std::uint64_t n_run = run_size(), end = first + n;
    std::vector<T> run;
    for (; first < end; first += run.size()) {
      run.resize(static_cast<std::size_t>(std::min(n_run, end - first)));
      read(first, std::span<T>(run));
      use(std::span<const T>(run));
    }
  }

 private:
  friend class Hdf5Group;
  std::uint64_t run_size() const;  // whole rows
  template <class T>
  void read_as(hid_t type, std::uint64_t first, std::span<T> out) const;
  template <class T>
  void read_packed(hid_t type, std::uint64_t first, std::span<T> out) const;

  const Hdf5File* file_ = nullptr;
  std::string name_;  // with those of its groups
  Hdf5Object data_;
  std::vector<hsize_t> shape_;
  std::uint64_t size_ = 0;
  bool is_whole_ = false;
  bool is_packed_ = false;
  mutable ChunkReader chunks_;  // keeps the chunk that it unpacked last
};

/// A group of a file.
class Hdf5Group {
 public:
  const std::string& name() const { return name_; }  ///< with those of its groups
  /// Names of what is in it, in the order in which it was made if the file knows that, else by name.
  std::vector<std::string> members() const;

  bool is_group(const std::string& name) const;
  /// None if there is nothing of that name. \throws GeometryError  if it is something else
  std::optional<Hdf5Group> group(const std::string& name) const;
  std::optional<Hdf5Array> array(const std::string& name) const;
  /// One that must be there. \throws GeometryError
  Hdf5Array required_array(const std::string& name) const;

  /// A text attribute without blanks and zeros at its end; empty if there is none.
  std::string text(const std::string& attribute) const;
  /// Bytes of a data set of characters or 8-bit numbers as a text; empty if there is none.
  std::string characters(const std::string& name) const;
  /// Texts of a data set of texts; empty if there is none.
  std::vector<std::string> texts(const std::string& name) const;

 private:
  friend class Hdf5File;
  Hdf5Group(const Hdf5File& file, std::string name, Hdf5Object group)
      : file_(&file), name_(std::move(name)), group_(std::move(group)) {}
  /// Opens a member that is in this file; not set if there is none.
  Hdf5Object member(const std::string& name) const;
  std::string path_of(const std::string& name) const;
  /// Opens a data set of at most that many bytes, held in this file.
  Hdf5Object data_set(const std::string& name) const;
  /// The same for texts, which nobody packs: HDF5 is not to unpack what may be damaged.
  Hdf5Object text_set(const std::string& name) const;

  const Hdf5File* file_;
  std::string name_;
  Hdf5Object group_;
};

/// An open file.
class Hdf5File {
 public:
  /// \throws GeometryError  if it is no HDF5 file, or cut off \throws IoError  if it cannot be opened
  explicit Hdf5File(const std::filesystem::path& path);
  Hdf5Group root() const;
  const std::string& name() const { return name_; }

  /// "FILE: WHAT" \throws GeometryError
  [[noreturn]] void fail(const std::string& what) const;
  /// The same with HDF5's words.
  [[noreturn]] void fail_in(const std::string& member) const;
  /// Whether the file can hold that many bytes, packed by zlib at the utmost.
  bool can_hold(std::uint64_t n_bytes) const { return n_bytes / kMostPacked <= size_; }

  /// The text that the reference at that byte of the file stands for. \throws GeometryError
  std::string heap_text(std::uint64_t at) const;

 private:
  std::string bytes_at(std::uint64_t at, std::size_t n) const;
  std::uint64_t number_at(std::uint64_t at, std::size_t n_bytes) const;
  static constexpr std::uint64_t kMostPacked = 1032;  // zlib's limit

  std::string name_;
  std::uint64_t size_ = 0;
  Hdf5Object file_;
};

}  // namespace nearwall::io

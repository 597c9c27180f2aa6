#pragma once

#include <hdf5.h>

#include <filesystem>
#include <string>
#include <utility>

#include "io/hdf5_session.h"

/// What readers and writers of HDF5 files share.
namespace nearwall::io {

/// Owns an HDF5 identifier of any kind: file, group, data set, type, list of properties.
class Hdf5Object {
 public:
  Hdf5Object() = default;
  explicit Hdf5Object(hid_t id) : id_(id) {}
  ~Hdf5Object() { reset(); }
  Hdf5Object(Hdf5Object&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Hdf5Object& operator=(Hdf5Object&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }

  hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  void reset() noexcept;

 private:
  hid_t id_ = H5I_INVALID_HID;
};

/// HDF5's own words on its last failure in this thread. \pre  the session in which it failed goes on
std::string hdf5_failure();

/// How files are opened: without locks, which some file systems refuse, and which a file under a hidden name needs not.
Hdf5Object unlocked_access();

/// For what HDF5 returns while a file is written: the value, unless it is negative. \throws IoError
template <class T>
T written(T value, const std::filesystem::path& path);
[[noreturn]] void fail_written(const std::filesystem::path& path);

template <class T>
T written(T value, const std::filesystem::path& path) {
  if (value < 0) fail_written(path);
  return value;
}

}  // namespace nearwall::io

#include "io/objects_hdf5.h"

#include <fmt/format.h>

#include <mutex>

#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

std::recursive_mutex& session_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

herr_t keep_innermost(unsigned, const H5E_error2_t* error, void* text) {
  auto& kept = *static_cast<std::string*>(text);
  if (kept.empty() && error->desc) kept = error->desc;
  return 0;
}

}  // namespace

Hdf5Session::Hdf5Session() {
  session_mutex().lock();
  // What HDF5 1.10 does at the end of the process crashes, or prints, after a file could not be closed or was damaged.
  // It must be told before its first use; all files are closed by hand.
  [[maybe_unused]] static const herr_t is_told = H5dont_atexit();
  H5Eget_auto2(H5E_DEFAULT, &printer_, &argument_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Session::~Hdf5Session() {
  H5Eset_auto2(H5E_DEFAULT, printer_, argument_);
  session_mutex().unlock();
}

void Hdf5Object::reset() noexcept {
  if (id_ < 0) return;
  const Hdf5Session session;
  H5Idec_ref(std::exchange(id_, H5I_INVALID_HID));
}

// No session of its own: to begin one clears what failed.
std::string hdf5_failure() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &text);
  return text.empty() ? "unknown error" : text;
}

Hdf5Object unlocked_access() {
  const Hdf5Session session;
  Hdf5Object access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_file_locking(access.id(), false, true);
  return access;
}

void fail_written(const std::filesystem::path& path) {
  throw IoError(fmt::format("{}: cannot be written: HDF5: {}", path.string(), hdf5_failure()));
}

}  // namespace nearwall::io

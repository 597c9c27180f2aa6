#include "io/input_hdf5.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kMostMembers = std::size_t{1} << 20;
constexpr std::size_t kMostText = std::size_t{1} << 20;  // bytes of a text

/// A member and when it was made; 0 where the file does not keep that.
using Named = std::pair<std::int64_t, std::string>;

herr_t add_name(hid_t, const char* name, const H5L_info_t* link, void* names) {
  auto& all = *static_cast<std::vector<Named>*>(names);
  all.emplace_back(link->corder_valid ? link->corder : 0, name);
  return all.size() < kMostMembers ? 0 : -1;
}

std::string trimmed_end(std::string text) {
  text.resize(std::min(text.find('\0'), text.size()));
  text.resize(text.find_last_not_of(' ') + 1);
  return text;
}

/// Bytes of the file's reference to a text of any length: its length, address of its heap, its number there.
constexpr std::size_t kReference = 16;

}  // namespace

Hdf5File::Hdf5File(const std::filesystem::path& path) : name_(path.string()) {
  if (!std::ifstream(path)) {
    throw IoError(fmt::format("{}: cannot be opened: {}", name_, std::system_category().message(errno)));
  }
  size_ = std::filesystem::file_size(path);
  const Hdf5Session session;
  if (H5Fis_hdf5(path.c_str()) <= 0) fail("expected an HDF5 file");
  const Hdf5Object access = unlocked_access();
  file_ = Hdf5Object(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()));
  if (!file_) fail(fmt::format("cut off or damaged: HDF5: {}", hdf5_failure()));
}

Hdf5Group Hdf5File::root() const {
  const Hdf5Session session;
  Hdf5Object group(H5Gopen2(file_.id(), "/", H5P_DEFAULT));
  if (!group) fail_in("/");
  return Hdf5Group(*this, "", std::move(group));
}

void Hdf5File::fail(const std::string& what) const { throw GeometryError(fmt::format("{}: {}", name_, what)); }

void Hdf5File::fail_in(const std::string& member) const {
  fail(fmt::format("{} is damaged: HDF5: {}", member, hdf5_failure()));
}

std::string Hdf5Group::path_of(const std::string& name) const { return fmt::format("{}/{}", name_, name); }

std::uint64_t Hdf5File::number_at(std::uint64_t at, std::size_t n_bytes) const {
  const std::string bytes = bytes_at(at, n_bytes);
  std::uint64_t value = 0;
  for (std::size_t i = n_bytes; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::string Hdf5File::bytes_at(std::uint64_t at, std::size_t n) const {
  std::ifstream in(name_, std::ios::binary);
  std::string bytes(n, '\0');
  if (at > size_ || n > size_ - at || !in.seekg(static_cast<std::streamoff>(at)) ||
      !in.read(bytes.data(), static_cast<std::streamsize>(n))) {
    fail(fmt::format("byte {}: cut off or damaged", at));
  }
  return bytes;
}

// HDF5 File Format Specification 3.0, III.E: a collection begins with "GCOL", a version, its size; objects have a
// number, a count of users, a size, and fill up to 8 bytes. HDF5 1.10 itself crashes on damaged ones.
std::string Hdf5File::heap_text(std::uint64_t at) const {
  const std::uint64_t length = number_at(at, 4), heap = number_at(at + 4, 8), wanted = number_at(at + 12, 4);
  if (length == 0) return {};
  if (bytes_at(heap, 4) != "GCOL") fail(fmt::format("byte {}: expected a heap of texts", heap));
  constexpr std::uint64_t kHead = 16;
  const std::uint64_t n_heap = number_at(heap + 8, 8);
  if (n_heap > size_ - heap) fail(fmt::format("byte {}: a heap of {} bytes", heap, n_heap));
  for (std::uint64_t object = heap + kHead; object + kHead <= heap + n_heap;) {
    const std::uint64_t number = number_at(object, 2), n = number_at(object + 8, 8);
    if (number == 0 || n > n_heap) break;
    if (number == wanted) {
      if (length > n) break;
      return trimmed_end(bytes_at(object + kHead, length));
    }
    object += kHead + (n + 7) / 8 * 8;
  }
  fail(fmt::format("byte {}: a text is not in its heap", at));
}

// Taken as they lie and sorted here: HDF5 1.10 crashes where it sorts those of a damaged group.
std::vector<std::string> Hdf5Group::members() const {
  const Hdf5Session session;
  std::vector<Named> found;
  if (H5Literate(group_.id(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add_name, &found) < 0) file_->fail_in(name_);
  std::sort(found.begin(), found.end());
  std::vector<std::string> names(found.size());
  std::transform(found.begin(), found.end(), names.begin(), [](const Named& each) { return each.second; });
  return names;
}

Hdf5Object Hdf5Group::member(const std::string& name) const {
  const htri_t is_there = H5Lexists(group_.id(), name.c_str(), H5P_DEFAULT);
  if (is_there < 0) file_->fail_in(path_of(name));
  if (is_there == 0) return {};
  H5L_info_t link;
  if (H5Lget_info(group_.id(), name.c_str(), &link, H5P_DEFAULT) < 0) file_->fail_in(path_of(name));
  if (link.type != H5L_TYPE_HARD) {
    throw InputError(fmt::format("{}: {} is a link, which is not followed: put the data into the file itself",
                                 file_->name(), path_of(name)));
  }
  Hdf5Object object(H5Oopen(group_.id(), name.c_str(), H5P_DEFAULT));
  if (!object) file_->fail_in(path_of(name));
  return object;
}

bool Hdf5Group::is_group(const std::string& name) const {
  const Hdf5Session session;
  const Hdf5Object object = member(name);
  return object && H5Iget_type(object.id()) == H5I_GROUP;
}

std::optional<Hdf5Group> Hdf5Group::group(const std::string& name) const {
  const Hdf5Session session;
  Hdf5Object object = member(name);
  if (!object) return std::nullopt;
  if (H5Iget_type(object.id()) != H5I_GROUP) file_->fail(fmt::format("{}: expected a group", path_of(name)));
  return Hdf5Group(*file_, path_of(name), std::move(object));
}

Hdf5Object Hdf5Group::data_set(const std::string& name) const {
  Hdf5Object object = member(name);
  if (!object) return object;
  const std::string path = path_of(name);
  if (H5Iget_type(object.id()) != H5I_DATASET) file_->fail(fmt::format("{}: expected a data set", path));
  const Hdf5Object properties(H5Dget_create_plist(object.id()));
  const Hdf5Object space(H5Dget_space(object.id()));
  const Hdf5Object type(H5Dget_type(object.id()));
  if (!properties || !space || !type) file_->fail_in(path);
  if (H5Pget_external_count(properties.id()) != 0 || H5Pget_layout(properties.id()) == H5D_VIRTUAL) {
    file_->fail(fmt::format("{}: its data are in other files", path));
  }
  const hssize_t n = H5Sget_simple_extent_npoints(space.id());
  const std::size_t n_each = H5Tget_size(type.id());
  const hsize_t n_stored = H5Dget_storage_size(object.id());
  if (n < 0 || n_each == 0) file_->fail_in(path);
  // What is not stored HDF5 makes up; texts of any length are stored elsewhere.
  const bool is_text = H5Tis_variable_str(type.id()) > 0;
  const std::uint64_t count = static_cast<std::uint64_t>(n);
  if (count > 0 && (count > UINT64_MAX / n_each || !file_->can_hold(count * n_each) || (n_stored == 0 && !is_text))) {
    file_->fail(fmt::format("{} claims {} values of {} bytes, more than the file holds", path, count, n_each));
  }
  if (H5Pget_layout(properties.id()) == H5D_CHUNKED) {
    std::array<hsize_t, H5S_MAX_RANK> chunk{};
    const int rank = H5Pget_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data());
    std::uint64_t n_chunk = n_each;
    for (int i = 0; i < rank; ++i) {
      const std::uint64_t side = std::max<std::uint64_t>(1, chunk[static_cast<std::size_t>(i)]);
      if (n_chunk > UINT64_MAX / side || !file_->can_hold(n_chunk * side)) {
        file_->fail(fmt::format("{} claims chunks larger than the file", path));
      }
      n_chunk *= side;
    }
  }
  return object;
}

std::optional<Hdf5Array> Hdf5Group::array(const std::string& name) const {
  const Hdf5Session session;
  Hdf5Array array;
  array.file_ = file_;
  array.name_ = path_of(name);
  array.data_ = data_set(name);
  if (!array.data_) return std::nullopt;
  const Hdf5Object type(H5Dget_type(array.data_.id()));
  const Hdf5Object space(H5Dget_space(array.data_.id()));
  const H5T_class_t kind = H5Tget_class(type.id());
  if (kind != H5T_INTEGER && kind != H5T_FLOAT) file_->fail(fmt::format("{}: expected numbers", array.name_));
  array.is_whole_ = kind == H5T_INTEGER;
  array.size_ = static_cast<std::uint64_t>(H5Sget_simple_extent_npoints(space.id()));
  array.shape_.resize(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.id()))));
  H5Sget_simple_extent_dims(space.id(), array.shape_.data(), nullptr);
  array.is_packed_ = array.size_ > 0 && array.chunks_.open(array.data_.id(), array.shape_);
  if (array.chunks_.has_filters() && !array.is_packed_) {
    throw InputError(fmt::format("{}: {} is packed in a way that is not read here: run h5repack -f GZIP=1 first",
                                 file_->name(), array.name_));
  }
  return array;
}

Hdf5Array Hdf5Group::required_array(const std::string& name) const {
  std::optional<Hdf5Array> found = array(name);
  if (!found) file_->fail(fmt::format("{} is missing", path_of(name)));
  return std::move(*found);
}

std::string Hdf5Group::text(const std::string& attribute) const {
  const Hdf5Session session;
  const htri_t is_there = H5Aexists(group_.id(), attribute.c_str());
  if (is_there < 0) file_->fail_in(name_);
  if (is_there == 0) return {};
  const Hdf5Object opened(H5Aopen(group_.id(), attribute.c_str(), H5P_DEFAULT));
  const Hdf5Object type(opened ? H5Aget_type(opened.id()) : H5I_INVALID_HID);
  const Hdf5Object space(opened ? H5Aget_space(opened.id()) : H5I_INVALID_HID);
  if (!type || !space) file_->fail_in(name_);
  const std::size_t n = H5Tget_size(type.id());
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0 ||
      H5Sget_simple_extent_npoints(space.id()) != 1 || n > kMostText) {
    file_->fail(fmt::format("{}: expected a text in the attribute {}", name_, attribute));
  }
  std::string text(n, '\0');
  if (H5Aread(opened.id(), type.id(), text.data()) < 0) file_->fail_in(name_);
  return trimmed_end(text);
}

Hdf5Object Hdf5Group::text_set(const std::string& name) const {
  Hdf5Object data = data_set(name);
  ChunkReader chunks;
  if (data && (chunks.open(data.id(), {1}) || chunks.has_filters())) {
    file_->fail(fmt::format("{}: expected a text that is not packed", path_of(name)));
  }
  return data;
}

std::string Hdf5Group::characters(const std::string& name) const {
  const Hdf5Session session;
  const Hdf5Object data = text_set(name);
  if (!data) return {};
  const Hdf5Object type(H5Dget_type(data.id()));
  const Hdf5Object space(H5Dget_space(data.id()));
  const auto n = static_cast<std::uint64_t>(H5Sget_simple_extent_npoints(space.id()));
  if (H5Tget_class(type.id()) != H5T_INTEGER || H5Tget_size(type.id()) != 1 || n > kMostText) {
    file_->fail(fmt::format("{}: expected a text", path_of(name)));
  }
  std::string text(n, '\0');
  if (H5Dread(data.id(), H5T_NATIVE_CHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) {
    file_->fail_in(path_of(name));
  }
  return trimmed_end(text);
}

std::vector<std::string> Hdf5Group::texts(const std::string& name) const {
  const Hdf5Session session;
  const Hdf5Object data = text_set(name);
  if (!data) return {};
  const Hdf5Object type(H5Dget_type(data.id()));
  const Hdf5Object space(H5Dget_space(data.id()));
  const auto n = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id()));
  if (H5Tget_class(type.id()) != H5T_STRING || n > kMostMembers) {
    file_->fail(fmt::format("{}: expected texts", path_of(name)));
  }
  std::vector<std::string> texts(n);
  if (n == 0) return texts;
  if (H5Tis_variable_str(type.id()) > 0) {
    const haddr_t at = H5Dget_offset(data.id());
    if (at == HADDR_UNDEF) file_->fail(fmt::format("{}: expected texts in one piece", path_of(name)));
    for (std::size_t i = 0; i < n; ++i) texts[i] = file_->heap_text(at + i * kReference);
    return texts;
  }
  const std::size_t n_each = H5Tget_size(type.id());
  std::string together(n * n_each, '\0');
  if (H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, together.data()) < 0) {
    file_->fail_in(path_of(name));
  }
  for (std::size_t i = 0; i < n; ++i) texts[i] = trimmed_end(together.substr(i * n_each, n_each));
  return texts;
}

std::uint64_t Hdf5Array::run_size() const {
  constexpr std::uint64_t kRun = std::uint64_t{1} << 18;
  const std::uint64_t row = shape_.empty() || shape_[0] == 0 ? 1 : size_ / shape_[0];
  return std::max<std::uint64_t>(1, kRun / row) * row;
}

template <class T>
void Hdf5Array::read_packed(hid_t type, std::uint64_t first, std::span<T> out) const {
  const std::uint64_t row = size_ / shape_[0];
  std::string bytes;
  if (first % row != 0 || out.size() % row != 0 || !chunks_.read(first / row, out.size() / row, bytes)) {
    file_->fail(fmt::format("{} is damaged: its packed data do not fit its size", name_));
  }
  const Hdf5Object stored(H5Dget_type(data_.id()));
  // Converted in place, and types in files may be wider than in memory.
  bytes.resize(std::max(bytes.size(), out.size_bytes()));
  if (H5Tconvert(stored.id(), type, out.size(), bytes.data(), nullptr, H5P_DEFAULT) < 0) file_->fail_in(name_);
  std::memcpy(out.data(), bytes.data(), out.size_bytes());
}

template <class T>
void Hdf5Array::read_as(hid_t type, std::uint64_t first, std::span<T> out) const {
  if (out.empty()) return;
  const Hdf5Session session;
  if (is_packed_) return read_packed(type, first, out);
  const Hdf5Object space(H5Dget_space(data_.id()));
  if (out.size() < size_ && !shape_.empty()) {
    const std::uint64_t row = size_ / shape_[0];
    std::vector<hsize_t> begin(shape_.size(), 0), count(shape_.begin(), shape_.end());
    begin[0] = first / row;
    count[0] = out.size() / row;
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr) < 0) {
      file_->fail_in(name_);
    }
  }
  const hsize_t n = out.size();
  const Hdf5Object memory(H5Screate_simple(1, &n, nullptr));
  if (H5Dread(data_.id(), type, memory.id(), space.id(), H5P_DEFAULT, out.data()) < 0) file_->fail_in(name_);
}

void Hdf5Array::read(std::uint64_t first, std::span<std::int64_t> out) const {
  if (!is_whole_) file_->fail(fmt::format("{}: expected whole numbers", name_));
  read_as(H5T_NATIVE_INT64, first, out);
}

void Hdf5Array::read(std::uint64_t first, std::span<double> out) const { read_as(H5T_NATIVE_DOUBLE, first, out); }

}  // namespace nearwall::io

#include "nearwall/io/vtkhdf_writer.h"

#include <array>
#include <string>
#include <vector>

#include "io/chunked_array_hdf5.h"
#include "io/vtk_batches.h"
#include "nearwall/io/pending_file.h"

namespace nearwall::io {
namespace {

constexpr bool kHasWideIds = true;  // the format's numbers of points and cells have 64 bits

class VtkHdfWriter {
 public:
  VtkHdfWriter(const std::filesystem::path& path, const mesh::MeshSource& mesh, std::span<const CellArray> extra)
      : pending_(path), mesh_(mesh), extra_(extra) {
    const Hdf5Session session;
    const Hdf5Object access = unlocked_access();
    file_ = Hdf5Object(
        written(H5Fcreate(pending_.temporary().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), pending_.path()));
    root_ = group(file_.id(), "VTKHDF");
    point_data_ = group(root_.id(), "PointData");
    cell_data_ = group(root_.id(), "CellData");
    write_head();
    add_arrays();
  }

  void write(const VtuMetadata& metadata, ProgressSink& progress) {
    // Where the first cell's nodes begin: one offset more than there are cells.
    cells_[VtkBatches::Offsets].append(std::string(sizeof(std::int64_t), '\0'));
    VtkBatches(mesh_, extra_, kHasWideIds).pack(points_, cells_, progress);
    write_patch_names(metadata.patch_names);
    close();
    pending_.commit();
  }

 private:
  template <class T>
  T checked(T value) const {
    return written(value, pending_.path());
  }

  Hdf5Object group(hid_t parent, const char* name) const {
    const Hdf5Object properties(checked(H5Pcreate(H5P_GROUP_CREATE)));
    checked(H5Pset_obj_track_times(properties.id(), false));
    return Hdf5Object(checked(H5Gcreate2(parent, name, H5P_DEFAULT, properties.id(), H5P_DEFAULT)));
  }

  void write_head() const {
    const std::array<std::int64_t, 2> version = {1, 0};
    const hsize_t n_version = version.size();
    const Hdf5Object pair(checked(H5Screate_simple(1, &n_version, nullptr)));
    const Hdf5Object attribute(
        checked(H5Acreate2(root_.id(), "Version", H5T_NATIVE_INT64, pair.id(), H5P_DEFAULT, H5P_DEFAULT)));
    checked(H5Awrite(attribute.id(), H5T_NATIVE_INT64, version.data()));

    const std::string type = "UnstructuredGrid";
    const Hdf5Object text(checked(H5Tcopy(H5T_C_S1)));
    checked(H5Tset_size(text.id(), type.size()));
    checked(H5Tset_strpad(text.id(), H5T_STR_NULLPAD));
    const Hdf5Object one(checked(H5Screate(H5S_SCALAR)));
    const Hdf5Object kind(checked(H5Acreate2(root_.id(), "Type", text.id(), one.id(), H5P_DEFAULT, H5P_DEFAULT)));
    checked(H5Awrite(kind.id(), text.id(), type.data()));

    write_array("NumberOfPoints", H5T_NATIVE_INT64, std::array{static_cast<std::int64_t>(mesh_.n_points())});
    write_array("NumberOfCells", H5T_NATIVE_INT64, std::array{static_cast<std::int64_t>(mesh_.n_cells())});
    write_array("NumberOfConnectivityIds", H5T_NATIVE_INT64,
                std::array{static_cast<std::int64_t>(n_connections(mesh_))});
  }

  void add_arrays() {
    const auto add = [&](std::vector<ChunkedArray>& to, const Hdf5Object& parent, const std::string& name, hid_t type,
                         std::uint64_t n_rows, std::uint64_t components) {
      to.emplace_back(parent.id(), name, type, n_rows, components, pending_.path());
    };
    const std::uint64_t n_points = mesh_.n_points(), n_cells = mesh_.n_cells();
    add(points_, root_, "Points", H5T_NATIVE_DOUBLE, n_points, 3);
    add(points_, point_data_, "Line", H5T_NATIVE_INT64, n_points, 1);
    add(points_, point_data_, "Level", H5T_NATIVE_INT32, n_points, 1);
    add(cells_, root_, "Connectivity", H5T_NATIVE_INT64, n_connections(mesh_), 1);
    add(cells_, root_, "Offsets", H5T_NATIVE_INT64, n_cells + 1, 1);
    add(cells_, root_, "Types", H5T_NATIVE_UINT8, n_cells, 1);
    add(cells_, cell_data_, "Layer", H5T_NATIVE_INT32, n_cells, 1);
    add(cells_, cell_data_, "Column", H5T_NATIVE_INT64, n_cells, 1);
    add(cells_, cell_data_, "Patch", H5T_NATIVE_INT32, n_cells, 1);
    for (const CellArray& array : extra_) add(cells_, cell_data_, array.name, H5T_NATIVE_DOUBLE, n_cells, 1);
  }

  template <class Values>
  void write_array(const char* name, hid_t type, const Values& values) const {
    const hsize_t n = values.size();
    const Hdf5Object space(checked(H5Screate_simple(1, &n, nullptr)));
    write_data(root_.id(), name, type, space, values.data());
  }

  void write_data(hid_t parent, const char* name, hid_t type, const Hdf5Object& space, const void* values) const {
    const Hdf5Object properties(checked(H5Pcreate(H5P_DATASET_CREATE)));
    checked(H5Pset_obj_track_times(properties.id(), false));
    const Hdf5Object data(
        checked(H5Dcreate2(parent, name, type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT)));
    checked(H5Dwrite(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  }

  /// As VTK 9.1 reads text: of variable length, declared as ASCII whatever it is.
  void write_patch_names(const std::vector<std::string>& names) const {
    if (names.empty()) return;
    const Hdf5Session session;
    std::vector<const char*> texts;
    for (const std::string& name : names) texts.push_back(name.c_str());
    const Hdf5Object type(checked(H5Tcopy(H5T_C_S1)));
    checked(H5Tset_size(type.id(), H5T_VARIABLE));
    const hsize_t n = texts.size();
    const Hdf5Object space(checked(H5Screate_simple(1, &n, nullptr)));
    const Hdf5Object parent = group(root_.id(), "FieldData");
    write_data(parent.id(), "PatchNames", type.id(), space, texts.data());
  }

  /// Closes the file by hand: what fails then must be seen.
  void close() {
    const Hdf5Session session;
    points_.clear();
    cells_.clear();
    for (Hdf5Object* object : {&point_data_, &cell_data_, &root_}) object->reset();
    checked(H5Fflush(file_.id(), H5F_SCOPE_LOCAL));
    file_.reset();
  }

  PendingFile pending_;
  const mesh::MeshSource& mesh_;
  std::span<const CellArray> extra_;
  Hdf5Object file_, root_, point_data_, cell_data_;
  std::vector<ChunkedArray> points_, cells_;
};

}  // namespace

void write_vtkhdf(const std::filesystem::path& path, const mesh::MeshSource& mesh, std::span<const CellArray> extra,
                  const VtuMetadata& metadata, ProgressSink* progress) {
  VtkHdfWriter(path, mesh, extra).write(metadata, progress ? *progress : silent_progress());
}

}  // namespace nearwall::io

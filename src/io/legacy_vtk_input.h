#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/cursor.h"
#include "io/polydata_input.h"
#include "io/scalar_type.h"

namespace nearwall::io {

class PointArrays;

/// Points and cells of an unstructured grid, as the file has them.
struct LegacyGrid {
  std::vector<Vec3> points;
  std::vector<std::int64_t> types;  ///< VTK's numbers
  CellList cells;
};

/// A legacy VTK file as both its readers see it, surfaces' and meshes': the header, points, cells, numbers in ascii and
/// binary, and all the sections that stand in any data set. What may be patch numbers or their names is kept.
class LegacyVtkInput {
 public:
  /// Reads the header. The bytes must outlive it.
  LegacyVtkInput(std::string_view bytes, const std::string& file);

  std::string_view dataset() const { return dataset_; }  ///< POLYDATA, UNSTRUCTURED_GRID ...
  Cursor& cursor() { return in_; }

  /// The keyword of the next section; empty at the end of the file.
  std::string_view next_section() { return in_.word(); }
  std::vector<Vec3> read_points();
  /// Cells in the form of the file's version: sizes and points in one list, or from 5.1 on offsets.
  CellList read_cells();
  /// `n` values of `type`, which follow. \throws GeometryError if the file is too short for them.
  std::vector<std::int64_t> read_integers(std::int64_t n, ScalarType type) { return read_all<std::int64_t>(n, type); }
  /// Sections of any data set: METADATA, FIELD, CELL_DATA, POINT_DATA and the arrays in them.
  void read_other(std::string_view keyword);

  /// All sections of an UNSTRUCTURED_GRID up to the end of the file. Counts are not held against each other.
  LegacyGrid read_grid();

  /// From now on point data of one number each goes there.
  void keep_point_arrays(PointArrays& arrays) { point_arrays_ = &arrays; }
  std::vector<PolyDataInput::IntegerArray> take_cell_arrays() { return std::move(cell_arrays_); }
  std::vector<std::string> take_patch_names() { return std::move(patch_names_); }

 private:
  void skip_metadata();
  CellList read_counted_cells(std::size_t n_cells, std::size_t size);
  CellList read_offset_cells(std::size_t n_offsets, std::size_t size);
  void read_field();
  void read_attribute(std::string_view keyword);
  void read_array(const std::string& name, std::int64_t n_components, std::int64_t n);
  void read_values(const std::string& name, std::int64_t n_components, std::int64_t n, ScalarType type);
  void read_strings(const std::string& name, std::int64_t n_components, std::int64_t n);
  std::size_t string_length();
  void skip_values(std::int64_t n_components, std::int64_t n, ScalarType type);
  std::int64_t total(std::int64_t n_components, std::int64_t n) const;
  ScalarType read_type();
  std::size_t least_bytes(ScalarType type) const;
  void begin_values();
  template <class T>
  T next(ScalarType type);
  template <class T>
  std::vector<T> read_all(std::int64_t n, ScalarType type);

  Cursor in_;
  std::string_view dataset_;
  std::vector<PolyDataInput::IntegerArray> cell_arrays_;
  std::vector<std::string> patch_names_;
  PointArrays* point_arrays_ = nullptr;
  bool is_ascii_ = true;
  bool has_offsets_ = false;
  bool in_cell_data_ = false;
  bool in_point_data_ = false;
  std::int64_t n_tuples_ = 0;
};

}  // namespace nearwall::io

#include "io/vtk_batches.h"

#include "io/vtk_cells.h"

namespace nearwall::io {
namespace {

using mesh::CellBatch;
using mesh::CellType;
using mesh::PointBatch;

template <class T>
void append_value(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

template <class T>
void append_values(std::string& out, const std::vector<T>& values) {
  out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

}  // namespace

std::uint64_t n_connections(const mesh::MeshSource& mesh) {
  std::uint64_t n = 0;
  const auto counts = mesh.n_cells_by_type();
  for (std::size_t type = 0; type < counts.size(); ++type)
    n += counts[type] * static_cast<std::uint64_t>(mesh::kCellSize[type]);
  return n;
}

void VtkBatches::read_points(std::size_t batch, RawArrays& raw) const {
  PointBatch points;
  mesh_.read_points(batch, points);
  raw[Coordinates].reserve(points.size() * 3 * sizeof(double));
  for (const Vec3& p : points.position) {
    for (int axis = 0; axis < 3; ++axis) append_value(raw[Coordinates], p[axis]);
  }
  append_values(raw[Line], points.line);
  append_values(raw[Level], points.level);
}

void VtkBatches::read_cells(std::size_t batch, RawArrays& raw) const {
  CellBatch cells;
  mesh_.read_cells(batch, cells);
  has_wide_ids_ ? append_nodes<std::int64_t>(cells, raw) : append_nodes<std::int32_t>(cells, raw);
  append_values(raw[Layer], cells.layer);
  append_values(raw[Column], cells.column);
  append_values(raw[Patch], cells.patch);
  std::vector<double> values(cells.size());
  for (std::size_t i = 0; i < extra_.size(); ++i) {
    extra_[i].fill(cells, values);
    append_values(raw[FirstExtra + i], values);
  }
}

template <class IdType>
void VtkBatches::append_nodes(const CellBatch& cells, RawArrays& raw) const {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const CellType type = cells.type[c];
    const VtkCell& vtk = kVtkCells[static_cast<std::size_t>(type)];
    for (int k = 0; k < mesh::size_of(type); ++k) {
      append_value(raw[Connectivity], static_cast<IdType>(cells.nodes[c][vtk.node[k]]));
    }
    append_value(raw[Types], vtk.code);
  }
}

/// Where each cell's nodes end, counted over all batches so far.
template <class IdType>
void VtkBatches::append_offsets(RawArrays& raw) {
  for (const char code : raw[Types]) {
    n_nodes_so_far_ += kVtkMeanings[static_cast<unsigned char>(code)].size;
    append_value(raw[Offsets], static_cast<IdType>(n_nodes_so_far_));
  }
}

template void VtkBatches::append_offsets<std::int32_t>(RawArrays&);
template void VtkBatches::append_offsets<std::int64_t>(RawArrays&);

}  // namespace nearwall::io

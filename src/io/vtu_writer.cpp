#include "nearwall/io/vtu_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/batches.h"
#include "io/vtk_cells.h"
#include "io/vtk_xml_output.h"
#include "nearwall/core/markup.h"

namespace nearwall::io {
namespace {

using mesh::CellBatch;
using mesh::CellType;
using mesh::PointBatch;

std::uint64_t n_connections(const mesh::MeshSource& mesh) {
  std::uint64_t n = 0;
  const auto counts = mesh.n_cells_by_type();
  for (std::size_t type = 0; type < counts.size(); ++type)
    n += counts[type] * static_cast<std::uint64_t>(mesh::kCellSize[type]);
  return n;
}

template <class T>
void append_value(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

template <class T>
void append_values(std::string& out, const std::vector<T>& values) {
  out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

using RawArrays = std::vector<std::string>;  // the bytes that a batch adds to each array

/// Reads the batches of a source, some at once, and packs what they add to the arrays in their order.
/// read(batch, raw) runs on several threads; then in_order(batch, raw) on one, batch after batch.
template <class Read, class InOrder>
void pack_batches(std::size_t n_batches, std::span<PackedArray> arrays, const Read& read, const InOrder& in_order) {
  in_batches(
      n_batches,
      [&](std::size_t batch) {
        RawArrays raw(arrays.size());
        read(batch, raw);
        return raw;
      },
      [&](std::size_t batch, RawArrays& raw) {
        in_order(batch, raw);
        for (std::size_t a = 0; a < arrays.size(); ++a) arrays[a].append(raw[a]);
        RawArrays().swap(raw);
        if (batch % kBatchesAtOnce == kBatchesAtOnce - 1) PackedArray::pack(arrays, false);
      });
  PackedArray::pack(arrays, true);
}

class VtuWriter {
 public:
  VtuWriter(const std::filesystem::path& path, const mesh::MeshSource& mesh, std::span<const CellArray> extra)
      : file_(path), mesh_(mesh), extra_(extra) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
    has_wide_ids_ = mesh.n_points() > kMost || n_connections(mesh) > kMost;
    const std::string id = has_wide_ids_ ? "Int64" : "Int32";
    const auto add = [&](std::vector<PackedArray>& to, const std::string& name, const std::string& type,
                         int components) { to.emplace_back(name, type, components, path); };
    add(points_, "Points", "Float64", 3);
    add(points_, "Line", "Int64", 1);
    add(points_, "Level", "Int32", 1);
    add(cells_, "connectivity", id, 1);
    add(cells_, "offsets", id, 1);
    add(cells_, "types", "UInt8", 1);
    add(cells_, "Layer", "Int32", 1);
    add(cells_, "Column", "Int64", 1);
    add(cells_, "Patch", "Int32", 1);
    for (const CellArray& array : extra) add(cells_, escaped_markup(array.name), "Float64", 1);
  }

  void write(const VtuMetadata& metadata, ProgressSink& progress) {
    const std::size_t n_point_batches = mesh_.n_point_batches();
    const std::size_t n_batches = n_point_batches + mesh_.n_cell_batches();
    const auto report = [&](std::size_t batch) {
      progress.update(static_cast<double>(batch + 1) / static_cast<double>(n_batches));
    };
    pack_batches(
        n_point_batches, points_, [&](std::size_t batch, RawArrays& raw) { read_points(batch, raw); },
        [&](std::size_t batch, RawArrays&) { report(batch); });
    pack_batches(
        mesh_.n_cell_batches(), cells_, [&](std::size_t batch, RawArrays& raw) { read_cells(batch, raw); },
        [&](std::size_t batch, RawArrays& raw) {
          has_wide_ids_ ? append_offsets<std::int64_t>(raw) : append_offsets<std::int32_t>(raw);
          report(n_point_batches + batch);
        });
    lay_out(metadata);
    file_.commit();
  }

 private:
  // Places in points_ and cells_.
  enum PointArrayIndex { Coordinates, Line, Level };
  enum CellArrayIndex { Connectivity, Offsets, Types, Layer, Column, Patch, FirstExtra };

  void read_points(std::size_t batch, RawArrays& raw) const {
    PointBatch points;
    mesh_.read_points(batch, points);
    raw[Coordinates].reserve(points.size() * 3 * sizeof(double));
    for (const Vec3& p : points.position) {
      for (int axis = 0; axis < 3; ++axis) append_value(raw[Coordinates], p[axis]);
    }
    append_values(raw[Line], points.line);
    append_values(raw[Level], points.level);
  }

  void read_cells(std::size_t batch, RawArrays& raw) const {
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
  void append_nodes(const CellBatch& cells, RawArrays& raw) const {
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
  void append_offsets(RawArrays& raw) {
    for (const char code : raw[Types]) {
      n_nodes_so_far_ += kVtkMeanings[static_cast<unsigned char>(code)].size;
      append_value(raw[Offsets], static_cast<IdType>(n_nodes_so_far_));
    }
  }

  void lay_out(const VtuMetadata& metadata) {
    VtkXmlOutput out("UnstructuredGrid");
    out.open("FieldData");
    out.add_strings("PatchNames", metadata.patch_names);
    out.close("FieldData");
    out.open(fmt::format("Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", mesh_.n_points(), mesh_.n_cells()));
    out.open("PointData");
    for (const int i : {Line, Level}) out.add(points_[i]);
    out.close("PointData");
    out.open("CellData");
    for (std::size_t i = Layer; i < cells_.size(); ++i) out.add(cells_[i]);
    out.close("CellData");
    out.open("Points");
    out.add(points_[Coordinates]);
    out.close("Points");
    out.open("Cells");
    for (const int i : {Connectivity, Offsets, Types}) out.add(cells_[i]);
    out.close("Cells");
    out.close("Piece");
    out.write_to([&](std::string_view bytes) { file_.write(bytes); });
  }

  PendingFile file_;
  const mesh::MeshSource& mesh_;
  std::span<const CellArray> extra_;
  bool has_wide_ids_ = false;
  std::uint64_t n_nodes_so_far_ = 0;
  std::vector<PackedArray> points_;
  std::vector<PackedArray> cells_;
};

}  // namespace

CellArray numbers_in_file(const mesh::VolumeSource& source) {
  return {"Cell", [&source](const CellBatch& cells, std::span<double> out) {
            for (std::size_t i = 0; i < out.size(); ++i)
              out[i] = static_cast<double>(source.file_cell(cells.first + i));
          }};
}

void write_vtu(const std::filesystem::path& path, const mesh::MeshSource& mesh, std::span<const CellArray> extra,
               const VtuMetadata& metadata, ProgressSink* progress) {
  VtuWriter(path, mesh, extra).write(metadata, progress ? *progress : silent_progress());
}

}  // namespace nearwall::io

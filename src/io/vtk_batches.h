#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/batches.h"
#include "nearwall/io/vtu_writer.h"

/// What files of VTK hold of a mesh, batch by batch: the one place that both its forms, XML and HDF5, take it from.
namespace nearwall::io {

using RawArrays = std::vector<std::string>;  // the bytes that a batch adds to each array

/// Reads the batches of a source, some at once, and packs what they add to the arrays in their order.
/// read(batch, raw) runs on several threads; then in_order(batch, raw) on one, batch after batch.
template <class Array, class Read, class InOrder>
void pack_batches(std::size_t n_batches, std::vector<Array>& arrays, const Read& read, const InOrder& in_order) {
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
        if (batch % kBatchesAtOnce == kBatchesAtOnce - 1) Array::pack(arrays, false);
      });
  Array::pack(arrays, true);
}

/// The arrays of a mesh, in these orders; further arrays of the cells follow. Nodes and offsets have 32 or 64 bits.
class VtkBatches {
 public:
  enum PointArrayIndex { Coordinates, Line, Level };
  enum CellArrayIndex { Connectivity, Offsets, Types, Layer, Column, Patch, FirstExtra };

  VtkBatches(const mesh::MeshSource& mesh, std::span<const CellArray> extra, bool has_wide_ids)
      : mesh_(mesh), extra_(extra), has_wide_ids_(has_wide_ids) {}

  /// Packs all batches, points first.
  template <class Array>
  void pack(std::vector<Array>& points, std::vector<Array>& cells, ProgressSink& progress) {
    const std::size_t n_point_batches = mesh_.n_point_batches(), n_batches = n_point_batches + mesh_.n_cell_batches();
    const auto report = [&](std::size_t batch) {
      progress.update(static_cast<double>(batch + 1) / static_cast<double>(n_batches));
    };
    pack_batches(
        n_point_batches, points, [&](std::size_t batch, RawArrays& raw) { read_points(batch, raw); },
        [&](std::size_t batch, RawArrays&) { report(batch); });
    pack_batches(
        mesh_.n_cell_batches(), cells, [&](std::size_t batch, RawArrays& raw) { read_cells(batch, raw); },
        [&](std::size_t batch, RawArrays& raw) {
          has_wide_ids_ ? append_offsets<std::int64_t>(raw) : append_offsets<std::int32_t>(raw);
          report(n_point_batches + batch);
        });
  }

 private:
  void read_points(std::size_t batch, RawArrays& raw) const;
  void read_cells(std::size_t batch, RawArrays& raw) const;
  template <class IdType>
  void append_nodes(const mesh::CellBatch& cells, RawArrays& raw) const;
  template <class IdType>
  void append_offsets(RawArrays& raw);

  const mesh::MeshSource& mesh_;
  std::span<const CellArray> extra_;
  bool has_wide_ids_;
  std::uint64_t n_nodes_so_far_ = 0;
};

/// Nodes of all cells.
std::uint64_t n_connections(const mesh::MeshSource& mesh);

}  // namespace nearwall::io

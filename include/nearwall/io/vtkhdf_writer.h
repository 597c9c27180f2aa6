#pragma once

#include <filesystem>
#include <span>

#include "nearwall/core/progress.h"
#include "nearwall/io/vtu_writer.h"

namespace nearwall::io {

/// Writes a volume mesh as VTKHDF (an unstructured grid in HDF5): the same cells, arrays and field data as `write_vtu`,
/// compressed. The source is read once. Memory: some batches, not the mesh; no hidden files.
/// The same bytes for the same mesh at any number of threads. \throws IoError  disk full, no permission
void write_vtkhdf(const std::filesystem::path& path, const mesh::MeshSource& mesh, std::span<const CellArray> extra,
                  const VtuMetadata& metadata, ProgressSink* progress = nullptr);

}  // namespace nearwall::io

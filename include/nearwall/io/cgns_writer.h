#pragma once

#include <filesystem>

#include "nearwall/core/progress.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {

/// Writes a mesh as CGNS (HDF5): one zone, sections by type of cell, a boundary condition and a family for each patch.
/// The same bytes for the same mesh at any number of threads. Memory: some batches, not the mesh.
/// \throws InputError  more points, cells or nodes than the format's 32-bit numbers hold, before anything is written
///         IoError     disk full, no permission
void write_cgns(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink* progress = nullptr);

}  // namespace nearwall::io

#pragma once

#include <filesystem>

#include "nearwall/core/progress.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {

/// Writes a mesh in SU2's native format (text): points, cells in the source's order, a marker for each patch. Doubles
/// as short as reads back to the same bits. The format knows no groups of cells.
/// The same bytes for the same mesh at any number of threads. Memory: some batches, not the mesh.
/// \throws IoError  disk full, no permission
void write_su2(const std::filesystem::path& path, const WholeMesh& mesh, ProgressSink* progress = nullptr);

}  // namespace nearwall::io

#pragma once

#include <filesystem>

#include "nearwall/core/progress.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {

enum class MshVersion {
  V41,  ///< 4.1, binary
  V22,  ///< 2.2, text: for programs that read no other
};

/// Writes a mesh in Gmsh's format: a physical surface for each patch, physical volumes `layers` and `rest`.
/// The same bytes for the same mesh at any number of threads. Memory: some batches, not the mesh.
/// \throws InputError  V22: more points, or cells and faces, than its 32-bit numbers hold, before anything is written
///         IoError     disk full, no permission
void write_msh(const std::filesystem::path& path, const WholeMesh& mesh, MshVersion version,
               ProgressSink* progress = nullptr);

}  // namespace nearwall::io

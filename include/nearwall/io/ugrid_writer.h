#pragma once

#include <filesystem>

#include "nearwall/core/progress.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {

/// How numbers stand in the file.
enum class UgridForm {
  Ascii,         ///< .ugrid
  BigEndian,     ///< .b8.ugrid: 32-bit integers, doubles
  LittleEndian,  ///< .lb8.ugrid
};

/// Writes a mesh as AFLR3's UGRID, and NAME.mapbc beside it with the names of the patches and FUN3D's boundary
/// conditions. Cells are sorted by type, as the format is. It knows no groups of cells.
/// The same bytes for the same mesh at any number of threads. Memory: some batches, not the mesh.
/// \throws InputError  more points, cells or nodes than the format's 32-bit numbers hold, before anything is written
///         IoError     disk full, no permission
void write_ugrid(const std::filesystem::path& path, const WholeMesh& mesh, UgridForm form,
                 ProgressSink* progress = nullptr);

}  // namespace nearwall::io

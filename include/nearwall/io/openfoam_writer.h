#pragma once

#include <filesystem>

#include "nearwall/core/progress.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {

enum class FoamForm { Binary, Ascii };

/// Writes a mesh as OpenFOAM's polyMesh, a folder of files: points, faces in upper-triangular order, owner, neighbour,
/// boundary with types, and the cell zone `layers`.
/// \param folder  is made; OpenFOAM looks for it as CASE/constant/polyMesh. Files of a polyMesh that are in it are
///                replaced, others stay
/// The same bytes for the same mesh at any number of threads. Memory: some batches, 8 bytes a boundary face.
/// \throws InputError  more points, faces or cells than 32-bit labels hold, before anything is written
///         IoError     disk full, no permission
void write_openfoam(const std::filesystem::path& folder, const WholeMesh& mesh, FoamForm form,
                    ProgressSink* progress = nullptr);

}  // namespace nearwall::io

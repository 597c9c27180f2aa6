#pragma once

#include <filesystem>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

/// Writes a surface in the format of the path's ending: stl, obj, ply, off, vtp or vtk, also with .gz behind it.
/// All but stl and off keep points bit for bit, shared points and patch names. stl: binary (single precision) for one
/// patch; for several, ascii with a solid for each patch (patches in order, doubles kept). off: no patches.
/// \throws InputError  an ending that is not known or cannot be written
///         IoError     disk full, no permission
void write_surface(const std::filesystem::path& path, const mesh::SurfaceMesh& mesh);

}  // namespace nearwall::io

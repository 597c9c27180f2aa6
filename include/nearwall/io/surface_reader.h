#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

/// Reads a surface as it stands in the file: points and triangles in the file's order, nothing welded, turned or
/// dropped. Formats with shared points (obj, ply, off, vtp, vtk) keep the sharing; stl gives three points for each
/// triangle. Faces with more than three corners are triangulated, patches without faces left out.
///
/// \param path  ends in stl, obj, ply, off, vtp or vtk, upper or lower case, also with .gz behind it
/// \throws InputError     no such file, a folder, or an ending that is not known
///         IoError        no permission, read failure, no memory
///         GeometryError  the content is malformed or holds no triangle: file, line or byte, what was expected
/// Memory: about the (decompressed) file and the mesh. What each format keeps: docs/formats.md.
mesh::SurfaceMesh read_surface(const std::filesystem::path& path);

/// The same with some of the file's point arrays, in the order asked for: one number for each point, of any type. In
/// vtp and vtk files these are point data, in ply files properties of the vertices; the other formats have none.
/// \throws InputError     also if the format has no point arrays, or the file none of that name: with the nearest one
///         GeometryError  also if an array does not have one value for each point
mesh::SurfaceMesh read_surface(const std::filesystem::path& path, std::span<const std::string> point_arrays);

/// Whether the name ends as those of surfaces that `read_surface` reads.
bool is_surface_name(const std::filesystem::path& path);

/// Name of the file without its ending, and without .gz before that.
std::string surface_stem(const std::filesystem::path& path);

}  // namespace nearwall::io

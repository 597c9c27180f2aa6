#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "nearwall/core/errors.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

/// A point array that was asked for is not in the file.
class PointArrayMissing : public InputError {
 public:
  PointArrayMissing(const std::string& what, std::string name) : InputError(what), array(std::move(name)) {}
  std::string array;
};

/// Reads a surface as it stands in the file: points and triangles in the file's order, nothing welded, turned or
/// dropped. Formats with shared points (obj, ply, off, vtp, vtk) keep the sharing; stl gives three points for each
/// triangle. Faces with more than three corners are triangulated, patches without faces left out.
///
/// Of solvers' formats (volume_reader.h) the faces with named patches are taken, such as the markers of a volume mesh.
///
/// \param path  ends in stl, obj, ply, off, vtp or vtk, upper or lower case, also with .gz behind it, or as meshes do
/// \throws InputError     no such file, a folder, or an ending that is not known
///         IoError        no permission, read failure, no memory
///         GeometryError  the content is malformed or holds no triangle: file, line or byte, what was expected
/// Memory: about the (decompressed) file and the mesh. What each format keeps: docs/formats.md.
mesh::SurfaceMesh read_surface(const std::filesystem::path& path);

/// The same with some of the file's point arrays, in the order asked for: one number for each point, of any type. In
/// vtp and vtk files these are point data, in ply files properties of the vertices; the other formats have none.
/// \throws PointArrayMissing  also if the format has no point arrays, or the file none of that name: with the nearest
///                            one, and what else has that name
///         GeometryError  also if an array does not have one value for each point
mesh::SurfaceMesh read_surface(const std::filesystem::path& path, std::span<const std::string> point_arrays);

/// Names of the arrays that the above would find, in the order of the file; none for formats without. \throws as above
std::vector<std::string> point_array_names(const std::filesystem::path& path);

/// Whether the name ends as those of surfaces that `read_surface` reads.
bool is_surface_name(const std::filesystem::path& path);

/// All files of this surface: the one of that name, NAME.mapbc beside it where there is one, or those of a polyMesh.
std::vector<std::filesystem::path> surface_files(const std::filesystem::path& path);

/// Name of the file without its ending, and without .gz before that.
std::string surface_stem(const std::filesystem::path& path);

}  // namespace nearwall::io

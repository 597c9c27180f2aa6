#pragma once

#include <string>
#include <string_view>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

class PointArrays;

// One reader for each format, from the unpacked bytes of the file. `file` is its name for messages.
// Each throws GeometryError, naming file and line or byte, on malformed content.
mesh::SurfaceMesh parse_stl(std::string_view bytes, const std::string& file);
mesh::SurfaceMesh parse_obj(std::string_view bytes, const std::string& file);
mesh::SurfaceMesh parse_ply(std::string_view bytes, const std::string& file);
mesh::SurfaceMesh parse_off(std::string_view bytes, const std::string& file);
mesh::SurfaceMesh parse_vtp(std::string_view bytes, const std::string& file);
mesh::SurfaceMesh parse_legacy_vtk(std::string_view bytes, const std::string& file);

// Those whose files may have point arrays, with the ones that are wanted.
mesh::SurfaceMesh parse_ply(std::string_view bytes, const std::string& file, PointArrays& arrays);
mesh::SurfaceMesh parse_vtp(std::string_view bytes, const std::string& file, PointArrays& arrays);
mesh::SurfaceMesh parse_legacy_vtk(std::string_view bytes, const std::string& file, PointArrays& arrays);

// The whole file in each format; what each keeps: docs/formats.md.
std::string format_stl(const mesh::SurfaceMesh& mesh);
std::string format_obj(const mesh::SurfaceMesh& mesh);
std::string format_ply(const mesh::SurfaceMesh& mesh);
std::string format_off(const mesh::SurfaceMesh& mesh);
std::string format_legacy_vtk(const mesh::SurfaceMesh& mesh);

}  // namespace nearwall::io

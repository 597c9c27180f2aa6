#pragma once

#include <filesystem>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

/// A CGNS file of a surface as others have it: a zone without cells, a section and a boundary condition for each patch.
void write_surface_by_library(const std::filesystem::path& path, const mesh::SurfaceMesh& surface);

}  // namespace nearwall::io

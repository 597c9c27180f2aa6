#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "nearwall/core/progress.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::program {

/// A surface as the commands look at it: read, and equal points made one.
struct LoadedSurface {
  mesh::SurfaceMesh mesh;
  std::size_t n_points_read = 0;  ///< before welding
};

/// \param tolerance  within which points become one [length]; 0: equal points only
LoadedSurface load_surface(const std::filesystem::path& file, double tolerance, ProgressSink& progress);

}  // namespace nearwall::program

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "nearwall/geometry/box.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/pipeline/case.h"

namespace nearwall {

/// What a run will make and need, known from the surface and the schedules alone. Upper bounds but for odd corners:
/// layers that are blocked make it less.
struct Forecast {
  std::uint64_t n_points = 0;
  std::uint64_t n_cells = 0;       ///< of the layers
  std::uint64_t n_tetrahedra = 0;  ///< that fill the rest, a guess; 0 where no fill is asked for
  std::uint64_t memory_bytes = 0;  ///< peak while the mesh file is written
  std::uint64_t disk_bytes = 0;    ///< all files; meshes from add_mesh_files on
  geometry::Box box;               ///< of the wall, in the case's unit
  Level largest_count = 0;         ///< layers of the patch that has most
};

/// \param patches      (n_patches) as of resolve_patches
/// \param is_wetted    (n_faces)
/// \param n_fan_faces  virtual faces of fans
/// \param asked_levels (n_vertices) of lines that end when they are isotropic; empty: all lines have the patch's count
Forecast forecast(const mesh::SurfaceMesh& wall, const std::vector<PatchSettings>& patches,
                  const IdVector<FaceId, char>& is_wetted, std::size_t n_fan_faces = 0,
                  const IdVector<VertexId, Level>& asked_levels = {});

/// Adds what fills the rest: 1 to 3 tetrahedra over (growth − 1) for each triangle were seen, as docs/theory/fill.md
/// has it; 2.5 are counted.
void add_fill(std::size_t n_triangles, double growth, Forecast& forecast);

/// Adds the disk that meshes in these formats take. \pre  cells and points are complete
void add_mesh_files(std::span<const io::MeshFormat> formats, Forecast& forecast);

/// A sentence or two: cells, points, memory, disk, bounding box.
std::string describe(const Forecast& forecast);

}  // namespace nearwall

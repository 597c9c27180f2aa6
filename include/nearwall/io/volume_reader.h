#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "nearwall/mesh/boundary.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/mesh/volume_mesh.h"

namespace nearwall::io {

/// Cells of a file that enclose no volume, by their dimension. They are passed over.
struct SkippedCells {
  std::uint64_t points = 0;  ///< vertices, empty cells
  std::uint64_t lines = 0;
  std::uint64_t faces = 0;  ///< triangles, quads, polygons, strips

  std::uint64_t all() const { return points + lines + faces; }
};

/// What a file of a volume mesh holds.
struct VolumeFile {
  mesh::VolumeMesh mesh;
  SkippedCells skipped;
  std::vector<std::string> patch_names;  ///< field data `PatchNames`, names of markers, …; often empty
  /// Faces with patches as the file has them: some may be missing, within, or the other way round (fit_boundary).
  mesh::Boundary boundary;
};

/// Reads the tetrahedra, pyramids, wedges and hexahedra of a file, with all its points, cells in the file's order,
/// nodes in the order of predicates/cells.h, and the faces that it has in patches. Voxels become hexahedra. Pieces and
/// zones follow each other; points are not merged. A surface in a solver's format is a mesh without cells.
///
/// \param path  ends in vtu vtk vtkhdf cgns su2 ugrid msh msh2 bdf nas, upper or lower case, text and VTK also with .gz
///              behind it; or OpenFOAM's: a folder polyMesh, that of a case, a file NAME.foam
/// \throws InputError     no such file, a folder, an ending that is not known, or cells that are none of these: of
///                        higher order, polyhedra
///         IoError        no permission, read failure, no memory
///         GeometryError  the content is malformed: file, then line, byte, point or cell (counted from 0), what was
///                        expected
/// Memory: the file (but not of HDF5) and the mesh; for .vtk once more the nodes, in 64 bits. Formats: docs/formats.md.
VolumeFile read_volume_mesh(const std::filesystem::path& path);

/// Whether the name ends as those of meshes that `read_volume_mesh` reads.
bool is_volume_name(const std::filesystem::path& path);

/// Whether files of that ending hold faces with the names of their patches, beside cells or alone: those of solvers.
bool has_named_faces(const std::filesystem::path& path);

/// The faces of a file with named patches as a surface: points that no face uses are dropped, quads are divided,
/// patches without faces left out. Where the file has cells, the faces are those of one cell alone, and their normals
/// point out of it, as those of a surface round the fluid do. \throws GeometryError  if there is no face
mesh::SurfaceMesh surface_of(const VolumeFile& volume, const std::string& file);

}  // namespace nearwall::io

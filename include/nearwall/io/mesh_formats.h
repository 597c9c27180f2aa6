#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/io/vtu_writer.h"
#include "nearwall/io/whole_mesh.h"

namespace nearwall::io {

/// Formats in which meshes are written. Names as in the case file.
enum class MeshFormat { Vtu, Vtkhdf, Cgns, Su2, Ugrid, UgridBig, UgridLittle, Msh, Msh2, OpenFoam, OpenFoamAscii };

/// In the order of MeshFormat: endings of files but for OpenFOAM's, which is a folder.
inline constexpr std::array<std::string_view, 11> kMeshFormatNames = {
    "vtu", "vtkhdf", "cgns", "su2", "ugrid", "b8.ugrid", "lb8.ugrid", "msh", "msh2", "openfoam", "openfoam-ascii"};

constexpr std::string_view name_of(MeshFormat format) { return kMeshFormatNames[static_cast<std::size_t>(format)]; }

/// nullopt for names that are none.
std::optional<MeshFormat> mesh_format(std::string_view name);

/// By the ending of a path; a folder polyMesh is OpenFOAM's. nullopt for endings that are none.
std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& path);

/// Whether the format holds the boundary. VTU and VTKHDF do not: theirs stands in NAME-boundary.vtp beside.
constexpr bool has_boundary(MeshFormat format) { return format != MeshFormat::Vtu && format != MeshFormat::Vtkhdf; }

/// OpenFOAM's are folders, and list faces with the cells on either side: they alone read WholeMesh::neighbours.
constexpr bool is_openfoam(MeshFormat format) {
  return format == MeshFormat::OpenFoam || format == MeshFormat::OpenFoamAscii;
}

/// Files of a mesh NAME, the mesh itself first. UGRID has NAME.mapbc besides; OpenFOAM's is the folder
/// NAME-openfoam/constant/polyMesh, with the empty NAME-openfoam/NAME.foam by which ParaView opens it.
std::vector<std::string> mesh_file_names(const std::string& name, MeshFormat format);

/// What `write_mesh` writes besides: NAME.mapbc beside a UGRID file.
std::vector<std::filesystem::path> files_beside(const std::filesystem::path& path, MeshFormat format);

/// Cell arrays that VTK's formats hold besides.
struct MeshExtras {
  std::span<const CellArray> arrays;
  std::vector<std::string> patch_names;  ///< of the array `Patch`
};

/// Whether the format can hold the mesh, for asking before the first of several is written: write_mesh says the same.
/// \param path  for the message
/// \throws InputError  a 32-bit limit of the format is exceeded
void require_limits(const std::filesystem::path& path, MeshFormat format, const WholeMesh& mesh);

/// Writes a mesh; what each format keeps: docs/formats.md.
/// \param path  of the file; for OpenFOAM of the folder polyMesh, which is made
/// \throws InputError  a 32-bit limit of the format is exceeded, before anything is written; IoError
void write_mesh(const std::filesystem::path& path, MeshFormat format, const WholeMesh& mesh, const MeshExtras& extras,
                ProgressSink* progress = nullptr);

}  // namespace nearwall::io

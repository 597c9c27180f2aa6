#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "nearwall/io/mesh_formats.h"
#include "nearwall/io/volume_reader.h"
#include "program/console.h"

namespace nearwall::program {

/// A mesh as read, with a boundary that fits its cells.
struct MeshOfFile {
  io::VolumeFile file;
  std::array<CellIndex, mesh::kNCellTypes> n_cells_by_type{};
  std::filesystem::path boundary_file;  ///< from which all patches came as they are; else empty
};

/// Reads a mesh and its patches; tells what had to be added to or left out of these.
/// \param boundary  file of the patches of a .vtu or .vtkhdf; nullopt: NAME-boundary.vtp beside, if it is there
/// \throws InputError  also if the file has no cells, or faces of more than two cells
MeshOfFile read_mesh(const std::string& path, const std::optional<std::string>& boundary, Console& console);

/// Writes it. \returns the files of the mesh, itself first
std::vector<std::string> write_mesh_as(const std::string& path, io::MeshFormat format, const MeshOfFile& mesh,
                                       Console& console);

}  // namespace nearwall::program

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/io/volume_reader.h"

namespace nearwall::io {

/// The polyMesh that a path stands for: a folder of that name, or a case's folder with constant/polyMesh in it, or a
/// file NAME.foam in a case's folder. Nothing for other paths.
std::optional<std::filesystem::path> openfoam_folder(const std::filesystem::path& path);

/// The files of such a folder that make the mesh, those that there are.
std::vector<std::filesystem::path> openfoam_files(const std::filesystem::path& folder);

/// A file of a polyMesh, unpacked.
struct FoamFile {
  std::string name;   ///< for messages
  std::string bytes;  ///< none: there is no such file, and it need not be
};

/// Gives the files of a polyMesh by their names: points, faces, owner, neighbour, boundary, cellZones.
using FoamSource = std::function<FoamFile(std::string_view name)>;

/// \param folder  its name, for messages
/// \throws GeometryError, InputError  as read_volume_mesh
VolumeFile parse_openfoam(const FoamSource& open, const std::string& folder);

}  // namespace nearwall::io

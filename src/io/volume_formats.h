#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "nearwall/io/volume_reader.h"

namespace nearwall::io {

// One reader for each format, from the unpacked bytes of the file. `file` is its name for messages.
// Each throws GeometryError on malformed content and InputError on cells that are not ours. Those of solver formats
// read surfaces, too: a mesh without cells, its faces in the boundary.
VolumeFile parse_vtu(std::string_view bytes, const std::string& file);
VolumeFile parse_legacy_volume(std::string_view bytes, const std::string& file);
VolumeFile parse_su2(std::string_view bytes, const std::string& file);
VolumeFile parse_ugrid(std::string_view bytes, const std::string& file);
VolumeFile parse_ugrid_big(std::string_view bytes, const std::string& file);
VolumeFile parse_ugrid_little(std::string_view bytes, const std::string& file);
// Those of a UGRID are named after their numbers, `patch3`; NAME.mapbc beside the grid has names and types.
void name_patches(VolumeFile& volume, std::string_view mapbc, const std::string& file);
void read_names_beside(VolumeFile& volume, const std::filesystem::path& grid);
VolumeFile parse_msh(std::string_view bytes, const std::string& file);
VolumeFile parse_nastran(std::string_view bytes, const std::string& file);

// Those that libraries read by name, and folders.
VolumeFile read_cgns(const std::filesystem::path& path);
VolumeFile read_vtkhdf(const std::filesystem::path& path);
VolumeFile read_openfoam(const std::filesystem::path& folder);

}  // namespace nearwall::io

#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>

#include "nearwall/io/openfoam_writer.h"
#include "nearwall/io/whole_mesh.h"

/// What formats cannot hold: their numbers have 32 bits.
namespace nearwall::io {

/// The library's numbers have 32 bits in Debian, 64 elsewhere; files are to be read everywhere.
inline constexpr std::uint64_t kMostOfCgns = std::numeric_limits<std::int32_t>::max();

/// Each: \throws InputError  naming the file, what there is too much of, the limit, and a format without it
void require_cgns_limits(const std::filesystem::path& path, const WholeMesh& mesh);
void require_ugrid_limits(const std::filesystem::path& path, const WholeMesh& mesh);
void require_msh22_limits(const std::filesystem::path& path, const WholeMesh& mesh);
void require_openfoam_limits(const std::filesystem::path& path, const WholeMesh& mesh, FoamForm form);

}  // namespace nearwall::io

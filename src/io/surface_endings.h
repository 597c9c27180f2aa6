#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>

namespace nearwall::io {

/// Surface formats that are read and written, by the ending of the file name.
inline constexpr std::array<std::string_view, 6> kSurfaceEndings = {"stl", "obj", "ply", "off", "vtp", "vtk"};

/// Index into kSurfaceEndings. \throws InputError for an unknown ending, naming the known ones and the nearest.
std::size_t surface_format(const std::filesystem::path& path);

}  // namespace nearwall::io

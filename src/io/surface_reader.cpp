#include "nearwall/io/surface_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "io/file_bytes.h"
#include "io/surface_endings.h"
#include "io/surface_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"

namespace nearwall::io {
namespace {

using Parse = mesh::SurfaceMesh (*)(std::string_view, const std::string&);

constexpr std::array<Parse, kSurfaceEndings.size()> kParsers = {parse_stl, parse_obj, parse_ply,
                                                                parse_off, parse_vtp, parse_legacy_vtk};

/// Endings that are understood to mean a surface, but not read yet.
constexpr std::array<std::string_view, 9> kLaterEndings = {"msh",  "su2",  "cgns",  "ugrid", "tri",
                                                           "uh3d", "mesh", "meshb", "triq"};

[[noreturn]] void fail_unknown(const std::filesystem::path& path, const std::string& ending) {
  if (std::ranges::find(kLaterEndings, ending) != kLaterEndings.end()) {
    throw InputError(fmt::format("{}: surfaces in .{} are not in this version; known: {} (also .gz)", path.string(),
                                 ending, fmt::join(kSurfaceEndings, " ")));
  }
  const std::vector<std::string> known(kSurfaceEndings.begin(), kSurfaceEndings.end());
  const std::string near = nearest(ending, known);
  throw InputError(fmt::format("{}: {}, expected a surface in one of: {} (also .gz){}", path.string(),
                               ending.empty() ? "no ending" : fmt::format("unknown ending '.{}'", ending),
                               fmt::join(known, " "), near.empty() ? "" : "; did you mean ." + near + "?"));
}

}  // namespace

std::size_t surface_format(const std::filesystem::path& path) {
  const std::string ending = format_ending(path);
  const auto found = std::ranges::find(kSurfaceEndings, ending);
  if (found == kSurfaceEndings.end()) fail_unknown(path, ending);
  return static_cast<std::size_t>(found - kSurfaceEndings.begin());
}

bool is_surface_name(const std::filesystem::path& path) {
  return std::ranges::find(kSurfaceEndings, format_ending(path)) != kSurfaceEndings.end();
}

std::string surface_stem(const std::filesystem::path& path) {
  return (is_gzip_name(path) ? path.stem() : path).stem().string();
}

mesh::SurfaceMesh read_surface(const std::filesystem::path& path) try {
  if (std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("{}: is a folder, expected a surface file", path.string()));
  }
  const Parse parse = kParsers[surface_format(path)];
  return parse(read_bytes(path), path.string());
} catch (const std::bad_alloc&) {
  throw IoError(fmt::format("{}: not enough memory to read the surface", path.string()));
} catch (const std::filesystem::filesystem_error& error) {
  throw IoError(fmt::format("{}: cannot be read: {}", path.string(), error.code().message()));
}

}  // namespace nearwall::io

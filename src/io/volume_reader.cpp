#include "nearwall/io/volume_reader.h"

#include <fmt/format.h>

#include <new>

#include "io/file_bytes.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

using Parse = VolumeFile (*)(std::string_view, const std::string&);

/// Null for unknown endings.
Parse parser_of(const std::string& ending) {
  if (ending == "vtu") return parse_vtu;
  return ending == "vtk" ? parse_legacy_volume : nullptr;
}

}  // namespace

bool is_volume_name(const std::filesystem::path& path) { return parser_of(format_ending(path)) != nullptr; }

VolumeFile read_volume_mesh(const std::filesystem::path& path) try {
  if (std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("{}: is a folder, expected a file of a mesh", path.string()));
  }
  const std::string ending = format_ending(path);
  const Parse parse = parser_of(ending);
  if (!parse) {
    throw InputError(fmt::format("{}: {}, expected a mesh in one of: vtu vtk (also .gz)", path.string(),
                                 ending.empty() ? "no ending" : fmt::format("unknown ending '.{}'", ending)));
  }
  return parse(read_bytes(path), path.string());
} catch (const std::bad_alloc&) {
  throw IoError(fmt::format("{}: not enough memory to read the mesh", path.string()));
} catch (const std::length_error&) {
  throw IoError(fmt::format("{}: not enough memory to read the mesh", path.string()));
} catch (const std::filesystem::filesystem_error& error) {
  throw IoError(fmt::format("{}: cannot be read: {}", path.string(), error.code().message()));
}

}  // namespace nearwall::io

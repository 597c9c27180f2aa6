#include "nearwall/io/volume_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <new>
#include <span>

#include "io/cursor.h"
#include "io/file_bytes.h"
#include "io/openfoam_folder.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

/// A format of meshes by the ending of the file's name: read from its bytes, or by name.
struct Format {
  std::string_view ending;
  VolumeFile (*parse)(std::string_view bytes, const std::string& file) = nullptr;
  VolumeFile (*read)(const std::filesystem::path& path) = nullptr;
  /// Reads what stands in files beside it.
  void (*read_beside)(VolumeFile& volume, const std::filesystem::path& path) = nullptr;
};

/// Where one ending is the end of another, the longer one first.
constexpr Format kFormats[] = {
    {"vtu", parse_vtu},
    {"vtk", parse_legacy_volume},
    {"foam", nullptr, read_openfoam},
    {"msh", parse_msh},
    {"msh2", parse_msh},
    {"bdf", parse_nastran},
    {"nas", parse_nastran},
    {"su2", parse_su2},
    {"lb8.ugrid", parse_ugrid_little, nullptr, read_names_beside},
    {"b8.ugrid", parse_ugrid_big, nullptr, read_names_beside},
    {"ugrid", parse_ugrid, nullptr, read_names_beside},
    {"cgns", nullptr, read_cgns},
    {"vtkhdf", nullptr, read_vtkhdf},
};

/// The file's name in lower case without .gz.
std::string lower_name(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  if (is_gzip_name(path)) name.resize(name.size() - 3);
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return name;
}

/// Null for unknown endings.
const Format* format_of(const std::filesystem::path& path) {
  const std::string name = lower_name(path);
  for (const Format& format : kFormats) {
    const std::string ending = fmt::format(".{}", format.ending);
    if (name.size() > ending.size() && name.ends_with(ending)) return &format;
  }
  return nullptr;
}

[[noreturn]] void fail_unknown(const std::filesystem::path& path) {
  std::vector<std::string_view> known;
  for (const Format& format : kFormats) known.push_back(format.ending);
  const std::string ending = format_ending(path);
  throw InputError(fmt::format("{}: {}, expected a mesh in one of: {} (text and VTK also .gz)", path.string(),
                               ending.empty() ? "no ending" : fmt::format("unknown ending '.{}'", ending),
                               fmt::join(known, " ")));
}

VolumeFile read_by_name(const Format& format, const std::filesystem::path& path) {
  if (is_gzip_name(path)) {
    throw InputError(
        fmt::format("{}: files in .{} are read unpacked only; gunzip it first", path.string(), format.ending));
  }
  if (!std::filesystem::exists(path)) throw InputError(fmt::format("{}: no such file", path.string()));
  return format.read(path);
}

}  // namespace

bool has_named_faces(const std::filesystem::path& path) {
  if (openfoam_folder(path)) return true;
  const Format* const format = format_of(path);
  return format && !format->ending.starts_with("vt");
}

bool is_volume_name(const std::filesystem::path& path) { return format_of(path) != nullptr || openfoam_folder(path); }

VolumeFile read_volume_mesh(const std::filesystem::path& path) try {
  if (std::filesystem::is_directory(path)) {
    if (openfoam_folder(path)) return read_openfoam(path);
    throw InputError(
        fmt::format("{}: is a folder, expected a file of a mesh, or a folder of OpenFOAM: polyMesh, or one "
                    "with constant/polyMesh in it",
                    path.string()));
  }
  const Format* const format = format_of(path);
  if (!format) fail_unknown(path);
  if (!format->parse) return read_by_name(*format, path);
  VolumeFile volume = format->parse(read_bytes(path), path.string());
  if (format->read_beside) format->read_beside(volume, path);
  return volume;
} catch (const std::bad_alloc&) {
  throw IoError(fmt::format("{}: not enough memory to read the mesh", path.string()));
} catch (const std::length_error&) {
  throw IoError(fmt::format("{}: not enough memory to read the mesh", path.string()));
} catch (const std::filesystem::filesystem_error& error) {
  throw IoError(fmt::format("{}: cannot be read: {}", path.string(), error.code().message()));
}

}  // namespace nearwall::io

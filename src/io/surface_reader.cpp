#include "nearwall/io/surface_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "io/file_bytes.h"
#include "io/openfoam_folder.h"
#include "io/point_arrays.h"
#include "io/surface_endings.h"
#include "io/surface_formats.h"
#include "nearwall/core/errors.h"
#include "nearwall/core/nearest.h"
#include "nearwall/io/mesh_formats.h"
#include "nearwall/io/volume_reader.h"

namespace nearwall::io {
namespace {

using Parse = mesh::SurfaceMesh (*)(std::string_view, const std::string&);

constexpr std::array<Parse, kSurfaceEndings.size()> kParsers = {parse_stl, parse_obj, parse_ply,
                                                                parse_off, parse_vtp, parse_legacy_vtk};

using ParseWithArrays = mesh::SurfaceMesh (*)(std::string_view, const std::string&, PointArrays&);

/// Null: files of this format have no point arrays.
constexpr std::array<ParseWithArrays, kSurfaceEndings.size()> kParsersWithArrays = {
    nullptr, nullptr, parse_ply, nullptr, parse_vtp, parse_legacy_vtk};

/// Of solvers' formats, whose faces with named patches are a surface, too.
constexpr std::array<std::string_view, 6> kMeshEndings = {"msh", "su2", "cgns", "ugrid", "bdf", "nas"};

/// Endings that are understood to mean a surface, but not read yet.
constexpr std::array<std::string_view, 5> kLaterEndings = {"tri", "uh3d", "mesh", "meshb", "triq"};

[[noreturn]] void fail_unknown(const std::filesystem::path& path, const std::string& ending) {
  if (std::ranges::find(kLaterEndings, ending) != kLaterEndings.end()) {
    throw InputError(fmt::format("{}: surfaces in .{} are not in this version; known: {} (also .gz), {}", path.string(),
                                 ending, fmt::join(kSurfaceEndings, " "), fmt::join(kMeshEndings, " ")));
  }
  if (std::ranges::find(kMeshEndings, ending) != kMeshEndings.end()) {
    throw InputError(fmt::format("{}: surfaces are read from .{}, but not written; written are: {} (also .gz)",
                                 path.string(), ending, fmt::join(kSurfaceEndings, " ")));
  }
  std::vector<std::string> known(kSurfaceEndings.begin(), kSurfaceEndings.end());
  known.insert(known.end(), kMeshEndings.begin(), kMeshEndings.end());
  const std::string near = nearest(ending, known);
  throw InputError(fmt::format("{}: {}, expected a surface in one of: {} (also .gz){}", path.string(),
                               ending.empty() ? "no ending" : fmt::format("unknown ending '.{}'", ending),
                               fmt::join(known, " "), near.empty() ? "" : "; did you mean ." + near + "?"));
}

[[noreturn]] void fail_without_arrays(const std::filesystem::path& path, std::string_view ending,
                                      const std::string& wanted) {
  std::vector<std::string_view> able;
  for (std::size_t i = 0; i < kSurfaceEndings.size(); ++i) {
    if (kParsersWithArrays[i]) able.push_back(kSurfaceEndings[i]);
  }
  throw PointArrayMissing(
      fmt::format("{}: the point array \"{}\" is asked for, but files in .{} have none; those in .{} may",
                  path.string(), wanted, ending, fmt::join(able, ", .")),
      wanted);
}

/// What there is in place of an array that is not there.
std::string what_there_is(const PointArrays& arrays, const std::string& name) {
  if (const std::string other = arrays.other(name); !other.empty()) {
    return fmt::format("\"{}\" is {}; make it one number for each point first (in ParaView: {})", name, other,
                       other.starts_with("a point array") ? "Calculator, mag(…)" : "Cell Data to Point Data");
  }
  if (arrays.met().empty()) return "the file has none at all";
  const std::string near = nearest(name, arrays.met());
  return fmt::format("there {} \"{}\"{}", arrays.met().size() == 1 ? "is" : "are", fmt::join(arrays.met(), "\", \""),
                     near.empty() ? "" : fmt::format("; nearest: \"{}\"", near));
}

/// An array that was asked for. \throws PointArrayMissing if the file has none of that name
mesh::PointArray taken(PointArrays& arrays, const std::string& name, const mesh::SurfaceMesh& mesh,
                       const std::filesystem::path& path) {
  mesh::PointArray* const found = arrays.find(name);
  if (!found) {
    throw PointArrayMissing(fmt::format("{}: no point array \"{}\" of one number for each point; {}", path.string(),
                                        name, what_there_is(arrays, name)),
                            name);
  }
  if (found->values.size() != mesh.points.size()) {
    throw GeometryError(fmt::format("{}: the point array \"{}\" has {} values for {} points", path.string(), name,
                                    found->values.size(), mesh.points.size()));
  }
  return *found;
}

}  // namespace

std::size_t surface_format(const std::filesystem::path& path) {
  const std::string ending = format_ending(path);
  const auto found = std::ranges::find(kSurfaceEndings, ending);
  if (found == kSurfaceEndings.end()) fail_unknown(path, ending);
  return static_cast<std::size_t>(found - kSurfaceEndings.begin());
}

bool is_surface_name(const std::filesystem::path& path) {
  return std::ranges::find(kSurfaceEndings, format_ending(path)) != kSurfaceEndings.end() || has_named_faces(path);
}

std::vector<std::filesystem::path> surface_files(const std::filesystem::path& path) {
  if (const auto folder = openfoam_folder(path)) return openfoam_files(*folder);
  const std::filesystem::path unpacked = is_gzip_name(path) ? path.parent_path() / path.stem() : path;
  std::vector<std::filesystem::path> files = {path};
  if (const auto format = mesh_format_of(unpacked)) {
    for (const auto& beside : files_beside(unpacked, *format)) {
      if (std::filesystem::exists(beside)) files.push_back(beside);
    }
  }
  return files;
}

std::string surface_stem(const std::filesystem::path& path) {
  return (is_gzip_name(path) ? path.stem() : path).stem().string();
}

mesh::SurfaceMesh read_surface(const std::filesystem::path& path) { return read_surface(path, {}); }

std::vector<std::string> point_array_names(const std::filesystem::path& path) {
  if (has_named_faces(path)) return {};
  const auto parse = kParsersWithArrays[surface_format(path)];
  PointArrays arrays;
  if (parse) parse(read_bytes(path), path.string(), arrays);
  return arrays.met();
}

mesh::SurfaceMesh read_surface(const std::filesystem::path& path, std::span<const std::string> point_arrays) try {
  if (has_named_faces(path)) {
    if (!point_arrays.empty()) fail_without_arrays(path, format_ending(path), point_arrays.front());
    return surface_of(read_volume_mesh(path), path.string());
  }
  if (std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("{}: is a folder, expected a surface file", path.string()));
  }
  const std::size_t format = surface_format(path);
  if (point_arrays.empty()) return kParsers[format](read_bytes(path), path.string());
  if (!kParsersWithArrays[format]) fail_without_arrays(path, kSurfaceEndings[format], point_arrays.front());
  PointArrays arrays({point_arrays.begin(), point_arrays.end()});
  mesh::SurfaceMesh mesh = kParsersWithArrays[format](read_bytes(path), path.string(), arrays);
  for (const std::string& name : point_arrays) mesh.point_arrays.push_back(taken(arrays, name, mesh, path));
  return mesh;
} catch (const std::bad_alloc&) {
  throw IoError(fmt::format("{}: not enough memory to read the surface", path.string()));
} catch (const std::filesystem::filesystem_error& error) {
  throw IoError(fmt::format("{}: cannot be read: {}", path.string(), error.code().message()));
}

}  // namespace nearwall::io

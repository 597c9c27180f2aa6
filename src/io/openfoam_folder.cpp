#include "io/openfoam_folder.h"

#include <fmt/format.h>

#include "io/file_bytes.h"
#include "io/volume_formats.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

namespace fs = std::filesystem;

/// As OpenFOAM itself: the plain file, else the packed one. Nothing if there is neither.
std::optional<fs::path> file_in(const fs::path& folder, std::string_view name) {
  const fs::path plain = folder / name;
  const fs::path packed = folder / fmt::format("{}.gz", name);
  if (fs::exists(plain)) return plain;
  if (fs::exists(packed)) return packed;
  return std::nullopt;
}

}  // namespace

std::optional<fs::path> openfoam_folder(const fs::path& path) {
  const fs::path named = path.has_filename() ? path : path.parent_path();
  if (named.filename() == "polyMesh") return named;
  const fs::path in_case = (named.extension() == ".foam" ? named.parent_path() : named) / "constant" / "polyMesh";
  if (file_in(in_case, "points")) return in_case;
  return std::nullopt;
}

std::vector<fs::path> openfoam_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* name : {"points", "faces", "owner", "neighbour", "boundary", "cellZones"}) {
    if (const auto file = file_in(folder, name)) files.push_back(*file);
  }
  return files;
}

VolumeFile read_openfoam(const fs::path& path) {
  const auto folder = openfoam_folder(path);
  if (!folder) {
    throw InputError(
        fmt::format("{}: expected a folder polyMesh, or the folder of an OpenFOAM case with "
                    "constant/polyMesh/points in it",
                    path.string()));
  }
  const FoamSource open = [&](std::string_view name) -> FoamFile {
    const auto found = file_in(*folder, name);
    if (found) return {found->string(), read_bytes(*found)};
    if (name == "cellZones") return {};
    throw InputError(
        fmt::format("{}: no such file (nor with .gz); a polyMesh has the files points, faces, owner, "
                    "neighbour and boundary",
                    (*folder / name).string()));
  };
  return parse_openfoam(open, folder->string());
}

}  // namespace nearwall::io

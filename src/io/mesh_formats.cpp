#include "nearwall/io/mesh_formats.h"

#include <algorithm>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/io/msh_writer.h"
#include "nearwall/io/openfoam_writer.h"
#include "nearwall/io/pending_file.h"
#include "nearwall/io/su2_writer.h"
#include "nearwall/io/ugrid_writer.h"

namespace nearwall::io {
namespace {

bool is_openfoam(MeshFormat format) { return format == MeshFormat::OpenFoam || format == MeshFormat::OpenFoamAscii; }

/// The folder constant/polyMesh of a case, and the empty file by which ParaView opens the case.
void write_foam_case(const std::filesystem::path& folder, const WholeMesh& mesh, FoamForm form,
                     ProgressSink* progress) {
  std::error_code error;
  const std::filesystem::path constant = folder / "constant";
  std::filesystem::create_directories(constant, error);
  if (error) throw IoError(fmt::format("{}: cannot be made: {}", constant.string(), error.message()));
  write_openfoam(constant / "polyMesh", mesh, form, progress);
  write_text(folder / (mesh.name + ".foam"), "");
}

}  // namespace

std::optional<MeshFormat> mesh_format(std::string_view name) {
  const auto found = std::find(kMeshFormatNames.begin(), kMeshFormatNames.end(), name);
  if (found == kMeshFormatNames.end()) return std::nullopt;
  return static_cast<MeshFormat>(found - kMeshFormatNames.begin());
}

std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& path) {
  std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (name == "polymesh") return MeshFormat::OpenFoam;
  std::optional<MeshFormat> found;
  for (std::size_t i = 0; i < kMeshFormatNames.size(); ++i) {
    const auto format = static_cast<MeshFormat>(i);
    if (is_openfoam(format) || !name.ends_with(fmt::format(".{}", kMeshFormatNames[i]))) continue;
    if (!found || kMeshFormatNames[i].size() > name_of(*found).size()) found = format;
  }
  return found;
}

std::vector<std::string> mesh_file_names(const std::string& name, MeshFormat format) {
  if (is_openfoam(format)) return {name + "-openfoam"};
  std::vector<std::string> names = {fmt::format("{}.{}", name, name_of(format))};
  if (names.front().ends_with("ugrid")) names.push_back(name + ".mapbc");
  return names;
}

void write_mesh(const std::filesystem::path& path, MeshFormat format, const WholeMesh& mesh, const MeshExtras& extras,
                ProgressSink* progress) {
  switch (format) {
    case MeshFormat::Vtu:
      return write_vtu(path, mesh.cells, extras.arrays, {extras.patch_names}, progress);
    case MeshFormat::Vtkhdf:
    case MeshFormat::Cgns:
      throw InputError(fmt::format("{}: not in this version", path.string()));
    case MeshFormat::Su2:
      return write_su2(path, mesh, progress);
    case MeshFormat::Ugrid:
      return write_ugrid(path, mesh, UgridForm::Ascii, progress);
    case MeshFormat::UgridBig:
      return write_ugrid(path, mesh, UgridForm::BigEndian, progress);
    case MeshFormat::UgridLittle:
      return write_ugrid(path, mesh, UgridForm::LittleEndian, progress);
    case MeshFormat::Msh:
      return write_msh(path, mesh, MshVersion::V41, progress);
    case MeshFormat::Msh2:
      return write_msh(path, mesh, MshVersion::V22, progress);
    case MeshFormat::OpenFoam:
      return write_foam_case(path, mesh, FoamForm::Binary, progress);
    case MeshFormat::OpenFoamAscii:
      return write_foam_case(path, mesh, FoamForm::Ascii, progress);
  }
}

}  // namespace nearwall::io

#include "nearwall/io/mesh_formats.h"

#include <algorithm>

#include <fmt/format.h>

#include "io/format_limits.h"
#include "io/ugrid_layout.h"
#include "nearwall/io/cgns_writer.h"
#include "nearwall/io/msh_writer.h"
#include "nearwall/io/openfoam_writer.h"
#include "nearwall/io/su2_writer.h"
#include "nearwall/io/ugrid_writer.h"
#include "nearwall/io/vtkhdf_writer.h"

namespace nearwall::io {

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
  if (is_openfoam(format)) {
    const std::string folder = fmt::format("{}-{}", name, name_of(format));
    return {folder + "/constant/polyMesh", fmt::format("{}/{}.foam", folder, name)};
  }
  std::vector<std::string> names = {fmt::format("{}.{}", name, name_of(format))};
  for (const auto& path : files_beside(names.front(), format)) names.push_back(path.string());
  return names;
}

std::vector<std::filesystem::path> files_beside(const std::filesystem::path& path, MeshFormat format) {
  const bool is_ugrid =
      format == MeshFormat::Ugrid || format == MeshFormat::UgridBig || format == MeshFormat::UgridLittle;
  return is_ugrid ? std::vector{mapbc_path(path)} : std::vector<std::filesystem::path>();
}

void require_limits(const std::filesystem::path& path, MeshFormat format, const WholeMesh& mesh) {
  switch (format) {
    case MeshFormat::Vtu:
    case MeshFormat::Vtkhdf:
    case MeshFormat::Su2:
    case MeshFormat::Msh:
      return;
    case MeshFormat::Cgns:
      return require_cgns_limits(path, mesh);
    case MeshFormat::Ugrid:
    case MeshFormat::UgridBig:
    case MeshFormat::UgridLittle:
      return require_ugrid_limits(path, mesh);
    case MeshFormat::Msh2:
      return require_msh22_limits(path, mesh);
    case MeshFormat::OpenFoam:
      return require_openfoam_limits(path, mesh, FoamForm::Binary);
    case MeshFormat::OpenFoamAscii:
      return require_openfoam_limits(path, mesh, FoamForm::Ascii);
  }
}

void write_mesh(const std::filesystem::path& path, MeshFormat format, const WholeMesh& mesh, const MeshExtras& extras,
                ProgressSink* progress) {
  switch (format) {
    case MeshFormat::Vtu:
      return write_vtu(path, mesh.cells, extras.arrays, {extras.patch_names}, progress);
    case MeshFormat::Vtkhdf:
      return write_vtkhdf(path, mesh.cells, extras.arrays, {extras.patch_names}, progress);
    case MeshFormat::Cgns:
      return write_cgns(path, mesh, progress);
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
      return write_openfoam(path, mesh, FoamForm::Binary, progress);
    case MeshFormat::OpenFoamAscii:
      return write_openfoam(path, mesh, FoamForm::Ascii, progress);
  }
}

}  // namespace nearwall::io

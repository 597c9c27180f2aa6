#include "program/convert_mesh.h"

#include <filesystem>

#include <fmt/format.h>

#include "nearwall/core/errors.h"
#include "nearwall/io/boundary_file.h"
#include "nearwall/mesh/volume_neighbours.h"
#include "nearwall/mesh/volume_source.h"
#include "program/table.h"

namespace nearwall::program {

namespace {

namespace fs = std::filesystem;

/// Whether files of that name hold cells alone.
bool is_without_boundary(const fs::path& path) { return io::is_volume_name(path) && !io::has_named_faces(path); }

/// \returns  the file from which it was read; empty if that is the mesh's own, or none
fs::path add_boundary(const std::string& path, const std::optional<std::string>& given, io::VolumeFile& file,
                      Console& console) {
  if (!is_without_boundary(path)) {
    if (given) throw InputError(fmt::format("--boundary: {} holds its patches itself", path));
    return {};
  }
  const fs::path beside = given ? fs::path(*given) : io::boundary_file_of(path);
  if (!given && !fs::exists(beside)) {
    console.say(
        fmt::format("{} holds no patches and {} is not there: the boundary will be one patch", path, beside.string()));
    return {};
  }
  file.boundary = io::read_boundary(beside, file.mesh.points.size());
  return beside;
}

void tell(const mesh::BoundaryChanges& changes, const io::VolumeFile& file, Console& console) {
  if (changes.n_dropped > 0) {
    console.say(fmt::format("left out: {} faces of patches that lie within the mesh, twice, or on no cell",
                            grouped(changes.n_dropped)));
  }
  if (changes.n_added > 0 && changes.n_added < file.boundary.faces.size()) {
    console.say(fmt::format("{} faces of cells were in no patch: they are the patch \"{}\"", grouped(changes.n_added),
                            file.boundary.patches[file.boundary.patch.back()].name));
  }
}

}  // namespace

MeshOfFile read_mesh(const std::string& path, const std::optional<std::string>& boundary, Console& console) {
  MeshOfFile mesh;
  staged(console, "reading", [&] { mesh.file = io::read_volume_mesh(path); });
  if (mesh.file.mesh.n_cells() == 0) {
    throw InputError(
        fmt::format("{}: expected a mesh of tetrahedra, pyramids, wedges or hexahedra, found none; a "
                    "surface is written as stl, obj, ply, off, vtp or vtk",
                    path));
  }
  const fs::path boundary_file = add_boundary(path, boundary, mesh.file, console);
  const mesh::BoundaryChanges changes = mesh::fit_boundary(mesh.file.mesh, mesh.file.boundary);
  if (changes.n_added + changes.n_dropped == 0) mesh.boundary_file = boundary_file;
  tell(changes, mesh.file, console);
  for (const mesh::CellType type : mesh.file.mesh.type) ++mesh.n_cells_by_type[static_cast<std::size_t>(type)];
  return mesh;
}

std::vector<std::string> write_mesh_as(const std::string& path, io::MeshFormat format, const MeshOfFile& mesh,
                                       Console& console) {
  const mesh::VolumeSource cells(mesh.file.mesh);
  const mesh::VolumeNeighbours neighbours(mesh.file.mesh, mesh.file.boundary);
  const io::WholeMesh whole{cells, mesh.file.boundary, neighbours, fs::path(path).stem().string()};
  const fs::path beside = io::boundary_file_of(path);
  // One that is there and says the same stays: a run writes more into it.
  const bool is_beside =
      !mesh.boundary_file.empty() && fs::exists(beside) && fs::equivalent(beside, mesh.boundary_file);
  const bool makes_boundary = !io::has_boundary(format) && !is_beside;
  // That of an older mesh goes first: at no time does it stand beside the new one.
  if (std::error_code ignored; makes_boundary) fs::remove(beside, ignored);
  std::vector<std::string> files = {path};
  staged(console, "writing", [&] { io::write_mesh(path, format, whole, {{}, mesh.file.patch_names}, &console); });
  for (const fs::path& other : io::files_beside(path, format)) files.push_back(other.string());
  if (makes_boundary) {
    io::write_polydata(
        beside, io::boundary_polydata(mesh.file.boundary, [&](NodeIndex node) { return mesh.file.mesh.points[node]; }));
  }
  if (!io::has_boundary(format)) files.push_back(beside.string());
  return files;
}

}  // namespace nearwall::program

#include "io/format_limits.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "io/openfoam_text.h"
#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();

/// One limit of one format.
class Limit {
 public:
  /// \param holds    "UGRID's numbers of 32 bits hold"
  /// \param instead  what to write
  Limit(const std::filesystem::path& path, std::string_view holds, std::string_view instead)
      : path_(path), holds_(holds), instead_(instead) {}

  void require(std::uint64_t n, std::string_view what) const {
    if (n <= kMost) return;
    throw InputError(
        fmt::format("{}: the mesh has {} {}, but {} {} at most; {}", path_.string(), n, what, holds_, kMost, instead_));
  }

 private:
  const std::filesystem::path& path_;
  std::string_view holds_, instead_;
};

}  // namespace

void require_cgns_limits(const std::filesystem::path& path, const WholeMesh& mesh) {
  const Limit limit(path, "the CGNS library counts to", "write vtkhdf or vtu instead");
  limit.require(mesh.cells.n_points(), "points");
  limit.require(mesh.cells.n_cells() + mesh.boundary.faces.size(), "cells and boundary faces");
  const auto by_type = mesh.cells.n_cells_by_type();
  for (std::size_t type = 0; type < by_type.size(); ++type) {
    limit.require(by_type[type] * static_cast<std::uint64_t>(mesh::kCellSize[type]),
                  fmt::format("nodes of cells of the type {}", mesh::kCellTypeNames[type]));
  }
  limit.require(4 * mesh.boundary.faces.size(), "nodes of boundary faces");
  if (mesh.cells.n_points() == 0 || mesh.cells.n_cells() == 0) {
    throw InputError(fmt::format("{}: the mesh has no cells, and CGNS has no zones without", path.string()));
  }
}

void require_ugrid_limits(const std::filesystem::path& path, const WholeMesh& mesh) {
  const Limit limit(path, "UGRID's numbers of 32 bits hold", "write vtkhdf or su2");
  limit.require(mesh.cells.n_points(), "points");
  const auto n_cells = mesh.cells.n_cells_by_type();
  constexpr std::array<std::string_view, mesh::kNCellTypes> kNames = {"tetrahedra", "pyramids", "wedges", "hexahedra"};
  for (std::size_t type = 0; type < n_cells.size(); ++type) limit.require(n_cells[type], kNames[type]);
  limit.require(mesh.boundary.faces.size(), "boundary faces");
}

void require_msh22_limits(const std::filesystem::path& path, const WholeMesh& mesh) {
  // Gmsh and other programs read the numbers of version 2.2 into 32 bits with a sign.
  const Limit limit(path, "MSH 2.2 numbers", "write MSH 4.1 instead");
  limit.require(mesh.cells.n_points(), "points");
  limit.require(mesh.cells.n_cells() + mesh.boundary.faces.size(), "cells and faces of the boundary");
}

void require_openfoam_limits(const std::filesystem::path& path, const WholeMesh& mesh, FoamForm form) {
  const FoamCounts counts = foam_counts(mesh);
  const Limit labels(path, "OpenFOAM's 32-bit labels hold", "write the mesh as .vtkhdf instead");
  labels.require(counts.n_points, "points");
  labels.require(counts.n_cells, "cells");
  labels.require(counts.n_faces, "faces");
  if (form == FoamForm::Ascii) return;
  const Limit corners(path, "OpenFOAM's 32-bit labels hold", "write the ascii form, or the mesh as .vtkhdf");
  corners.require(counts.n_corners, "corners of faces in binary form");
}

}  // namespace nearwall::io

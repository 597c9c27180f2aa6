#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/io/openfoam_writer.h"
#include "nearwall/mesh/boundary.h"

namespace nearwall::io {

/// How many of everything a polyMesh has.
struct FoamCounts {
  std::uint64_t n_points = 0;
  std::uint64_t n_cells = 0;
  std::uint64_t n_faces = 0;
  std::uint64_t n_internal_faces = 0;
  std::uint64_t n_corners = 0;  ///< of all faces
};

/// From the numbers of cells by type and the boundary alone: each face within is one of two cells.
FoamCounts foam_counts(const WholeMesh& mesh);

/// The head of a file of a polyMesh.
/// \param foam_class  OpenFOAM's name of what the file holds, such as "labelList"
/// \param object      name of the file
/// \param note        text of the entry `note`; empty: without
std::string foam_header(FoamForm form, std::string_view foam_class, std::string_view object,
                        std::string_view note = {});

/// The sizes of the mesh as OpenFOAM notes them in the heads of owner and neighbour.
std::string foam_note(const FoamCounts& counts);

/// Names of patches as words that OpenFOAM takes: letters, digits, '_', '-' and '.', beginning with a letter or '_';
/// other characters become '_'. Unique: names that would be equal get a number behind them.
IdVector<PatchId, std::string> foam_names(const IdVector<PatchId, mesh::BoundaryPatch>& patches);

/// The file `boundary`: patches that have faces, one after the other behind the internal faces. Types: wall, symmetry,
/// else patch; inlets, outlets and far fields are told by a group of that name.
/// \param n_faces  of each patch
std::string foam_boundary(FoamForm form, const IdVector<PatchId, mesh::BoundaryPatch>& patches,
                          const IdVector<PatchId, std::uint64_t>& n_faces, std::uint64_t n_internal_faces);

}  // namespace nearwall::io

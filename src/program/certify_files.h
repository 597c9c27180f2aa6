#pragma once

#include <filesystem>

#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/mesh/volume_mesh.h"

namespace nearwall::program {

/// Writes the cells that are not, or not surely, positive. Cell arrays: `Cell`, its number in the file; `Verdict`, 0
/// not positive, 1 undecided. \returns  cells written; 0: no file
std::size_t write_offending_cells(const std::filesystem::path& path, const mesh::VolumeMesh& mesh,
                                  const certify::MeshCertificate& certificate);

/// Writes the faces that do not conform, meet others, or have space covered twice behind them, quads as two triangles.
/// Cell arrays: `Cell`, number in the file of the cell that the face is of; `Fault`, an index into the field data
/// `FaultNames`. \returns  faces written; 0: no file
std::size_t write_offending_faces(const std::filesystem::path& path, const mesh::VolumeMesh& mesh,
                                  const certify::MeshCertificate& certificate);

}  // namespace nearwall::program

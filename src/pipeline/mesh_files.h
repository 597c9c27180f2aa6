#pragma once

#include <string>

#include "nearwall/mesh/mesh_source.h"
#include "nearwall/volume/domain_boundary.h"
#include "nearwall/volume/hybrid_neighbours.h"
#include "pipeline/output_directory.h"
#include "pipeline/result_files.h"

namespace nearwall::pipeline {

/// What a mesh is written from.
struct MeshToWrite {
  const mesh::MeshSource& cells;
  const volume::DomainBoundary& boundary;
  IdVector<PatchId, mesh::BoundaryPatch> patches;  ///< of the boundary
  const volume::FilledRest* filled = nullptr;      ///< null: the layers alone
};

/// Names and types of the patches of a case's surface.
IdVector<PatchId, mesh::BoundaryPatch> boundary_patches(const Prepared& prepared);

/// The boundary of the layers alone, with a patch "front" behind those of the surface.
/// \param patches  gets that patch
volume::DomainBoundary boundary_of_layers(const Result& result, const certify::CertifiedWall& wall,
                                          IdVector<PatchId, mesh::BoundaryPatch>& patches);

/// NAME-boundary.vtp and the mesh NAME in these formats, aside. A stage for each format.
/// \throws IoError, Interrupted; InputError where a limit of a format is exceeded
void write_mesh_files(const Result& result, const MeshToWrite& mesh, const std::string& name,
                      std::span<const io::MeshFormat> formats, OutputDirectory& output, ProgressSink& progress);

}  // namespace nearwall::pipeline

#pragma once

#include "nearwall/core/progress.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/pipeline/case.h"
#include "nearwall/surface/admission.h"
#include "nearwall/surface/features.h"

namespace nearwall::pipeline {

/// A wall that is ready to be meshed.
struct Prepared {
  surface::Admission admission;
  mesh::Topology topology;
  surface::Features features;
  IdVector<FaceId, char> is_wetted;  ///< (n_faces)
  std::size_t n_merged_points = 0;   ///< by welding

  const mesh::SurfaceMesh& surface() const { return admission.surface; }
};

/// Reads, scales and welds: the surface as it is inspected. \param n_read  where given: number of points in the file
mesh::SurfaceMesh read_wall(const Case& settings, ProgressSink& progress, std::size_t* n_read = nullptr);

/// All that comes before growing. \throws SurfaceRejected, InputError, IoError
Prepared prepare(const Case& settings, ProgressSink& progress);

}  // namespace nearwall::pipeline

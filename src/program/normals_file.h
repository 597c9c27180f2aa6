#pragma once

#include "nearwall/io/polydata_writer.h"
#include "nearwall/surface/patch_normals.h"
#include "nearwall/surface/smoothing.h"

namespace nearwall::program {

/// A surface and how its normals are asked for.
struct NormalsSource {
  const mesh::SurfaceMesh& mesh;
  const mesh::Topology& topology;
  const surface::Features& features;
  const surface::NormalOptions& options;
  surface::GroupOptions groups;
};

/// The surface with its normals, named as in NAME-surface.vtp, and the ridges as lines.
struct ShownNormals {
  io::PolyDataFile file;
  std::size_t n_normals = 0;
  std::size_t n_blind = 0;
  std::size_t n_fallbacks = 0;
  double worst_angle = 0;  ///< [rad]
};

/// One point and normal for each vertex.
ShownNormals normals_of_vertices(const NormalsSource& source, const surface::SmoothingOptions& smoothing);

/// One point and normal for each run of faces round each vertex, which the triangles of the run meet at.
/// \throws InputError if the method is not for runs
ShownNormals normals_of_runs(const NormalsSource& source, surface::Separation separation);

}  // namespace nearwall::program

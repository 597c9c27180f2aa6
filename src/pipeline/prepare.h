#pragma once

#include <string>
#include <vector>

#include "nearwall/core/progress.h"
#include "nearwall/mesh/topology.h"
#include "nearwall/pipeline/case.h"
#include "nearwall/surface/admission.h"
#include "nearwall/surface/features.h"
#include "nearwall/surface/open_wall.h"

namespace nearwall::pipeline {

/// A wall that is ready to be meshed.
struct Prepared {
  Case settings;                        ///< with rules for the patches that were made
  surface::Admission admission;         ///< its surface is empty where `wall` has all of it
  surface::OpenWall wall;               ///< without the sides on which layers land, with the far field
  IdVector<FaceId, FaceId> input_face;  ///< (n_faces) number in the file; invalid for what was made
  mesh::Topology topology;
  surface::Features features;
  IdVector<FaceId, char> is_wetted;  ///< (n_faces)
  bool fluid_is_inside = false;      ///< the fluid does not reach infinity
  std::size_t n_merged_points = 0;   ///< by welding
  std::vector<std::string> notes;    ///< what was done to the sides

  const mesh::SurfaceMesh& surface() const { return wall.surface; }
};

/// Reads, scales and welds: the surface as it is inspected. \param n_read  where given: number of points in the file
mesh::SurfaceMesh read_wall(const Case& settings, ProgressSink& progress, std::size_t* n_read = nullptr);

/// All that comes before growing: admission, sides and far field, features.
/// \throws SurfaceRejected, GeometryError (sides that do not close), InputError, IoError
Prepared prepare(const Case& settings, ProgressSink& progress);

}  // namespace nearwall::pipeline

#pragma once

#include <vector>

#include "nearwall/io/polydata_writer.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/surface/admission.h"

namespace nearwall::pipeline {

/// The triangles concerned by faults, as `NAME-faults.vtp` and `check -o` show them. A triangle comes once for each of
/// its faults; the cell array `Fault` counts through the field data `FaultNames`, one for each fault in their order.
/// \param surface  as inspected
io::PolyDataFile faults_file(const mesh::SurfaceMesh& surface, const std::vector<surface::Fault>& faults);

}  // namespace nearwall::pipeline

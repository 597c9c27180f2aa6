#pragma once

#include "nearwall/io/polydata_writer.h"
#include "nearwall/layers/grow.h"
#include "nearwall/quality/coverage.h"
#include "nearwall/surface/admission.h"

namespace nearwall::pipeline {

/// NAME-surface.vtp: the wall with all its arrays and the ridges as lines.
io::PolyDataFile surface_file(const layers::Wall& wall, const layers::Growth& growth,
                              const IdVector<FaceId, quality::FaceCoverage>& coverage,
                              const IdVector<FaceId, FaceId>& input_face);

/// NAME-front.vtp: the outer front.
io::PolyDataFile front_file(const layers::Wall& wall, const layers::Growth& growth);

/// NAME-faults.vtp: the triangles concerned by any fault, with the number of its kind. \param surface  as inspected
io::PolyDataFile faults_file(const mesh::SurfaceMesh& surface, const std::vector<surface::Fault>& faults);

}  // namespace nearwall::pipeline

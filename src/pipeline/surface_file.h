#pragma once

#include "nearwall/io/polydata_writer.h"
#include "nearwall/layers/grow.h"
#include "nearwall/quality/coverage.h"

namespace nearwall::pipeline {

/// NAME-surface.vtp: the wall with all its arrays and the ridges as lines.
/// \param is_shown  (n_faces) 0: left out, as far fields are; empty: all
io::PolyDataFile surface_file(const layers::Wall& wall, const layers::Growth& growth,
                              const IdVector<FaceId, quality::FaceCoverage>& coverage,
                              const IdVector<FaceId, FaceId>& input_face, const IdVector<FaceId, char>& is_shown = {});

/// NAME-front.vtp: the outer front.
io::PolyDataFile front_file(const layers::Wall& wall, const layers::Growth& growth,
                            const IdVector<FaceId, char>& is_shown = {});

}  // namespace nearwall::pipeline

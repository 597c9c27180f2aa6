#pragma once

#include "nearwall/layers/grow.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/pipeline/report.h"
#include "nearwall/quality/coverage.h"
#include "pipeline/output_directory.h"
#include "pipeline/prepare.h"

namespace nearwall::pipeline {

/// What the files are written from.
struct Result {
  const Prepared& prepared;
  const layers::Wall& wall;
  const layers::Growth& growth;
  const mesh::LayerMesh& layers;
  const IdVector<FaceId, quality::FaceCoverage>& coverage;
};

/// NAME.vtu, NAME-surface.vtp and NAME-front.vtp, aside. \throws IoError, Interrupted
void write_meshes(const Result& result, const std::string& name, OutputDirectory& output, ProgressSink& progress);

/// The pictures, aside; where none can be made a note says so. \returns those that were made
std::vector<Picture> make_pictures(const Result& result, const std::string& name, OutputDirectory& output,
                                   ProgressSink& progress);

}  // namespace nearwall::pipeline

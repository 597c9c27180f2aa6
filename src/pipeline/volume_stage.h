#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "nearwall/certify/certificate.h"
#include "nearwall/io/polydata_writer.h"
#include "nearwall/mesh/layer_mesh.h"
#include "nearwall/volume/domain_boundary.h"
#include "nearwall/volume/fill.h"
#include "nearwall/volume/fill_quality.h"
#include "pipeline/prepare.h"

namespace nearwall::pipeline {

/// What fills the domain beside the layers.
struct Volume {
  volume::RestBoundary rest;
  volume::Fill fill;
  volume::DomainBoundary boundary;
  volume::DomainCertificate certificate;
  volume::FillQuality quality;
};

/// Why there is no volume.
struct VolumeFailure {
  std::string reason;
  volume::RestBoundary rest;
  std::vector<std::uint32_t> triangles;  ///< of the rest's boundary, those concerned; empty if it is not known which
};

/// Fills what the layers leave and certifies the whole.
/// \param layers_volume  of all cells of the layers
/// \returns  a volume, or else why it could not be made
/// \throws Interrupted, InternalError if the whole could not be certified
std::variant<Volume, VolumeFailure> fill_volume(const Prepared& prepared, const certify::CertifiedWall& wall,
                                                const mesh::LayerMesh& layers, const mesh::MeshSource& source,
                                                double layers_volume, ProgressSink& progress);

/// Patch of a face on a plane at a place: that of the face of the surface that was there.
volume::PatchOnPlane patches_on_planes(const Prepared& prepared);

/// The triangles that keep the rest from being filled.
io::PolyDataFile fill_faults_file(const VolumeFailure& failure);

}  // namespace nearwall::pipeline

#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "nearwall/certify/mesh_certificate.h"
#include "nearwall/certify/wall_match.h"
#include "nearwall/core/id_vector.h"
#include "nearwall/io/volume_reader.h"
#include "nearwall/mesh/surface_mesh.h"
#include "nearwall/quality/wall_layers.h"

namespace nearwall::program {

/// The layers on a wall, as `certify --wall` reports them.
struct WallReport {
  std::string file;
  mesh::SurfaceMesh surface;
  certify::WallMatch match;
  IdVector<PatchId, quality::WallPatchLayers> patches;
  std::optional<double> asked_first_height;  ///< [length]
  std::optional<std::uint32_t> asked_count;
};

/// What `certify` has to tell.
struct CertifyReport {
  std::string file;
  const io::VolumeFile& volume;
  const certify::MeshCertificate& certificate;
  const std::optional<WallReport>& wall;
  std::size_t n_offenders;  ///< of each kind, to be named one by one
};

nlohmann::json json_of(const CertifyReport& report);

/// The verdict for reading: counts, what is wrong and where, what to do, the layers on the wall.
std::string text_of(const CertifyReport& report);

/// Middle of a cell's or face's corners.
Vec3 centre_of_cell(const mesh::VolumeMesh& mesh, std::uint64_t cell);
Vec3 centre_of_face(const mesh::VolumeMesh& mesh, mesh::FaceName face);

}  // namespace nearwall::program

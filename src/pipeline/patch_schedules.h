#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nearwall/pipeline/case.h"

namespace nearwall::pipeline {

/// What the heights of a patch may depend on besides its settings.
struct PatchVertices {
  const mesh::SurfaceMesh& surface;                     ///< with the point arrays of the case
  const std::vector<std::string>& arrays;               ///< their names
  const IdVector<VertexId, double>& isotropic_heights;  ///< (n_vertices); empty if no patch needs them
  std::span<const VertexId> vertices;  ///< of the patch and those alike; empty if its heights do not depend on them
};

/// Where settings stand in the case file, for messages.
std::string place_of(const Case& settings, const LayerSettings& layers);

/// Whether the heights of a patch depend on its vertices.
bool needs_vertices(const LayerSettings& layers);

/// Heights of a patch: `schedule`, `first_height`, `total_thickness`, `is_until_isotropic` and `largest_thickness`.
/// \param table  what the settings belong to, for messages
/// \throws InputError with the place in the case file
void set_schedule(const Case& settings, const LayerSettings& layers, const std::string& table,
                  const PatchVertices& patch, PatchSettings& to);

/// Checks what does not depend on the surface. \throws InputError with the place in the case file
void check_schedule(const Case& settings, const LayerSettings& layers, const std::string& table);

}  // namespace nearwall::pipeline

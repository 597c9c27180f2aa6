#pragma once

#include <span>
#include <string>
#include <vector>

#include "nearwall/pipeline/case.h"
#include "pipeline/patch_schedules.h"

namespace nearwall::pipeline {

/// What a patch asks for and cannot have whatever the room: layers thinner than their count of first heights, first
/// layers that are higher than isotropic ones, layers that end before they are isotropic. Each with the share of the
/// area and the worst place.
/// \param settings  with the schedule and the lengths of the patch
/// \param faces     of the patch
std::vector<std::string> length_warnings(const PatchSettings& settings, const PatchVertices& patch,
                                         std::span<const FaceId> faces);

}  // namespace nearwall::pipeline

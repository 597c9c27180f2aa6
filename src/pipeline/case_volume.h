#pragma once

#include <span>

#include "pipeline/case_document.h"
#include "pipeline/case_keys.h"

namespace nearwall::pipeline {

/// The value of volume.symmetry: "y", { axis = "y", at = 0.0 } in a list, or a list of these. \throws InputError
std::vector<SymmetrySetting> checked_planes(const Entry& entry, const Key& key);

/// Checks that the settings of [volume] agree with each other, with the fluid's side and with the types of patches.
/// \param entries  that they were read from, for places. \throws InputError
void check_volume(const Case& settings, std::span<const Entry> entries);

}  // namespace nearwall::pipeline

#pragma once

#include "nearwall/pipeline/case.h"

namespace nearwall::pipeline {

/// Checks what can be checked before the surface is known: heights are given somewhere, [layers] alone makes no
/// contradiction, y_plus comes with [flow]. \throws InputError
void check_heights(const Case& settings);

/// What is in force on one patch before its surface is looked at.
struct PatchLayers {
  PatchType type = PatchType::Wall;
  LayerSettings layers;
};

/// The settings of [layers] and of all rules that match, put together. \throws InputError if a rule matches no patch
std::vector<PatchLayers> settings_of_patches(const Case& settings, std::span<const std::string> patch_names);

/// The surface as in its file, with the point arrays that the case names. \throws what reading throws; where an array
/// is missing with the keys that ask for it
mesh::SurfaceMesh read_with_lengths(const Case& settings);

}  // namespace nearwall::pipeline

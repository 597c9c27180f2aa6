#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "nearwall/mesh/boundary.h"

namespace nearwall::io {

/// Names of patches as `fit` makes them. Those that it leaves as they are stay so; others get a number behind them
/// where another patch has that name, or it is reserved.
IdVector<PatchId, std::string> unique_names(const IdVector<PatchId, mesh::BoundaryPatch>& patches,
                                            const std::function<std::string(std::string_view)>& fit,
                                            std::span<const std::string_view> reserved);

/// Names of patches as single words, for formats whose names end at a blank or have other characters that mean
/// something: blanks, controls and the forbidden characters become '_', an empty name `patch`; made unique.
IdVector<PatchId, std::string> patch_words(const IdVector<PatchId, mesh::BoundaryPatch>& patches,
                                           std::string_view forbidden, std::span<const std::string_view> reserved);

/// The face counterclockwise seen from inside the mesh, for formats that have them so; it begins with the same node.
mesh::BoundaryFace seen_from_inside(const mesh::BoundaryFace& face);

}  // namespace nearwall::io

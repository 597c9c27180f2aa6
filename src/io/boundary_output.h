#pragma once

#include <span>
#include <string>
#include <string_view>

#include "nearwall/mesh/boundary.h"

namespace nearwall::io {

/// Names of patches as single words, for formats whose names end at a blank or have other characters that mean
/// something: blanks, controls and the forbidden characters become '_', an empty name `patch`. Names that are fit stay
/// as they are; those that are not get a number behind them where another patch has that word, or it is reserved.
IdVector<PatchId, std::string> patch_words(const IdVector<PatchId, mesh::BoundaryPatch>& patches,
                                           std::string_view forbidden, std::span<const std::string_view> reserved);

/// The face counterclockwise seen from inside the mesh, for formats that have them so; it begins with the same node.
mesh::BoundaryFace seen_from_inside(const mesh::BoundaryFace& face);

}  // namespace nearwall::io

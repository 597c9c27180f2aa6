#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace nearwall::mesh {

/// Why a line, or a wall triangle, has less than was asked. The numbers are those of the output files.
enum class LimitReason : std::uint8_t {
  None = 0,
  Visibility = 1,    ///< no direction sees all faces round the vertex
  Curvature = 2,     ///< neighbouring lines would cross (closed form)
  Gap = 3,           ///< another wall is near
  Neighbour = 4,     ///< graded down to a limited neighbour
  Quality = 5,       ///< a cell was not positive, or too thin to be resolved in doubles
  PatchEdge = 6,     ///< edge of a patch without layers
  Intersection = 7,  ///< the front would have met itself
  Isotropic = 8,     ///< asked: the layer is as high as its triangles are wide
};

inline constexpr std::size_t kNLimitReasons = 9;
inline constexpr std::array<std::string_view, kNLimitReasons> kLimitReasonNames = {
    "none", "visibility", "curvature", "gap", "neighbour", "quality", "patch-edge", "intersection", "isotropic"};

}  // namespace nearwall::mesh

#pragma once

#include <functional>

#include "nearwall/predicates/intersection.h"
#include "nearwall/predicates/orientation.h"

namespace nearwall::predicates {

/// Volume within a closed surface.
struct EnclosedVolume {
  Sign sign = Sign::Zero;  ///< exact: positive if the normals of the surface point outward
  double value = 0;        ///< [length³], in doubles
};

/// Volume within the closed surface of `n_triangles` triangles, triangle(0) … triangle(n_triangles − 1): doubles with
/// an error bound first, exact where that leaves the sign open. \throws InputError  if a coordinate is not finite.
/// Cost: O(n_triangles) Source: docs/theory/predicates.md, Eq. (12).
EnclosedVolume enclosed_volume(std::size_t n_triangles, const std::function<Triangle(std::size_t)>& triangle);

}  // namespace nearwall::predicates

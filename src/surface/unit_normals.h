#pragma once

#include <fmt/format.h>

#include <span>

#include "nearwall/core/errors.h"
#include "surface/normals_cap.h"

namespace nearwall::surface {

/// Calls `take(normal, unit)` for each normal that is not zero, of any length, with the unit vector along it.
/// \param caller  function that the normals were given to
/// \throws InputError if a normal is not finite
template <class Take>
void for_each_unit_normal(const char* caller, std::span<const Vec3> normals, const Take& take) {
  for (const Vec3& normal : normals) {
    if (!is_finite(normal)) {
      throw InputError(fmt::format("{}: expected finite normals, found ({}, {}, {}) at place {}", caller, normal.x(),
                                   normal.y(), normal.z(), &normal - normals.data()));
    }
    if (max_norm(normal) > 0) take(normal, unit_vector(normal));
  }
}

}  // namespace nearwall::surface

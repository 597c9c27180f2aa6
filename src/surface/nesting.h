#pragma once

#include <span>

#include "nearwall/surface/admission.h"

namespace nearwall::surface {

/// Depth of each component among the others, for a surface whose components are closed and embedded. Exact: a ray from
/// one point of each component, its crossings with every other component counted.
/// \param is_flat     (n_faces) triangles that do not count: those without area, and copies
/// \param components  the depths are filled in
/// Cost: O(n log n + crossings)
void find_nesting(const mesh::SurfaceMesh& surface, const IdVector<FaceId, ComponentId>& face_component,
                  std::span<const char> is_flat, IdVector<ComponentId, Component>& components);

}  // namespace nearwall::surface

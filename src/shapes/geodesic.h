#pragma once

#include <string_view>

#include "shapes/surface_builder.h"

namespace nearwall::shapes {

/// Number of pieces into which each edge of an icosahedron is cut for edges of about `size` on a sphere.
int geodesic_frequency(double radius, double size);

/// A sphere as an icosahedron whose faces are cut into frequency² triangles each, 20 frequency² in all, laid out along
/// great arcs. If `is_cavity` its normals point to the centre.
void add_sphere(SurfaceBuilder& builder, std::string_view patch, const Vec3& centre, double radius, int frequency,
                bool is_cavity = false);

}  // namespace nearwall::shapes

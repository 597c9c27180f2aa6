#pragma once

#include <array>

#include "nearwall/core/vec3.h"

namespace nearwall::predicates {

/// Three corners. One without area counts as the segment or point that it is.
using Triangle = std::array<Vec3, 3>;

/// Whether two closed triangles without a common corner have a point in common. Exact; touching counts.
bool triangles_intersect(const Triangle& a, const Triangle& b);

/// Whether the closed segment from p to q has a point in common with the closed triangle. Exact.
bool segment_intersects_triangle(const Vec3& p, const Vec3& q, const Triangle& t);

/// Whether two triangles that share the corner a[0] = b[0] meet anywhere else. Exact.
bool triangles_intersect_beyond_vertex(const Triangle& a, const Triangle& b);

/// Whether two triangles that share the edge a[0] = b[0], a[1] = b[1] meet anywhere else (folded flat upon each other).
/// Exact.
bool triangles_overlap_beyond_edge(const Triangle& a, const Triangle& b);

/// How a ray from `origin` through `through` (and on) meets a triangle.
enum class RayCrossing { None, Along, Against, Degenerate };

/// Exact crossing of an unbounded ray with a triangle: Along if the ray runs to the side of the triangle's normal,
/// Against if it comes from there; Degenerate if it meets an edge or a corner, runs in the plane, or starts on the
/// triangle. The ray's two points differ.
RayCrossing ray_crossing(const Vec3& origin, const Vec3& through, const Triangle& t);

}  // namespace nearwall::predicates

#pragma once

#include "nearwall/predicates/intersection.h"

/// The questions of intersection.h for the cases in which points lie in the planes of the triangles.
namespace nearwall::predicates::exact {

bool triangles_intersect(const Triangle& a, const Triangle& b);
bool segment_intersects_triangle(const Vec3& p, const Vec3& q, const Triangle& t);
bool triangles_intersect_beyond_vertex(const Triangle& a, const Triangle& b);
bool triangles_overlap_beyond_edge(const Triangle& a, const Triangle& b);

}  // namespace nearwall::predicates::exact

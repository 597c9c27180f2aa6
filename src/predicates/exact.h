#pragma once

#include <span>

#include "nearwall/predicates/cells.h"
#include "nearwall/predicates/orientation.h"
#include "nearwall/predicates/volume.h"

/// The same questions in exact arithmetic: what the public predicates ask when doubles leave the answer open.
/// All throw InputError if a coordinate is not finite, except the cells, which are then not positive.
namespace nearwall::predicates::exact {

Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
Sign determinant(const Vec3& a, const Vec3& b, const Vec3& c);
Sign dot(const Vec3& a, const Vec3& b);
Sign same_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c);
Positivity wedge(std::span<const Vec3, 6> p);
Positivity hexahedron(std::span<const Vec3, 8> p);
Sign enclosed_volume(std::size_t n_triangles, const std::function<Triangle(std::size_t)>& triangle);

}  // namespace nearwall::predicates::exact

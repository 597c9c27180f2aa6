#pragma once

#include <vector>

#include "nearwall/core/vec3.h"
#include "nearwall/geometry/box.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::volume {

enum class FarFieldShape { Sphere, Box };

/// The domain lies on one side of a plane normal to a coordinate axis.
struct SymmetryPlane {
  int axis = 1;         ///< 0, 1, 2 for x, y, z
  double position = 0;  ///< coordinate of the plane [length]
  int side = 1;         ///< > 0: the domain has coordinates >= position, < 0: <= position
};

/// The outer boundary of an external flow.
struct FarField {
  FarFieldShape shape = FarFieldShape::Sphere;
  Vec3 centre;                        ///< of the sphere [length]; it lies on all planes
  double radius = 0;                  ///< of the sphere [length]
  geometry::Box box;                  ///< of a box: it reaches up to the planes or beyond, and is cut there
  double size = 0;                    ///< edge length of the triangles [length], > 0
  std::vector<SymmetryPlane> planes;  ///< of different axes, or for a box two opposite ones of an axis
};

/// The far field without what the symmetry planes cut off and without the planes themselves: closed if there are none,
/// else open, with its boundary on the planes bit for bit (where two planes meet, on both). Normals point into the
/// domain.
///
/// A sphere is an octahedron whose faces are cut into f² triangles each, laid out along great arcs, so halves,
/// quarters and an eighth are whole faces of it; its patch is farfield. A box has rows of right-angled triangles with
/// legs no longer than `size` and patches farfield-x-min … farfield-z-max, without the sides cut off. Where `size` is
/// too large for the shape a smaller one is taken: a great circle keeps 12 edges, the shortest edge of a box 2.
/// Equal arguments give equal bits; scaling all lengths by a power of two scales the points by exactly that.
/// \throws InputError for lengths that are not positive or not finite, planes that repeat an axis or miss the box, a
///         sphere whose centre is not on them, or a size that would give more triangles than can be numbered
/// Cost: O(n log n) in the number of triangles.
mesh::SurfaceMesh far_field_surface(const FarField& far_field);

}  // namespace nearwall::volume

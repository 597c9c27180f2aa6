#pragma once

#include <array>
#include <string>
#include <vector>

#include "nearwall/core/id_vector.h"
#include "nearwall/core/ids.h"
#include "nearwall/core/vec3.h"

namespace nearwall::mesh {

/// A number at each point of a surface.
struct PointArray {
  std::string name;
  IdVector<VertexId, double> values;  ///< (n_points)
};

/// A triangulated surface with named patches. It may be a soup with holes as read from a file: what closes, orients and
/// admits it is `surface::admit`.
struct SurfaceMesh {
  IdVector<VertexId, Vec3> points;
  IdVector<FaceId, std::array<VertexId, 3>> faces;  ///< counterclockwise seen from the side the normal points to
  IdVector<FaceId, PatchId> face_patch;             ///< (n_faces)
  IdVector<PatchId, std::string> patch_names;       ///< unique names, in the order of the file
  std::vector<PointArray> point_arrays;             ///< those asked for on reading; they follow their points

  std::array<Vec3, 3> triangle(FaceId f) const {
    const auto& v = faces[f];
    return {points[v[0]], points[v[1]], points[v[2]]};
  }
};

}  // namespace nearwall::mesh

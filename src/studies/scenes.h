#pragma once

#include <string>

#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::studies {

/// Several bodies of the catalogue beside each other as one surface.
struct Scene {
  std::string name;
  std::string contents;  ///< one line
  mesh::SurfaceMesh mesh;
};

/// A wing on a fuselage and ten stars, some 121,000 points: convex and concave ridges that meet at corners, a tenth of
/// all points on them.
Scene flyer_scene();

/// An Ahmed body on its stilts and eighteen blocks on floors, some 109,000 points.
Scene block_scene();

}  // namespace nearwall::studies

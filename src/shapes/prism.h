#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shapes/surface_builder.h"

namespace nearwall::shapes {

/// A corner of a prism's polygon in the (x, z) plane, with the patch of the side from it to the next corner.
struct PrismCorner {
  double x = 0;
  double z = 0;
  std::string side;
};

/// Adds a flat face with straight edges between corners, counterclockwise seen from outside. Faces of a builder that
/// have two corners in common share the points between them.
void add_flat_face(SurfaceBuilder& builder, std::string_view patch, const std::vector<VertexId>& corners, double size);

/// Adds the closed prism over a polygon (counterclockwise seen along +y), from y = low to y = high.
void add_prism(SurfaceBuilder& builder, const std::vector<PrismCorner>& polygon, double low, double high,
               std::string_view low_patch, std::string_view high_patch, double size);

/// Adds a closed box with the patches PREFIXx-min … PREFIXz-max.
void add_box(SurfaceBuilder& builder, const Vec3& low, const Vec3& high, const std::string& prefix, double size);

}  // namespace nearwall::shapes

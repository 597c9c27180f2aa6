#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "nearwall/geometry/angles.h"
#include "nearwall/geometry/measures.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::shapes {

inline double volume(const mesh::SurfaceMesh& s) {
  geometry::CompensatedSum sum;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    sum.add(dot(a, cross(b, c)) / 6);
  }
  return sum.value();
}

inline double patch_area(const mesh::SurfaceMesh& s, std::string_view patch) {
  geometry::CompensatedSum sum;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    if (s.patch_names[s.face_patch[f]] == patch) sum.add(geometry::triangle_area(a, b, c));
  }
  return sum.value();
}

inline double smallest_angle_deg(const mesh::SurfaceMesh& s) {
  double smallest = geometry::kPi;
  for (const FaceId f : s.faces.ids()) {
    const auto [a, b, c] = s.triangle(f);
    smallest = std::min(
        {smallest, geometry::corner_angle(a, b, c), geometry::corner_angle(b, c, a), geometry::corner_angle(c, a, b)});
  }
  return geometry::to_degrees(smallest);
}

inline long euler_characteristic(const mesh::SurfaceMesh& s) {
  return static_cast<long>(s.points.size()) - static_cast<long>(s.faces.size() / 2);
}

inline std::set<std::string> patches(const mesh::SurfaceMesh& s) {
  return {s.patch_names.begin(), s.patch_names.end()};
}

}  // namespace nearwall::shapes

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/cursor.h"
#include "nearwall/mesh/surface_mesh.h"

namespace nearwall::io {

/// Name of the patch of files that have none.
inline constexpr std::string_view kNamelessPatch = "surface";

/// Collects what a reader finds, checks it and triangulates its polygons.
class SurfaceBuilder {
 public:
  void reserve(std::size_t n_points, std::size_t n_faces);

  /// \throws GeometryError at `where` if a coordinate is not finite or there are more points than ids.
  VertexId add_point(const Vec3& point, const FilePosition& where);
  std::size_t n_points() const { return mesh_.points.size(); }

  /// Faces added from now on belong to the patch of that name, which is made unless it exists.
  void begin_patch(std::string_view name);

  /// \param corners  indices of points, 0-based, at least 3
  /// \throws GeometryError at `where` if the face cannot be used.
  void add_face(std::span<const std::int64_t> corners, const FilePosition& where);

  /// Number of triangles that the face last added became.
  std::size_t n_faces() const { return mesh_.faces.size(); }

  /// Gives patches by numbers of triangles (n_faces): names[number] where there is one, else "patch<number>", in the
  /// order of the numbers.
  void assign_patches(std::span<const std::int64_t> numbers, std::span<const std::string> names);

  /// The surface without patches that have no face. \throws GeometryError if there is no triangle.
  mesh::SurfaceMesh finish(const FilePosition& where);

 private:
  void add_triangle(const std::array<VertexId, 3>& corners, const FilePosition& where);

  mesh::SurfaceMesh mesh_;
  std::map<std::string, PatchId, std::less<>> patch_of_name_;
  PatchId patch_;
  std::vector<Vec3> polygon_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace nearwall::io

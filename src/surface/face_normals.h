#pragma once

#include <span>
#include <vector>

#include "nearwall/surface/features.h"

namespace nearwall::surface {

/// Vertices that one thread takes at a time.
inline constexpr std::size_t kVertexBlock = 4096;

/// Lists the unit normals of faces round one vertex after the other, in memory that is used again.
class FaceNormals {
 public:
  explicit FaceNormals(const Features& features) : features_(features) {}

  /// Normals of the faces of these halfedges, without faces without area; valid until the next call.
  std::span<const Vec3> of(std::span<const HalfedgeId> faces) {
    if (room_.size() < faces.size()) room_.resize(faces.size());
    std::size_t n = 0;
    for (const HalfedgeId h : faces) {
      const Vec3& normal = features_.face_normal[mesh::Topology::face(h)];
      room_[n] = normal;
      n += has_area(normal) ? 1 : 0;
    }
    return {room_.data(), n};
  }

  /// Whether a unit normal is that of a face with an area.
  static bool has_area(const Vec3& normal) { return squared_norm(normal) > 0; }

 private:
  const Features& features_;
  std::vector<Vec3> room_;
};

}  // namespace nearwall::surface
